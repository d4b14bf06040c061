// SPDX-License-Identifier: BSD-3-Clause
#include "core/for_each_task.hpp"

#include <gtest/gtest.h>
#include <omp.h>

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

}  // namespace
}  // namespace berm::this_file
