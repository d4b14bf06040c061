// SPDX-License-Identifier: BSD-3-Clause
#include "jobs/job.hpp"

#include "samples/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace berm::jobs::this_file {
namespace {

/// A run folder with a summary.
Job job_that_took(const TemporaryFolder& place, const std::string& name, Real wall, bool finished, Real estimate)
{
  std::filesystem::create_directories(place / name);
  place.write(name + "/summary.json", "{\"quantities\": {}, \"timing\": {\"wall_s\": " + std::to_string(wall) +
                                          "}, \"checks\": {\"finished\": " + (finished ? "true" : "false") + "}, \"text\": {}}");
  return {"case.toml", {}, place / name, estimate};
}

TEST(Job, takes_as_long_as_its_last_run_else_as_is_estimated)
{
  const TemporaryFolder place;
  EXPECT_EQ(expected_time(job_that_took(place, "finished", 40, true, 90)), 40);
  Job stopped = job_that_took(place, "stopped", 40, false, 90);
  EXPECT_EQ(expected_time(stopped), 90) << "it begins anew";
  stopped.resume = true;
  EXPECT_EQ(expected_time(stopped), 50);
  EXPECT_EQ(expected_time({"case.toml", {}, place / "none", 7}), 7);
  EXPECT_TRUE(std::isnan(expected_time({"case.toml", {}, place / "none"})));
}

TEST(Job, of_the_longest_time_comes_first_and_before_it_those_of_unknown_time)
{
  const TemporaryFolder place;
  const std::vector<Job> jobs = {{"case.toml", {}, place / "a", 5},
                                 job_that_took(place, "b", 40, true, 1),
                                 {"case.toml", {}, place / "c"},
                                 {"case.toml", {}, place / "d", 90}};
  EXPECT_EQ(by_time(jobs), (std::vector<std::size_t>{2, 3, 1, 0}));
}

}  // namespace
}  // namespace berm::jobs::this_file
