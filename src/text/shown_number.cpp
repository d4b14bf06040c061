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
  const int before = size > 0 ? static_cast<int>(std::floor(std::log10(size))) + 1 : 1;
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

}  // namespace berm::text
