// SPDX-License-Identifier: BSD-3-Clause
#include "core/for_each_task.hpp"

#include <gtest/gtest.h>
#include <omp.h>
#include <stdexcept>
#include <string>

namespace berm::this_file {
namespace {

TEST(for_each_task, runs_every_task_once_on_any_number_of_threads)
{
  const int before = omp_get_max_threads();
  for (const int threads : {1, 3}) {
    omp_set_num_threads(threads);
    for (const Index count : {0, 1, 2, 50}) {
      std::vector<int> runs(count, 0);
      for_each_task("task", count, [&](Index k) { ++runs[k]; });
      EXPECT_EQ(runs, std::vector<int>(count, 1));
    }
  }
  omp_set_num_threads(before);
}

TEST(for_each_task, does_all_and_throws_what_the_first_of_those_that_fail_throws)
{
  const int before = omp_get_max_threads();
  for (const int threads : {1, 3}) {
    omp_set_num_threads(threads);
    std::vector<int> runs(50, 0);
    const auto task = [&](Index k) {
      ++runs[k];
      if (k % 20 == 7) throw std::runtime_error(std::to_string(k));
    };
    try {
      for_each_task("task", 50, task);
      FAIL() << "nothing was thrown";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "7");
    }
    EXPECT_EQ(runs, std::vector<int>(50, 1));
  }
  omp_set_num_threads(before);
}

}  // namespace
}  // namespace berm::this_file
