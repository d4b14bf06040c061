// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

#include <string>

namespace berm::text {

/// Stands in a table where there is no number.
constexpr const char* no_number = "–";

/// A number for a table: four digits that count, without an exponent in the range of engineering numbers; "–" where it is none.
std::string table_number(Real value);

/// A number for a sentence: three digits that count, without zeros at its end.
std::string short_number(Real value);

/// A number and its half width to as many decimals as this has with one digit that counts, two where the first is 1 or 2: "0.68 ± 0.05", "0.71 ± 0.12".
std::string with_half_width(Real value, Real half_width, const char* sign = "±");

}  // namespace berm::text
