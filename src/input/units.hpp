// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

#include <stdexcept>
#include <string>

namespace berm::input {

/// A text is no quantity of the dimension that is wanted. The message says which is, with two examples.
struct UnitError : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// The number in SI units that a text such as "20 mm", "35 deg" or "-50 gravity" stands for; a text without a unit is in SI units already.
/// si_unit is spelled as UDUNITS-2 does ("" = a bare number). Throws UnitError where the number, the unit or the dimension is wrong, where
/// the number is not finite, and for scales that do not begin at zero (degC). Units are those of UDUNITS-2, and deg.
Real to_si(const std::string& text, const std::string& si_unit);

/// A number in SI units, and the unit.
struct SiQuantity {
  Real value;
  std::string unit;  ///< "1" = a bare number
};

/// The same for a text whose dimension is not known before: in the SI unit of its own. Throws UnitError where there is no such unit.
SiQuantity to_si(const std::string& text);

/// Whether numbers in these units can be compared; "1" and "" are bare numbers.
bool same_dimension(const std::string& unit, const std::string& other);

/// The unit in space of a quantity that plane strain counts per metre run: N for N/m, kg for kg/m, kg m^2 for kg m; any other as it is.
const char* unit_in_space(const char* si_unit);

/// What a quantity in si_unit is, with two examples: `a length, such as "20 mm" or "0.8 m"`.
std::string wanted(const std::string& si_unit);

}  // namespace berm::input
