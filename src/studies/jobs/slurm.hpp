// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "jobs/jobs.hpp"

namespace berm::jobs {

/// The command by which sbatch gets a queue of `count` jobs as a job array; task.sh of the queue does them.
std::string sbatch_command(const Slurm& slurm, const std::filesystem::path& queue, std::size_t count);

/// The number of the job in what `sbatch --parsable` says, warnings or not; "" where there is none.
std::string job_number_in(const std::string& said);

}  // namespace berm::jobs
