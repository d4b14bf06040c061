// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"
#include "jobs/outcome.hpp"
#include "settings/case.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace berm::jobs {

/// One run of a case by a process of its own.
struct Job {
  std::filesystem::path case_file;
  std::vector<std::string> set;  ///< overrides KEY=VALUE
  std::filesystem::path folder;  ///< the run folder
  Real estimate = nan;           ///< s of wall time, where no earlier run tells it
  bool uncertainty = false;      ///< with the bands of its results (berm run --uncertainty)
  std::string command = "run";   ///< of berm; others are of element tests ("element"), fits and storms
  bool resume = false;           ///< from its last checkpoint (berm run --resume), where it goes_on
  int threads = 1;               ///< of a run

  bool is_run() const { return command == "run"; }
};

/// The case with a mesh file that is found from any folder, where a job has a case file of its own.
settings::Case with_whole_paths(settings::Case settings, const std::filesystem::path& case_file);

/// What stands behind the program's name on the command line that does the job.
std::vector<std::string> words_of(const Job& job);

/// FOLDER.messages: what the process of the job writes to its standard output and error.
std::filesystem::path messages_of(const Job& job);

/// How a job ended that left this exit status, 128 + N after signal N: finished, interrupted, or failed for the reason in its last message.
JobEnd end_with(const Job& job, int status);

/// Whether the run folder holds a finished result of this case by this build of berm (run_folder::by_this_build), with its bands where they are asked for. A case is the
/// same where all of its parameters are, and the bytes of the files that it names.
bool has_result(const Job& job);

/// The same of a job that would be started next, if not. The messages that it wrote to the end after its parent was killed go.
bool has_ended_with_result(const Job& job);

/// Whether the run folder holds a run of this case, whoever computed it.
bool is_of_case(const Job& job);

/// Whether the run folder holds a run of this case by this build that ended on the way and left what `berm run --resume` goes on from. A run that was killed
/// before it wrote a summary does not tell its build; `berm run --resume` refuses the checkpoint of another version.
bool goes_on(const Job& job);

/// Wall time of the run in this folder and of the runs that its bands are made of, s, from its summary.json; NaN where there is none.
Real wall_time_of(const std::filesystem::path& folder);

/// Wall time that the job is expected to take, s: of a finished run in the same folder, else its estimate; less what it goes on from. NaN: not known.
Real expected_time(const Job& job);

/// The numbers of the jobs, the longest first, by expected_time; those of which it is not known come before them.
std::vector<std::size_t> by_time(const std::vector<Job>& jobs);

/// Where the results of these folders were computed on several vector units, which ones and on how many, in words; else "".
std::string mixed_vector_units(const std::vector<std::filesystem::path>& folders);

}  // namespace berm::jobs
