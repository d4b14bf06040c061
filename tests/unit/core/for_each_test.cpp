// SPDX-License-Identifier: BSD-3-Clause
#include "core/for_each.hpp"

#include "samples/rough_numbers.hpp"

#include <gtest/gtest.h>

namespace berm::this_file {
namespace {

/// Sets the number of threads for one scope.
class Threads {
public:
  explicit Threads(int count) : before_(omp_get_max_threads()) { omp_set_num_threads(count); }
  ~Threads() { omp_set_num_threads(before_); }
  Threads(const Threads&) = delete;
  Threads& operator=(const Threads&) = delete;

private:
  int before_;
};

// Chunks of 512, 64 of them in one go: counts just beside both, and several goes.
const std::vector<Index> counts = {0, 1, 7, 511, 512, 513, 1024, 32767, 32768, 32769, 33280, 70001};

TEST(SumOf, is_equal_to_the_last_bit_for_any_number_of_threads)
{
  const auto numbers = rough_numbers(counts.back());
  const auto sum = [&](Index count) { return sum_of<Real>("test", count, [&](Index i) { return numbers[i]; }); };
  for (const Index count : counts) {
    Real reference;
    {
      const Threads one(1);
      reference = sum(count);
    }
    for (const int threads : {2, 3, 5}) {
      const Threads several(threads);
      EXPECT_EQ(sum(count), reference) << count << " terms, " << threads << " threads";
    }
  }
}

TEST(SumOf, leaves_no_term_out_and_takes_none_twice)
{
  for (const Index count : counts)
    for (const int threads : {1, 2, 3}) {
      const Threads some(threads);
      const auto total = sum_of<BigIndex>("test", count, [](Index i) { return BigIndex(i) * i + 1; });
      const BigIndex n = count;
      EXPECT_EQ(total, n + (n - 1) * n * (2 * n - 1) / 6) << count;
    }
}

TEST(SumOf, the_numbers_of_the_test_show_a_change_of_order)
{
  const auto numbers = rough_numbers(counts.back());
  Real forward = 0, backward = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i) forward += numbers[i], backward += numbers[numbers.size() - 1 - i];
  EXPECT_NE(forward, backward);
}

TEST(LargestOf, finds_the_largest_wherever_it_is)
{
  for (const int threads : {1, 2, 3}) {
    const Threads some(threads);
    for (const Index place : {0, 1, 499, 998, 999})
      EXPECT_EQ(largest_of("test", 1000, -infinity, [&](Index i) { return i == place ? -1. : -2. - i; }), -1);
  }
}

TEST(LargestOf, is_the_lowest_where_nothing_is_larger)
{
  EXPECT_EQ(largest_of("test", 0, 3, [](Index) { return infinity; }), 3);
  EXPECT_EQ(largest_of("test", 10, 3, [](Index i) { return 0.1 * i; }), 3);
}

TEST(ForEach, runs_each_index_once)
{
  for (const int threads : {1, 2, 3}) {
    const Threads some(threads);
    std::vector<int> times(1001, 0);
    for_each("test", 1001, [&](Index i) { ++times[i]; });
    EXPECT_EQ(times, std::vector<int>(1001, 1));
  }
}

}  // namespace
}  // namespace berm::this_file
