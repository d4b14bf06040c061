// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "element/run_test.hpp"

namespace berm::element {

/// Writes the rows of a test as a history (run_folder/history.hpp): element.csv and element.schema.json beside it. The stage of a row is its leg of the path:
/// "leg 2", of several cycles "cycle 3 leg 2", "cycle 3 reconsolidation".
void write_rows(const TestRecord& record, const std::filesystem::path& file);

/// The key results of all tests of one kind that show the same.
struct ResultTable {
  std::string title;                           ///< "triaxial, undrained, total stress"
  std::vector<std::string> tests;              ///< the columns
  std::vector<std::vector<std::string>> rows;  ///< what is told, then a number for each test
};

/// One table for each kind; tests that failed in their first step are in none.
std::vector<ResultTable> result_tables(const std::vector<TestRecord>& records);

/// "triaxial, drained"; of a law of total stresses without pore pressures "triaxial, undrained, total stress".
std::string words_of_kind(const TestRecord& record);

/// "triaxial compression, drained, of sand from 100 kPa".
std::string words_of_test(const TestRecord& record);

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
