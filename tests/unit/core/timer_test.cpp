// SPDX-License-Identifier: BSD-3-Clause
#include "core/for_each.hpp"
#include "core/timer.hpp"

#include <gtest/gtest.h>
#include <thread>

namespace berm::this_file {
namespace {

class Timers : public testing::Test {
protected:
  Timings timings_;
  Timings::Use use_{timings_};
};

void wait(int milliseconds)
{
  std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
}

TEST_F(Timers, add_up_under_their_label_in_order_of_first_use)
{
  for (int k = 0; k < 3; ++k) {
    {
      const Timer timer("first");
      wait(2);
    }
    {
      const Timer timer("second");
    }
  }
  const auto table = timings_.table();
  ASSERT_EQ(table.size(), 2u);
  EXPECT_EQ(table[0].label, "first");
  EXPECT_EQ(table[1].label, "second");
  EXPECT_EQ(table[0].calls, 3);
  EXPECT_EQ(table[1].calls, 3);
  EXPECT_GE(table[0].seconds, 0.006);  // a sleep is never shorter than asked for
  EXPECT_LT(table[1].seconds, table[0].seconds);
}

TEST_F(Timers, take_equal_words_for_one_label_wherever_they_are_stored)
{
  const std::string same_words = "loop";
  {
    const Timer timer("loop");
  }
  {
    const Timer timer(same_words.c_str());
  }
  ASSERT_EQ(timings_.table().size(), 1u);
  EXPECT_EQ(timings_.table()[0].calls, 2);
}

TEST_F(Timers, take_their_time_out_of_those_that_they_lie_in)
{
  const auto start = std::chrono::steady_clock::now();
  {
    const Timer outer("outer");
    {
      const Timer inner("inner");
      wait(2);
      const Timer innermost("innermost");
      wait(2);
    }
    wait(1);
    const Timer again("inner");
    wait(2);
  }
  const Real elapsed = std::chrono::duration<Real>(std::chrono::steady_clock::now() - start).count();
  const auto table = timings_.table();
  ASSERT_EQ(table.size(), 3u);
  EXPECT_GE(table[0].seconds, 0.001);
  EXPECT_GE(table[1].seconds, 0.004);
  EXPECT_GE(table[2].seconds, 0.002);
  EXPECT_LE(table[0].seconds + table[1].seconds + table[2].seconds, elapsed);
}

TEST_F(Timers, are_forgotten_where_the_table_is_cleared)
{
  {
    const Timer timer("something");
  }
  timings_.clear();
  EXPECT_TRUE(timings_.table().empty());
}

TEST_F(Timers, go_to_the_table_that_is_current_on_their_thread)
{
  Timings inner;
  {
    const Timings::Use use(inner);
    const Timer timer("within");
  }
  const Timer behind("behind");
  std::thread other([] { const Timer timer("of another thread"); });
  other.join();
  ASSERT_EQ(inner.table().size(), 1u);
  EXPECT_EQ(inner.table()[0].label, "within");
  EXPECT_TRUE(timings_.table().empty()) << "a timer that still runs has no time yet";
}

TEST_F(Timers, count_the_loops_by_their_label)
{
  for_each("a loop", 3, [](Index) {});
  sum_of<Real>("a sum", 3, [](Index) { return 1.; });
  ASSERT_EQ(timings_.table().size(), 2u);
  EXPECT_EQ(timings_.table()[0].label, "a loop");
  EXPECT_EQ(timings_.table()[1].label, "a sum");
}

}  // namespace
}  // namespace berm::this_file
