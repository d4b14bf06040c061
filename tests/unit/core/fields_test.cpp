// SPDX-License-Identifier: BSD-3-Clause
#include "core/fields.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace berm::this_file {
namespace {

TEST(Field, of_zeros_is_zero_also_in_memory_that_was_used_before)
{
  for (const Index count : {1, 7, 100, 5000, 200000}) {
    for (int round = 0; round < 3; ++round) {
      auto used = CellField<Real>(count, 3.5);
      EXPECT_TRUE(std::all_of(used.begin(), used.end(), [](Real x) { return x == 3.5; }));
      used = CellField<Real>();
      const auto zeros = CellField<Real>::zeros(count);
      ASSERT_EQ(zeros.size(), count);
      EXPECT_TRUE(std::all_of(zeros.begin(), zeros.end(), [](Real x) { return x == 0; })) << count;
    }
  }
}

TEST(Field, keeps_its_numbers_when_it_grows)
{
  NodeField<Index> field;
  for (Index i = 0; i < 1000; ++i) field.push_back(i * i);
  for (Index i = 0; i < 1000; ++i) EXPECT_EQ(field[i], i * i);
  const NodeField<Index> copy = field;
  field.assign(3, 7);
  EXPECT_EQ(field.size(), 3);
  EXPECT_EQ(field[2], 7);
  EXPECT_EQ(copy[999], 999 * 999);
}

}  // namespace
}  // namespace berm::this_file
