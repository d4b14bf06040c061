// SPDX-License-Identifier: BSD-3-Clause
#include "core/lanes.hpp"

#include <gtest/gtest.h>
#include <random>

namespace berm::this_file {
namespace {

constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();
constexpr Lanes sample = {3, -1, 4, -5};

/// Vectors as wide as a register of each vector unit.
template <class V>
class Vectors : public testing::Test {
};
using Widths = testing::Types<Real __attribute__((vector_size(16))), Lanes, Real __attribute__((vector_size(64)))>;
TYPED_TEST_SUITE(Vectors, Widths);

template <class V>
V random_vector(std::mt19937& random)
{
  V x{};
  for (int l = 0; l < lanes_of<V>; ++l)
    x[l] = std::ldexp(std::uniform_real_distribution<Real>(-1, 1)(random), static_cast<int>(random() % 60));
  return x;
}

TYPED_TEST(Vectors, any_is_true_when_one_lane_is)
{
  EXPECT_FALSE(any(TypeParam{} < TypeParam{}));
  for (int l = 0; l < lanes_of<TypeParam>; ++l) {
    auto mask = TypeParam{} < TypeParam{};
    mask[l] = -1;
    EXPECT_TRUE(any(mask)) << l;
  }
}

TEST(Lanes, any_of_one_condition_is_itself)
{
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
  const Lanes other = {2, -1, 5, -6};
  const Lanes max = larger(sample, other), min = smaller(sample, other), size = magnitude(sample);
  for (int l = 0; l < lanes; ++l) {
    EXPECT_EQ(max[l], std::max(sample[l], other[l]));
    EXPECT_EQ(min[l], std::min(sample[l], other[l]));
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

TYPED_TEST(Vectors, the_sum_adds_neighbours_then_sums_of_neighbours)
{
  std::mt19937 random(1);
  for (int trial = 0; trial < 1000; ++trial) {
    TypeParam x = random_vector<TypeParam>(random);
    const Real got = sum(x);
    for (int half = lanes_of<TypeParam> / 2; half > 0; half /= 2)
      for (int l = 0; l < half; ++l) x[l] = x[2 * l] + x[2 * l + 1];
    EXPECT_EQ(got, x[0]);
  }
}

TYPED_TEST(Vectors, sums_at_once_are_those_one_by_one_to_the_last_bit)
{
  std::mt19937 random(7);
  TypeParam x[lanes_of<TypeParam>];
  for (TypeParam& one : x) one = random_vector<TypeParam>(random);
  const TypeParam all = sums(x);
  for (int k = 0; k < lanes_of<TypeParam>; ++k) EXPECT_EQ(all[k], sum(x[k])) << k;
}

}  // namespace
}  // namespace berm::this_file
