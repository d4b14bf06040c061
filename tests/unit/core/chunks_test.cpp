// SPDX-License-Identifier: BSD-3-Clause
#include "core/chunks.hpp"

#include "samples/rough_numbers.hpp"

#include <gtest/gtest.h>

namespace berm::this_file {
namespace {

struct List {
  std::vector<Index> numbers;
  Chunks chunks;
};

template <class Keep>
List selected(Index count, const Keep& keep)
{
  List list;
  select("test", chunk_bounds(count), keep, list.numbers, list.chunks);
  return list;
}

TEST(ChunkBounds, begin_at_0_end_at_the_count_and_are_as_long_as_each_other_but_for_the_last)
{
  for (const Index count : {1, 31, 32, 33, 1000, 16384, 100000, 3000000}) {
    const std::vector<Index> bounds = chunk_bounds(count);
    EXPECT_EQ(bounds.front(), 0);
    EXPECT_EQ(bounds.back(), count);
    for (std::size_t c = 2; c + 1 < bounds.size(); ++c) EXPECT_EQ(bounds[c] - bounds[c - 1], bounds[1]) << count;
    EXPECT_GE(bounds[1], std::min(count, 32));
    EXPECT_LE(static_cast<Index>(bounds.size()), 2050 + count / 4096);
  }
}

TEST(Select, lists_in_chunks_what_it_lists_without)
{
  std::mt19937 random(3);
  for (const Index count : {0, 1, 100, 5000})
    for (const unsigned percent : {0u, 1u, 60u, 100u})
      for (const int threads : {1, 3}) {
        omp_set_num_threads(threads);
        std::vector<char> kept(static_cast<std::size_t>(count));
        for (char& keep : kept) keep = random() % 100 < percent ? 1 : 0;
        std::vector<Index> expected;
        for (Index i = 0; i < count; ++i)
          if (kept[i] != 0) expected.push_back(i);
        const List list = selected(count, [&](Index i) { return kept[i] != 0; });
        EXPECT_EQ(list.numbers, expected);
        const std::vector<Index> bounds = chunk_bounds(count);
        ASSERT_EQ(static_cast<std::size_t>(list.chunks.all), bounds.size() - 1);
        ASSERT_EQ(list.chunks.begin.size(), list.chunks.number.size() + 1);
        EXPECT_EQ(list.chunks.begin.back(), static_cast<Index>(expected.size()));
        for (Index k = 0; k < list.chunks.count(); ++k) {
          EXPECT_LT(list.chunks.begin[k], list.chunks.begin[k + 1]);
          for (Index i = list.chunks.begin[k]; i < list.chunks.begin[k + 1]; ++i) {
            EXPECT_GE(list.numbers[i], bounds[list.chunks.number[k]]);
            EXPECT_LT(list.numbers[i], bounds[list.chunks.number[k] + 1]);
          }
        }
      }
}

TEST(Chunks, of_a_list_that_is_made_again_allocate_nothing)
{
  List list = selected(5000, [](Index) { return true; });
  const Index *numbers = list.numbers.data(), *begin = list.chunks.begin.data(), *number = list.chunks.number.data();
  for (const Index every : {1, 7, 4999}) {
    select(
        "test", chunk_bounds(5000), [&](Index i) { return i % every == 0; }, list.numbers, list.chunks);
    EXPECT_EQ(list.numbers.data(), numbers);
    EXPECT_EQ(list.chunks.begin.data(), begin);
    EXPECT_EQ(list.chunks.number.data(), number);
  }
}

TEST(SumOfChunks, is_that_of_the_chunks_one_after_the_other_on_any_number_of_threads)
{
  constexpr Index count = 9000;
  const std::vector<Real> numbers = rough_numbers(count);
  const List list = selected(count, [](Index i) { return i % 3 != 0 && (i < 2000 || i > 4000); });
  Real expected = 0;
  for (Index k = 0; k < list.chunks.count(); ++k) {
    Real sum = 0;
    for (Index i = list.chunks.begin[k]; i < list.chunks.begin[k + 1]; ++i) sum += numbers[list.numbers[i]];
    expected += sum;
  }
  for (const int threads : {1, 2, 3, 5}) {
    omp_set_num_threads(threads);
    EXPECT_EQ(sum_of<Real>("test", list.chunks, [&](Index i) { return numbers[list.numbers[i]]; }), expected);
    std::vector<int> visits(list.numbers.size(), 0);
    for_each("test", list.chunks, [&](Index i) { ++visits[i]; });
    EXPECT_EQ(std::count(visits.begin(), visits.end(), 1), static_cast<std::ptrdiff_t>(visits.size()));
  }
}

TEST(SumOfChunks, in_two_steps_takes_what_the_first_left_to_the_second_once_for_each_entry)
{
  constexpr Index count = 9000;
  const std::vector<Real> numbers = rough_numbers(count);
  const List list = selected(count, [](Index i) { return i % 7 != 0; });
  const auto number_of = [&](Index i) { return numbers[list.numbers[i]]; };
  for (const int threads : {1, 3}) {
    omp_set_num_threads(threads);
    std::vector<int> firsts(list.numbers.size(), 0), seconds(list.numbers.size(), 0);
    const auto first = [&](Index i, Real& left, Real&) {
      ++firsts[i];
      left = number_of(i);
    };
    const auto second = [&](Index i, const Real& left, Real& sum) {
      seconds[i] += firsts[i];
      sum += left;
    };
    const auto total = sum_in_two_steps<Real, Real>("test", list.chunks, first, second);
    EXPECT_EQ(total, sum_of<Real>("test", list.chunks, number_of));
    EXPECT_EQ(total, sum_of<Real>("test", list.chunks, [&](Index i, Real& sum) { sum += number_of(i); }));
    EXPECT_EQ(std::count(firsts.begin(), firsts.end(), 1), static_cast<std::ptrdiff_t>(firsts.size()));
    EXPECT_EQ(seconds, firsts);
  }
}

TEST(SumOfChunks, of_nothing_is_zero)
{
  EXPECT_EQ(sum_of<Real>("test", Chunks(), [](Index) { return 1.; }), 0);
}

}  // namespace
}  // namespace berm::this_file
