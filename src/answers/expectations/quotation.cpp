// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/expectations/expectation_test.cpp
#include "expectations/quotation.hpp"

#include "input/units.hpp"
#include "os/error.hpp"

#include <cmath>
#include <fmt/format.h>
#include <regex>

namespace berm::expectations {
namespace {

int decimals_of(const std::string& number)
{
  const std::size_t point = number.find('.');
  return point == std::string::npos ? 0 : static_cast<int>(number.size() - point - 1);
}

}  // namespace

std::string Quotation::rounded(Real other) const
{
  const int decimals = decimals_of(number);
  return fmt::format("{:.{}f}", other / (last_digit * std::pow(10, decimals)), decimals);
}

Quotation quotation_of(const Expectation& e)
{
  static const std::regex pattern(R"(([^{}]*)\{([-+]?\d+(?:\.\d+)?)(?: ([^{}]+))?\}([^{}]*))");
  std::smatch found;
  if (!std::regex_match(e.quoted, found, pattern)) throw InputError("has no number in braces, as in \"breaks out with {0.92 kN/m}\"");
  Quotation quotation;
  quotation.before = found[1], quotation.number = found[2], quotation.unit = found[3], quotation.after = found[4];
  if (!quotation.unit.empty() && !e.quoted_unit.empty()) throw InputError("has a unit in its braces, and needs no quoted_unit");
  const std::string& unit = e.quoted_unit.empty() ? quotation.unit : e.quoted_unit;
  try {
    const input::SiQuantity value = input::to_si(quotation.number + " " + unit);
    quotation.value = value.value;
    quotation.si_unit = value.unit;
    quotation.last_digit = input::to_si(fmt::format("1e{} {}", -decimals_of(quotation.number), unit)).value;
  } catch (const input::UnitError& error) {
    throw InputError(error.what());
  }
  return quotation;
}

}  // namespace berm::expectations
