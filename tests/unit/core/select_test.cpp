// SPDX-License-Identifier: BSD-3-Clause
#include "core/select.hpp"

#include <gtest/gtest.h>
#include <random>

namespace berm::this_file {
namespace {

TEST(Select, lists_what_is_kept_ascending_on_any_number_of_threads)
{
  std::mt19937 random(3);
  const int before = omp_get_max_threads();
  for (const Index count : {0, 1, 255, 256, 257, 70001})
    for (const unsigned one_in : {1U, 3U, 1000U}) {
      std::vector<char> keep(static_cast<std::size_t>(count));
      std::vector<Index> expected;
      for (Index i = 0; i < count; ++i) {
        keep[i] = random() % one_in == 0;
        if (keep[i] != 0) expected.push_back(i);
      }
      for (const int threads : {1, 2, 3}) {
        omp_set_num_threads(threads);
        std::vector<Index> selected = {7, 7, 7};
        select(
            "test", count, [&](Index i) { return keep[i] != 0; }, selected);
        EXPECT_EQ(selected, expected) << count << ", one in " << one_in;
      }
    }
  omp_set_num_threads(before);
}

}  // namespace
}  // namespace berm::this_file
