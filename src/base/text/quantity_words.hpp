// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "os/numbers.hpp"

#include <string>

namespace berm::text {

/// Numbers for display, with four significant digits; "not known" for NaN.

/// A length in mm below a metre, else in m: "20 mm", "1.25 m".
std::string length_words(Real metres);
/// A unit, and its size in SI.
struct NamedUnit {
  Real size;
  const char* name;
};
/// The unit for forces per metre run (in space: forces) of up to `largest`, in tables and in sentences: N/m below 100 N/m,
/// kN/m, and MN/m from 10 MN/m on (N, kN, MN).
NamedUnit unit_of_forces(Real largest, int dimension);
/// A force in the unit of its size.
std::string force_words(Real newtons, int dimension);
/// A stress in Pa, kPa, MPa or GPa by its size.
std::string stress_words(Real pascals);
/// A unit weight in kN/m3.
std::string unit_weight_words(Real newtons_per_cubic_metre);
/// A time in us, ms, s or min by its size.
std::string time_words(Real seconds);
/// A speed in mm/s below a tenth of a metre a second, else in m/s.
std::string speed_words(Real metres_per_second);
/// An angle in degrees.
std::string angle_words(Real radians);
/// A fraction in per cent, with two significant digits.
std::string percent_words(Real part);
/// A bare number.
std::string number_words(Real value);
/// A whole number in groups of three digits; "not known" for NaN.
std::string count_words(Real value);

/// Stands in a table where there is no number.
constexpr const char* no_number = "–";

/// A number for a table: four digits that count, without an exponent in the range of engineering numbers; "–" where it is none.
std::string table_number(Real value);

/// A number for a sentence: three digits that count, without zeros at its end.
std::string short_number(Real value);

/// A number and its half width to as many decimals as this has with one digit that counts, two where the first is 1 or 2: "0.68 ± 0.05", "0.71 ± 0.12".
std::string with_half_width(Real value, Real half_width, const char* sign = "±");

}  // namespace berm::text
