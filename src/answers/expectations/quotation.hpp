// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "expectations/expectation.hpp"

namespace berm::expectations {

/// Text of a page that quotes a number of a run: "breaks out with {0.92 kN/m}".
struct Quotation {
  std::string before, number, unit, after;  ///< "breaks out with ", "0.92", "kN/m", ""
  Real value = nan, last_digit = nan;       ///< SI: the number, and one unit of its last digit
  std::string si_unit;                      ///< "1" = a bare number

  /// The text with another number, as the page has it and as expected.toml has it.
  std::string on_page(const std::string& other) const { return before + with_unit(other) + after; }
  std::string in_braces(const std::string& other) const { return before + "{" + with_unit(other) + "}" + after; }
  /// A number of a run (SI) in the page's unit, with as many decimals.
  std::string rounded(Real other) const;

private:
  std::string with_unit(const std::string& other) const { return other + (unit.empty() ? "" : " " + unit); }
};

/// Reads `quoted` and `quoted_unit`. Throws InputError where there is no number in braces, two units, or an unknown one.
Quotation quotation_of(const Expectation& e);

}  // namespace berm::expectations
