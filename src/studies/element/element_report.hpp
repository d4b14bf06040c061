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

/// Throws InputError where the folder holds something, and no element tests.
void refuse_other_files(const std::filesystem::path& folder);

/// Whether it holds those of the same tests by this build of berm.
bool has_result(const ElementCase& settings, const std::filesystem::path& folder);

/// Writes TEST/element.csv and element.schema.json of each test, the figures, summary.json, element.html, case.toml and resolved.toml. What
/// earlier tests left there is removed. Throws RunError.
void write_results(const ElementResults& results, const std::filesystem::path& folder);

/// The tables of key results for people, and the tests that failed.
std::string words_of_results(const std::vector<TestRecord>& records);

/// Draws FOLDER/KIND_WHAT.png with the curves of all tests of a kind over one another: stress over strain; the effective stress path with the strength of the
/// law; volumetric strain of drained and excess pore pressure of undrained tests; of oedometers the compression curve over the logarithm of the stress. Gives the
/// names of those that were drawn, without ".png".
std::vector<std::string> draw_figures(const std::vector<TestRecord>& records, const std::filesystem::path& folder);

/// The deviator stress q at which a law yields in the triaxial test at a mean stress p, Pa, compression positive; negative in extension. Empty where the law has
/// no strength of that form.
std::optional<Real> triaxial_strength(const TestRecord& record, Real p, Direction direction);

}  // namespace berm::element
