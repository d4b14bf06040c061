// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "input/structure_words.hpp"
#include "structures/penetration/penetrometer.hpp"

namespace berm::penetration {

#define BERM_NOT_HERE(...)
#define BERM_DECLARE(word, geometry) const Penetrometer& word();
BERM_STRUCTURES(BERM_DECLARE, BERM_NOT_HERE, BERM_NOT_HERE)
#undef BERM_DECLARE
#undef BERM_NOT_HERE

}  // namespace berm::penetration
