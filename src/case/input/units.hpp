// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

#include <stdexcept>
#include <string>

namespace berm::input {

/// Thrown where a text is not a quantity of the expected dimension. The message names that dimension, with two examples.
struct UnitError : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// The number in SI units of a text such as "20 mm", "35 deg" or "-50 gravity"; a text without a unit is in SI units.
/// si_unit is spelled as UDUNITS-2 does ("" = dimensionless). Throws UnitError where the number, the unit or the dimension
/// is wrong, where the number is not finite, and for scales with an offset (degC). Units are those of UDUNITS-2, and deg.
Real to_si(const std::string& text, const std::string& si_unit);

/// A number in SI units, and the unit.
struct SiQuantity {
  Real value;
  std::string unit;  ///< "1" = dimensionless
};

/// The same for a text of unknown dimension, in the SI unit of its own. Throws UnitError where the unit is unknown.
SiQuantity to_si(const std::string& text);

/// Whether a text is a quantity.
bool is_quantity(const std::string& text);

/// Whether two units have the same dimension; "1" and "" are dimensionless.
bool same_dimension(const std::string& unit, const std::string& other);

/// The unit in space of a quantity that is per metre run in plane strain: N for N/m, kg for kg/m, kg m^2 for kg m; any other
/// unchanged.
const char* unit_of_whole(const char* si_unit);

/// The dimension of si_unit for messages, with two examples: `a length, such as "20 mm" or "0.8 m"`.
std::string wanted(const std::string& si_unit);

}  // namespace berm::input
