// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "jobs/jobs.hpp"

namespace berm::jobs {

/// Runs the jobs on this machine, at_once of their threads at a time, each by this program (run_jobs says the rest).
void run_processes(const std::vector<Job>& jobs, int at_once, const Ended& ended);

}  // namespace berm::jobs
