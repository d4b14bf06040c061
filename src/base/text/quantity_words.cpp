// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/report/results/results_section_test.cpp
#include "text/quantity_words.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <vector>

namespace berm::text {
namespace {

/// A unit, and the value from which on it is used.
struct Unit {
  Real from, size;
  const char* name;
};

/// The last of the units that is not too large, the first for zero. Units are in order of size.
NamedUnit unit_of(Real value, const std::vector<Unit>& units)
{
  const Unit* chosen = units.data();
  if (value != 0)
    for (const Unit& unit : units)
      if (std::abs(value) >= unit.from * (1 - 1e-9)) chosen = &unit;
  return {chosen->size, chosen->name};
}

std::string in_unit(Real value, const NamedUnit& unit)
{
  return std::isnan(value) ? "not known" : fmt::format("{:.4g} {}", value / unit.size + 0., unit.name);
}

std::string scaled(Real value, const std::vector<Unit>& units)
{
  return in_unit(value, unit_of(value, units));
}

}  // namespace

std::string length_words(Real metres)
{
  return scaled(metres, {{0, 1e-3, "mm"}, {1, 1, "m"}});
}

NamedUnit unit_of_forces(Real largest, int dimension)
{
  return dimension == 2 ? unit_of(largest, {{0, 1, "N/m"}, {100, 1e3, "kN/m"}, {1e7, 1e6, "MN/m"}})
                        : unit_of(largest, {{0, 1, "N"}, {100, 1e3, "kN"}, {1e7, 1e6, "MN"}});
}

std::string force_words(Real newtons, int dimension)
{
  return in_unit(newtons, unit_of_forces(newtons, dimension));
}

std::string stress_words(Real pascals)
{
  return scaled(pascals, {{0, 1, "Pa"}, {1e3, 1e3, "kPa"}, {1e6, 1e6, "MPa"}, {1e9, 1e9, "GPa"}});
}

std::string unit_weight_words(Real newtons_per_cubic_metre)
{
  return scaled(newtons_per_cubic_metre, {{0, 1e3, "kN/m³"}});
}

std::string time_words(Real seconds)
{
  return scaled(seconds, {{0, 1e-6, "µs"}, {1e-3, 1e-3, "ms"}, {1, 1, "s"}, {60, 60, "min"}});
}

std::string speed_words(Real metres_per_second)
{
  return scaled(metres_per_second, {{0, 1e-3, "mm/s"}, {0.1, 1, "m/s"}});
}

std::string angle_words(Real radians)
{
  return std::isnan(radians) ? "not known" : fmt::format("{:.4g}°", radians * 180 / pi);
}

std::string percent_words(Real part)
{
  if (std::isnan(part)) return "not known";
  return std::abs(part) < 0.995 ? fmt::format("{:.2g} %", 100 * part) : fmt::format("{:.0f} %", 100 * part);
}

std::string number_words(Real value)
{
  return std::isnan(value) ? "not known" : fmt::format("{:.4g}", value);
}

std::string count_words(Real value)
{
  if (std::isnan(value)) return "not known";
  std::string digits = fmt::format("{:.0f}", value);
  const std::size_t first = digits[0] == '-' ? 1 : 0;
  for (std::size_t k = digits.size(); k > first + 3; k -= 3) digits.insert(k - 3, "\u00a0");
  return digits;
}

namespace {

/// Without an exponent in the range of engineering numbers.
std::string with_digits(Real value, int digits)
{
  const Real size = std::abs(value);
  if (size > 0 && (size < 1e-5 || size >= 1e7)) return fmt::format("{:.{}e}", value, digits - 1);
  const Real rounded = std::stod(fmt::format("{:.{}e}", size, digits - 1));  // 9.9999 has as many digits before the point as 10
  const int before = size > 0 ? static_cast<int>(std::floor(std::log10(rounded))) + 1 : 1;
  return fmt::format("{:.{}f}", value, std::max(0, digits - before));
}

}  // namespace

std::string table_number(Real value)
{
  return std::isfinite(value) ? with_digits(value, 4) : no_number;
}

std::string short_number(Real value)
{
  if (!std::isfinite(value)) return no_number;
  std::string text = with_digits(value, 3);
  if (text.find('.') == std::string::npos || text.find('e') != std::string::npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string with_half_width(Real value, Real half_width, const char* sign)
{
  if (!std::isfinite(value) || !std::isfinite(half_width)) return no_number;
  constexpr Real shown = 5e-5;  // of the value
  if (half_width <= shown * std::abs(value)) return fmt::format("{} {} 0", table_number(value), sign);
  const Real power = std::floor(std::log10(half_width));
  const bool two = half_width < 2.95 * std::pow(10, power);
  const int decimals = static_cast<int>(two ? 1 - power : -power);
  if (decimals > 9 || decimals < -6) return fmt::format("{:.3e} {} {:.1e}", value, sign, half_width);
  const Real unit = std::pow(10, -decimals);
  const auto rounded = [&](Real number) {
    return fmt::format("{:.{}f}", decimals < 0 ? std::round(number / unit) * unit : number, std::max(0, decimals));
  };
  return fmt::format("{} {} {}", rounded(value), sign, rounded(half_width));
}

}  // namespace berm::text
