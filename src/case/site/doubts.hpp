// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/site/doubts_test.cpp
// What of a sounding is doubted: each a sentence with its size, its depth and what to do.
#pragma once

#include "site/strength.hpp"

namespace berm::site {

/// Rows that are missing: a tenth of them or more left out, a gap at the seabed or between readings, an end above the base of the bed, which lies at a depth in m.
std::vector<std::string> doubts_of_rows(const Sounding& sounding, Real base);

/// Strength that soft to stiff clay does not have. Throws InputError where no clay has it, or where the sounding is of sand.
std::vector<std::string> doubts_of_clay(const Sounding& sounding, const StrengthProfile& s_u, Real submerged_unit_weight);

/// Resistance that sand does not have. Throws InputError where no soil has it.
std::vector<std::string> doubts_of_sand(const Sounding& sounding, const StrengthProfile& phi, Real submerged_unit_weight);

}  // namespace berm::site
