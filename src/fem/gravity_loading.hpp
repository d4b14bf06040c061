// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fem/fem_problem.hpp"

namespace berm::fem {

/// InitialState::gravity_loading for 6-node triangles: the points of integration get the stress with which the nodes are in equilibrium with gravity and the
/// supports of the first stage, soil being GroundElasticity. A hole is empty. The strength is not looked at. Throws InputError where supports do not hold
/// the soil.
void load_by_gravity(const problem::Case& c, const FemModel& model, FemState& state);

}  // namespace berm::fem
