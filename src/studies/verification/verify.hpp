// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "jobs/jobs.hpp"
#include "verification/problems.hpp"

namespace berm::verification {

/// What `berm verify` is asked to do.
struct VerifyRequest {
  ProblemChoice choice;
  std::filesystem::path output;  ///< folder of the book and of its runs
  jobs::Runner runner;
  bool anew = false;   ///< also what has its result already
  bool quote = false;  ///< update the numbers of the runs in the pages that quote them
};

/// Prints the problems that are wanted, with their titles and numbers of expectations. Throws InputError.
void list_problems(const ProblemChoice& choice);

/// Prints what the wanted problems promise, where it is derived and which runs prove it, with the last results of those that lie in OUTPUT. Throws
/// InputError.
void list_requirements(const ProblemChoice& choice, const std::filesystem::path& output);

/// Runs the problems that are wanted and have no result yet (jobs::has_result) into OUTPUT/EXAMPLE/RUN, the longest first, prints how their results compare with what is expected, and writes the verification
/// book, OUTPUT/index.html. Stopped, the same goes on from there. All input is read before the first run; a run that fails is a row that says so. Done where all runs finished and all
/// is as expected. Throws InputError and RunError.
jobs::Outcome verify(const VerifyRequest& request);

}  // namespace berm::verification
