// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "expectations/expectation.hpp"

#include <functional>

namespace berm::expectations {

enum class Verdict { met, missed, failed, not_run };

/// What came of one expectation: its numbers as text for tables, and the verdict.
struct ExpectationResult {
  std::string problem;  ///< EXAMPLE/RUN, or EXAMPLE/RUN .. RUN
  std::string what, exact, berm, error, tolerance;
  Verdict verdict = Verdict::not_run;
  std::string reason;        ///< why there is no number
  std::vector<Real> values;  ///< of its runs; empty where one has none
  std::string unit, label;   ///< of the values: SI, "" = a bare number; and what they are
  Real number = nan;
  std::optional<run_folder::Band> band;  ///< where one is expected; then the number is the converged one, and berm "16.9 kN/m (run 17.6)"
};

/// "met", "MISSED", "FAILED", "not run".
const char* word_of(Verdict verdict);

/// Where the numbers of the runs of an expectation are, by the runs' names in expected.toml; both throw where there is none.
struct NumbersOfRuns {
  std::function<Reading(const std::string& run, const Observable& observable)> reading;
  std::function<run_folder::Band(const std::string& run, const std::string& quantity)> band;
};

/// Compares what an expectation wants with what its runs gave. Never throws for want of a number: then the verdict is `failed`, with the reason.
ExpectationResult compare_with_numbers(const Expectation& e, const NumbersOfRuns& numbers);

/// The same of runs that gave nothing: what is expected of them.
ExpectationResult without_numbers(const Expectation& e, Verdict verdict, const std::string& reason);

/// A number (SI) in the unit in which those of an expectation are easiest to read.
std::string shown(const Expectation& e, Real value, const std::string& unit, int digits);

/// The band of a quantity. Throws InputError where there is none.
run_folder::Band band_of(const std::string& quantity, const std::optional<run_folder::RunSummary>& summary);

}  // namespace berm::expectations
