// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/report/results/results_section_test.cpp
#include "text/shown_number.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::text {
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
  if (half_width == 0) return fmt::format("{} {} 0", short_number(value), sign);
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
