// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mpm/grid.hpp"

namespace berm::mpm {

/// Adds what each support gave to the soil in this step to State::support_impulses: at its nodes what holds them against all other forces (NodalSums::support of
/// the momentum balance), and against the impulses of contact points there. Together they are what Totals::support_impulse grows by, but for what no support
/// holds: an axis and planes of symmetry.
template <int dim>
void react_at_supports(const problem::Model<dim>& model, problem::State<dim>& state, const Workspace<dim>& workspace);

}  // namespace berm::mpm
