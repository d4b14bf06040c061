// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "jobs/jobs.hpp"
#include "run_folder/uncertainty.hpp"
#include "verification/problems.hpp"

namespace berm::verification {

/// What came of one problem.
struct ProblemResult {
  std::filesystem::path folder;  ///< the run folder
  jobs::JobEnd end;
};

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

/// Compares what an expectation wants with what its runs gave; `results` are of example.runs, in their order. Never throws for want of a result: then
/// the verdict is `failed` with the reason, or `not_run`.
ExpectationResult compare_with_expectation(const Example& example, const Expectation& e, const std::vector<ProblemResult>& results);

}  // namespace berm::verification
