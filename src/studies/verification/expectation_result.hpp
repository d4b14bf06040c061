// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "expectations/expectation_result.hpp"
#include "jobs/jobs.hpp"
#include "verification/problems.hpp"

namespace berm::verification {

using expectations::ExpectationResult;
using expectations::Verdict;

/// What came of one problem.
struct ProblemResult {
  std::filesystem::path folder;  ///< the run folder
  jobs::JobEnd end;
};

/// Compares what an expectation wants with what its runs gave; `results` are of example.runs, in their order. Never throws for want of a result: then
/// the verdict is `failed` with the reason, or `not_run`.
ExpectationResult compare_with_expectation(const Example& example, const Expectation& e, const std::vector<ProblemResult>& results);

}  // namespace berm::verification
