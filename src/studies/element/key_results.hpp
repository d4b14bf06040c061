// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "element/run_test.hpp"

namespace berm::element {

/// A number that a laboratory would report of a test.
struct KeyResult {
  std::string name;   ///< "q_peak"
  Real value;         ///< SI; NaN where the test does not show it
  std::string unit;   ///< as UDUNITS-2 spells it, "1" of a bare number
  std::string label;  ///< for people: "q, peak"
  std::string meaning;
  Real per_si;  ///< shown number over the SI number
  std::string shown_unit;

  /// "q, peak (kPa)".
  std::string heading() const;
  /// Four digits that count in the unit that is shown; a dash for NaN.
  std::string shown() const;
};

/// The key results of a test; none of one that failed in its first step.
std::vector<KeyResult> key_results(const TestRecord& record);

}  // namespace berm::element
