// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "element/run_test.hpp"

#include <filesystem>

namespace berm::element {

/// An input of berm element and what came of its tests.
struct ElementResults {
  std::filesystem::path case_file;
  ElementCase settings;
  std::vector<TestRecord> records;  ///< a test each
  Real wall_s = 0;                  ///< wall time of all
};

/// Whether the folder holds what write_results leaves. Throws InputError where it holds a run of berm run, which is never replaced.
bool holds_results(const std::filesystem::path& folder);

/// Whether it holds those of the same tests by this build of berm.
bool has_result(const ElementCase& settings, const std::filesystem::path& folder);

/// Writes TEST/element.csv and element.schema.json of each test, the figures (element_figures.hpp), summary.json, element.html, case.toml and resolved.toml. What
/// earlier tests left there is removed. Throws RunError.
void write_results(const ElementResults& results, const std::filesystem::path& folder);

/// The tables of key results for people, and the tests that failed.
std::string words_of_results(const std::vector<TestRecord>& records);

}  // namespace berm::element
