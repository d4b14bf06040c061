// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mpm/grid.hpp"

namespace berm::mpm {

/// Steps 1 to 4 at the nodes of one body: force f = internal + m g + tractions, acceleration a = (f + damping) / m
/// (equations 3, 4), zero in fixed directions. Local damping opposes the velocity with a fraction of each component of the
/// unbalanced force, except at nodes near a contact, where it would replace part of the reaction. Adds to the totals of work
/// and impulse. Throws RunError where a velocity or an internal force is not finite, before anything has changed.
template <int dim>
void solve_momentum_balance(const problem::Model<dim>& model, problem::State<dim>& state, Workspace<dim>& workspace, Index body);

}  // namespace berm::mpm
