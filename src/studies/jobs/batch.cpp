// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/study/study_test.cpp
#include "jobs/batch.hpp"

#include "io/duration_text.hpp"
#include "io/tell.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::jobs {

using Kind = JobEnd::Kind;

std::size_t Batch::count(Kind kind) const
{
  return std::count_if(ends.begin(), ends.end(), [&](const JobEnd& end) { return end.kind == kind; });
}

Outcome Batch::outcome() const
{
  if (count(Kind::interrupted) + count(Kind::queued) > 0) return Outcome::unfinished;
  return count(Kind::failed) > 0 ? Outcome::failed : Outcome::done;
}

void run_batch(Batch& batch, const Runner& runner, const std::filesystem::path& queue)
{
  batch.ends.assign(batch.jobs.size(), {Kind::finished, ""});
  std::vector<Job> there, to_run;
  std::vector<std::size_t> numbers;  // in the batch, of the jobs to run
  for (std::size_t k = 0; k < batch.jobs.size(); ++k) {
    Job job = batch.jobs[k];
    if (batch.has_result(job)) {
      there.push_back(job);
      continue;
    }
    job.resume = goes_on(job);
    to_run.push_back(job);
    numbers.push_back(k);
  }
  if (batch.before)
    batch.before(there, to_run);
  else if (!there.empty())
    io::tell("{} of {} {} have their result already and are not run again\n", there.size(), batch.jobs.size(), batch.what);
  std::size_t done = 0;
  run_jobs(to_run, runner, queue, [&](std::size_t job, const JobEnd& end) {
    const std::size_t k = numbers[job];
    batch.ends[k] = end;
    if (batch.ended) return batch.ended(k, end);
    if (outcome_of(end.kind) == Outcome::unfinished) return;
    io::tell("{}/{} {}: {}\n", ++done, to_run.size(), batch.names[k],
             end.kind == Kind::failed ? "FAILED: " + end.reason : io::duration_text(wall_time_of(to_run[job].folder)));
  });
}

void tell_of_rest(const Batch& batch)
{
  const std::size_t all = batch.jobs.size(), interrupted = batch.count(Kind::interrupted), queued = batch.count(Kind::queued);
  const std::size_t done = all - interrupted - queued;
  if (interrupted > 0) io::tell("interrupted: {} of {} {} are done; the same command continues from there\n", done, all, batch.what);
  if (queued > 0) io::tell("queued: {} of {} {} are done; the same command collects the others\n", done, all, batch.what);
}

}  // namespace berm::jobs
