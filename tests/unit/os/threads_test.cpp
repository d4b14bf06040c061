// SPDX-License-Identifier: BSD-3-Clause
#include "os/threads.hpp"

#include <gtest/gtest.h>
#include <omp.h>
#include <optional>
#include <sched.h>

namespace berm::this_file {
namespace {

int processors_of_this_thread()
{
  cpu_set_t allowed;
  return sched_getaffinity(0, sizeof allowed, &allowed) == 0 ? CPU_COUNT(&allowed) : -1;
}

TEST(Threads, are_bound_while_they_are_needed_and_let_go_behind_that)
{
  const int all = processors_of_this_thread(), before = omp_get_max_threads();
  if (all < 2) GTEST_SKIP() << "one processor binds nothing";
  {
    const Threads threads(2);
    EXPECT_EQ(threads.count(), 2);
    EXPECT_EQ(omp_get_max_threads(), 2);
    if (std::getenv("OMP_PROC_BIND") == nullptr) {
      EXPECT_EQ(processors_of_this_thread(), 1);
    }
    EXPECT_EQ(processor_count(), all) << "binding a thread takes no processor from the process";
  }
  EXPECT_EQ(processors_of_this_thread(), all);
  EXPECT_EQ(omp_get_max_threads(), before);
}

TEST(Threads, are_as_many_as_the_environment_says_where_none_are_asked_for)
{
  const char* before = std::getenv("OMP_NUM_THREADS");
  const std::optional<std::string> kept = before == nullptr ? std::nullopt : std::optional<std::string>(before);
  for (const auto& [named, count] : {std::pair{"1", 1}, std::pair{"100000", processor_count()}, std::pair{"none", processor_count()}}) {
    setenv("OMP_NUM_THREADS", named, 1);
    EXPECT_EQ(usual_thread_count(), count) << named;
    EXPECT_EQ(Threads(0).count(), count) << named;
  }
  unsetenv("OMP_NUM_THREADS");
  EXPECT_EQ(usual_thread_count(), processor_count());
  if (kept) setenv("OMP_NUM_THREADS", kept->c_str(), 1);
}

TEST(Threads, give_the_caller_back_the_processors_that_it_had)
{
  const int all = processors_of_this_thread();
  if (all < 2) GTEST_SKIP() << "one processor binds nothing";
  cpu_set_t before, one;
  ASSERT_EQ(sched_getaffinity(0, sizeof before, &before), 0);
  {
    const Threads threads(2);
  }  // what the process may use is known from now on
  CPU_ZERO(&one);
  for (int p = 0; CPU_COUNT(&one) == 0; ++p)
    if (CPU_ISSET(p, &before)) CPU_SET(p, &one);
  ASSERT_EQ(sched_setaffinity(0, sizeof one, &one), 0);
  {
    const Threads threads(2);
  }
  EXPECT_EQ(processors_of_this_thread(), 1);
  sched_setaffinity(0, sizeof before, &before);
}

TEST(Threads, take_the_smallest_numbers_for_zero_while_they_live)
{
  volatile double tiny = 1e-310;
  {
    const Threads threads(1);
    EXPECT_EQ(tiny * 1., 0);
  }
  EXPECT_NE(tiny * 1., 0) << "the caller's arithmetic is as it was";
}

}  // namespace
}  // namespace berm::this_file
