// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/archive.hpp"
#include "fem/fem_problem.hpp"

namespace berm::fem {

/// The whole state, bit for bit. Reading puts it into one that was built for the same case. Throws RunError where elements, contact points or unknowns are
/// not as many, or where what is read cannot be a state of this model.
void archive(Archive& k, const FemModel& model, FemState& state);

}  // namespace berm::fem
