// SPDX-License-Identifier: BSD-3-Clause
#include "simulation/processor_clock.hpp"

#include <chrono>
#include <gtest/gtest.h>
#include <thread>

namespace berm::simulation::this_file {
namespace {

TEST(ProcessorClock, counts_work_of_this_thread_and_not_the_time_in_which_it_waits)
{
  using Clock = std::chrono::steady_clock;
  const ProcessorClock waits;
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  EXPECT_LT(waits.passed(), 0.1);
  const ProcessorClock works;
  const Clock::time_point begin = Clock::now();
  while (works.passed() < 0.05 && Clock::now() - begin < std::chrono::seconds(20)) {
  }
  EXPECT_GE(works.passed(), 0.05);
  EXPECT_LE(works.passed(), std::chrono::duration<Real>(Clock::now() - begin).count() + 1e-3);
}

}  // namespace
}  // namespace berm::simulation::this_file
