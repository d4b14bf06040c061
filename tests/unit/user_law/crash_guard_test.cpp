// SPDX-License-Identifier: BSD-3-Clause
#include "user_law/crash_guard.hpp"

#include "samples/trial_law.hpp"

#include <csignal>
#include <gtest/gtest.h>
#include <thread>

namespace berm::user_law::this_file {
namespace {

using samples::trial_law;

class CrashGuardTest : public testing::Test {
protected:
  // A sanitizer's own threads do not survive a fork.
  void SetUp() override { GTEST_FLAG_SET(death_test_style, "threadsafe"); }
};

void call_once(const char* name)
{
  const LoadedLaw law = trial_law(name);
  material::UserIncrement increment;
  increment.state[0] = 0;
  law.advance(increment);
}

TEST_F(CrashGuardTest, a_law_that_crashes_ends_the_program_with_status_1_and_its_name)
{
  EXPECT_EXIT(call_once("uses_foreign_memory"), testing::ExitedWithCode(1),
              "berm: error: the law uses_foreign_memory crashed: it accessed invalid memory");
  EXPECT_EXIT(call_once("aborts"), testing::ExitedWithCode(1), "the law aborts crashed: it aborted");
  EXPECT_EXIT(call_once("divides_by_zero"), testing::ExitedWithCode(1), "the law divides_by_zero crashed: division of integers by zero");
}

TEST_F(CrashGuardTest, so_does_one_that_uses_up_the_stack_also_of_another_thread)
{
  EXPECT_EXIT(call_once("uses_up_the_stack"), testing::ExitedWithCode(1), "the law uses_up_the_stack crashed: .* overflowed the stack");
  EXPECT_EXIT(std::thread(call_once, "uses_up_the_stack").join(), testing::ExitedWithCode(1), "overflowed the stack");
}

TEST_F(CrashGuardTest, so_does_one_that_exits)
{
  EXPECT_EXIT(call_once("stops"), testing::ExitedWithCode(1), "the law stops ended the program");
}

TEST_F(CrashGuardTest, elsewhere_a_crash_is_one)
{
  const auto crash_beside = [] {
    const LoadedLaw law = trial_law("berm_law");
    std::raise(SIGABRT);
  };
  EXPECT_EXIT(crash_beside(), testing::KilledBySignal(SIGABRT), "");
}

TEST_F(CrashGuardTest, signals_are_as_before_once_no_law_is_loaded)
{
  struct sigaction before, during, after;
  ::sigaction(SIGSEGV, nullptr, &before);
  {
    const CrashGuard guard, second;
    ::sigaction(SIGSEGV, nullptr, &during);
  }
  ::sigaction(SIGSEGV, nullptr, &after);
  EXPECT_NE(during.sa_handler, before.sa_handler);
  EXPECT_EQ(after.sa_handler, before.sa_handler);
}

}  // namespace
}  // namespace berm::user_law::this_file
