// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fem/fem_problem.hpp"

namespace berm::fem {

/// Initial stress by gravity loading (InitialState::gravity_loading) on 6-node triangles: the integration points get the
/// stress in equilibrium with gravity and the supports of the first stage for the elasticity GroundElasticity. Holes are
/// empty, the strength is ignored. Throws InputError where the supports do not hold the soil.
void load_by_gravity(const problem::Case& c, const FemModel& model, FemState& state);

}  // namespace berm::fem
