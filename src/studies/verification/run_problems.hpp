// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "verification/expectation_result.hpp"

namespace berm::verification {

/// The problems of the examples as jobs with run folders OUTPUT/EXAMPLE/RUN, in their order. Throws InputError where a case cannot be read.
std::vector<jobs::Job> jobs_of(const std::vector<Example>& examples, const std::filesystem::path& output);

/// Runs the jobs, but those that have their result already unless `anew`, the longest first, and tells on stderr how far they are and how long the rest takes. The
/// results, of finished jobs those of earlier commands, are in the order of the jobs. Throws RunError.
std::vector<ProblemResult> run_problems(std::vector<jobs::Job> jobs, const std::filesystem::path& output, const jobs::Runner& runner,
                                        bool anew);

}  // namespace berm::verification
