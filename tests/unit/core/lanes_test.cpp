// SPDX-License-Identifier: BSD-3-Clause
#include "core/lanes.hpp"

#include <gtest/gtest.h>
#include <random>

namespace berm {
namespace {

constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();
constexpr Lanes sample = {3, -1, 4, 1, -5, 9, -2, 6};

Lanes random_lanes(std::mt19937& random)
{
  Lanes x{};
  for (int l = 0; l < lanes; ++l) x[l] = std::ldexp(std::uniform_real_distribution<Real>(-1, 1)(random), static_cast<int>(random() % 60));
  return x;
}

TEST(Lanes, any_is_true_when_one_lane_is)
{
  EXPECT_FALSE(any(LaneMask{}));
  for (int l = 0; l < lanes; ++l) {
    LaneMask mask{};
    mask[l] = -1;
    EXPECT_TRUE(any(mask)) << l;
  }
  EXPECT_TRUE(any(true));
  EXPECT_FALSE(any(false));
}

TEST(Lanes, a_comparison_with_the_count_masks_the_lanes_that_hold_a_particle)
{
  for (int count = 0; count <= 2 * lanes; ++count) {
    const LaneMask alive = lane_numbers < all_lanes(count);
    for (int l = 0; l < lanes; ++l) EXPECT_EQ(alive[l] != 0, l < count) << count << " " << l;
  }
}

TEST(Lanes, a_mask_chooses_lane_by_lane)
{
  const Lanes chosen = sample > Lanes{} ? sample : all_lanes(-7);
  for (int l = 0; l < lanes; ++l) EXPECT_EQ(chosen[l], sample[l] > 0 ? sample[l] : -7);
}

TEST(Lanes, a_lane_that_is_not_chosen_leaves_no_trace_even_if_it_is_nan)
{
  Lanes bad = sample;
  bad[3] = nan;
  const Lanes chosen = bad == bad ? bad : Lanes{};
  for (int l = 0; l < lanes; ++l) EXPECT_EQ(chosen[l], l == 3 ? 0 : sample[l]);
}

TEST(Lanes, all_lanes_is_the_number_in_each_lane_to_the_last_bit)
{
  for (const Real value : {0., -0.1, 1e-300, 1e300, infinity}) {
    const Lanes x = all_lanes(value);
    for (int l = 0; l < lanes; ++l) EXPECT_EQ(x[l], value);
  }
}

TEST(Lanes, larger_smaller_and_magnitude_are_those_of_each_lane)
{
  const Lanes other = {2, -1, 5, 0, -4, 10, 1, -6};
  const Lanes most = larger(sample, other), least = smaller(sample, other), size = magnitude(sample);
  for (int l = 0; l < lanes; ++l) {
    EXPECT_EQ(most[l], std::max(sample[l], other[l]));
    EXPECT_EQ(least[l], std::min(sample[l], other[l]));
    EXPECT_EQ(size[l], std::abs(sample[l]));
  }
  EXPECT_EQ(larger(2., 3.), 3);
  EXPECT_EQ(smaller(2., 3.), 2);
  EXPECT_EQ(magnitude(-2.), 2);
}

TEST(Lanes, square_root_is_that_of_the_numbers)
{
  const Lanes root = square_root(sample * sample);
  for (int l = 0; l < lanes; ++l) EXPECT_EQ(root[l], std::abs(sample[l]));
}

TEST(Lanes, the_sum_is_made_in_pairs_in_one_order)
{
  std::mt19937 random(1);
  for (int trial = 0; trial < 1000; ++trial) {
    const Lanes x = random_lanes(random);
    const Real pairs[4] = {x[0] + x[4], x[1] + x[5], x[2] + x[6], x[3] + x[7]};
    EXPECT_EQ(sum(x), (pairs[0] + pairs[2]) + (pairs[1] + pairs[3]));
  }
}

TEST(Lanes, eight_sums_at_once_are_those_one_by_one_to_the_last_bit)
{
  std::mt19937 random(7);
  Lanes x[lanes];
  for (Lanes& one : x) one = random_lanes(random);
  const Lanes all = sums(x);
  for (int k = 0; k < lanes; ++k) EXPECT_EQ(all[k], sum(x[k])) << k;
}

}  // namespace
}  // namespace berm
