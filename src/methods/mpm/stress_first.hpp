// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mpm/grid.hpp"

namespace berm::mpm {

/// The step of contact::SchemeRules::stress_first (Bardenhagen and others 2000, 2001): stress comes first, from the corrected velocities before the step. Water does
/// not flow here.
template <int dim>
void update_stress_first(const problem::Model<dim>& model, problem::State<dim>& state, Workspace<dim>& workspace);

}  // namespace berm::mpm
