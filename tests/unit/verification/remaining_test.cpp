// SPDX-License-Identifier: BSD-3-Clause
#include "verification/remaining.hpp"

#include <gtest/gtest.h>

namespace berm::verification::this_file {
namespace {

std::vector<jobs::Job> jobs_that_take(const std::vector<Real>& times)
{
  std::vector<jobs::Job> jobs;
  for (const Real time : times) jobs.push_back({"case.toml", {}, "no folder", time});
  return jobs;
}

TEST(Remaining, is_the_time_until_the_last_of_the_workers_ends)
{
  const Remaining remaining(jobs_that_take({20, 100, 60, 30}), 2);
  EXPECT_EQ(remaining.running(), 2u);
  EXPECT_EQ(remaining.waiting(), 2u);
  EXPECT_DOUBLE_EQ(remaining.seconds(0), 110) << "100 beside 60 + 30, and 20";
  EXPECT_DOUBLE_EQ(remaining.seconds(40), 70);
  EXPECT_DOUBLE_EQ(Remaining(jobs_that_take({20, 100}), 8).seconds(0), 100);
}

TEST(Remaining, counts_what_has_ended_and_what_begins_then)
{
  Remaining remaining(jobs_that_take({20, 100, 60, 30}), 2);
  remaining.end(2, true, 60);
  EXPECT_EQ(remaining.running(), 2u);
  EXPECT_EQ(remaining.waiting(), 1u);
  EXPECT_DOUBLE_EQ(remaining.seconds(60), 50) << "40 left beside 30, and 20";
  for (const std::size_t job : {3, 1, 0}) remaining.end(job, true, 110);
  EXPECT_EQ(remaining.running(), 0u);
  EXPECT_EQ(remaining.seconds(110), 0);
}

TEST(Remaining, learns_from_finished_jobs_how_fast_the_machine_is_but_not_from_failed_ones)
{
  Remaining remaining(jobs_that_take({600, 600}), 1);
  remaining.end(0, true, 1260);
  EXPECT_DOUBLE_EQ(remaining.seconds(1260), 1200) << "twice as slow: (60 + 1260) / (60 + 600)";
  Remaining failing(jobs_that_take({600, 600}), 1);
  failing.end(0, false, 1);
  EXPECT_DOUBLE_EQ(failing.seconds(1), 600);
}

TEST(Remaining, takes_a_job_of_unknown_time_for_an_average_one)
{
  EXPECT_DOUBLE_EQ(Remaining(jobs_that_take({10, nan, 30}), 1).seconds(0), 60);
  EXPECT_TRUE(std::isnan(Remaining(jobs_that_take({nan, nan}), 1).seconds(0)));
}

}  // namespace
}  // namespace berm::verification::this_file
