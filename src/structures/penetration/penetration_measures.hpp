// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/penetration/reading.hpp"

namespace berm::penetration {

/// What is looked at in a run of a body that is pushed down: what any driven body has, whether the resistance is steady, and how far walls and base are.
base::TrustMeasures penetration_measures(const problem::Case& c, const Reading& reading);

}  // namespace berm::penetration
