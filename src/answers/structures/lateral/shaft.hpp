// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "input/structure_words.hpp"
#include "structures/penetration/penetrometer.hpp"

namespace berm::lateral {

#define BERM_NOT_HERE(...)
#define BERM_DECLARE(word, geometry) const penetration::Penetrometer& word();
BERM_STRUCTURES(BERM_NOT_HERE, BERM_DECLARE, BERM_NOT_HERE)
#undef BERM_DECLARE
#undef BERM_NOT_HERE

/// A body that may be pushed down and read as resistance over depth, and loaded sideways where it stands in the seabed. A run that does both has the results of both.
base::Structure shaft(const penetration::Penetrometer& how);

}  // namespace berm::lateral
