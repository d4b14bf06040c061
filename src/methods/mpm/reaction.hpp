// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mpm/grid.hpp"

namespace berm::mpm {

/// Adds the impulses of all points to the totals, and their opposites to the rigid bodies; and what the supports give where that is reported.
template <int dim>
void react(const problem::Model<dim>& model, problem::State<dim>& state, const Workspace<dim>& workspace);

/// The sum of the impulses of all points on the body, N s.
template <int dim>
Vec<dim> impulse_of(const contact::ContactPoints<dim>& points);

}  // namespace berm::mpm
