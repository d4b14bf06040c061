// SPDX-License-Identifier: BSD-3-Clause
#include "problem/depth_slices.hpp"

#include <gtest/gtest.h>

namespace berm::problem::this_file {
namespace {

constexpr DepthSlices four{4, 1, 0.5};  // from 1 m above the centre to 1 m below it

std::array<Real, 4> shared(Real lower, Real upper)
{
  std::array<Real, 4> parts{};
  four.share(lower, upper, [&](Index slice, Real part) { parts[slice] += part; });
  return parts;
}

TEST(DepthSlices, have_of_a_way_what_lies_in_each)
{
  const std::array<Real, 4> parts = shared(-0.1, 0.7);
  EXPECT_NEAR(parts[0], 0.25, 1e-15);
  EXPECT_NEAR(parts[1], 0.625, 1e-15);
  EXPECT_NEAR(parts[2], 0.125, 1e-15);
  EXPECT_EQ(parts[3], 0);
}

TEST(DepthSlices, have_all_of_it_in_the_first_and_the_last_beyond_their_ends)
{
  EXPECT_EQ(shared(1.2, 1.4)[0], 1);
  EXPECT_EQ(shared(-3, -2)[3], 1);
  const std::array<Real, 4> across = shared(0.9, 1.4);
  EXPECT_EQ(across[0], 1) << "what lies above the bed counts to the first";
  EXPECT_EQ(shared(0.2, 0.2)[1], 1) << "a way without length";
}

TEST(DepthSlices, have_parts_that_add_up_to_one)
{
  for (int k = 0; k < 50; ++k) {
    const std::array<Real, 4> parts = shared(-1.3 + 0.05 * k, -1.3 + 0.05 * k + 0.033 * (k + 1));
    EXPECT_NEAR(parts[0] + parts[1] + parts[2] + parts[3], 1, 1e-15) << k;
  }
}

}  // namespace
}  // namespace berm::problem::this_file
