// SPDX-License-Identifier: BSD-3-Clause
#include "core/threads.hpp"

#include <gtest/gtest.h>
#include <sched.h>

namespace berm {
namespace {

int processors_of_this_thread()
{
  cpu_set_t allowed;
  return sched_getaffinity(0, sizeof allowed, &allowed) == 0 ? CPU_COUNT(&allowed) : -1;
}

TEST(Threads, that_were_bound_can_be_let_go_for_processes_that_inherit_where_they_may_run)
{
  const int all = processors_of_this_thread();
  if (all < 2) GTEST_SKIP() << "one processor binds nothing";
  use_threads(2);
  if (std::getenv("OMP_PROC_BIND") == nullptr) {
    EXPECT_EQ(processors_of_this_thread(), 1);
  }
  EXPECT_EQ(processor_count(), all) << "binding a thread takes no processor from the process";
  unbind_thread();
  EXPECT_EQ(processors_of_this_thread(), all);
  use_threads(1);
}

}  // namespace
}  // namespace berm
