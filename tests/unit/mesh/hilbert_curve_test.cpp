// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/hilbert_curve.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

namespace berm::mesh::this_file {
namespace {

// The points of a small cube at the origin, in the order of the curve.
template <int dim>
std::vector<std::array<std::uint32_t, dim>> walk(std::uint32_t side)
{
  std::vector<std::pair<std::uint64_t, std::array<std::uint32_t, dim>>> points;
  const auto count = static_cast<std::uint32_t>(std::pow(side, dim));
  for (std::uint32_t n = 0; n < count; ++n) {
    std::array<std::uint32_t, dim> point;
    for (std::uint32_t d = 0, rest = n; d < dim; ++d, rest /= side) point[d] = rest % side;
    points.push_back({hilbert_index<dim>(point), point});
  }
  std::sort(points.begin(), points.end());
  std::vector<std::array<std::uint32_t, dim>> order;
  for (const auto& [place, point] : points) {
    EXPECT_EQ(place, order.size());  // every place once
    order.push_back(point);
  }
  return order;
}

template <int dim>
void expect_unit_steps(std::uint32_t side)
{
  const auto order = walk<dim>(side);
  for (std::size_t n = 1; n < order.size(); ++n) {
    std::int64_t distance = 0;
    for (int d = 0; d < dim; ++d) distance += std::abs(std::int64_t(order[n][d]) - std::int64_t(order[n - 1][d]));
    EXPECT_EQ(distance, 1) << "step " << n;
  }
}

TEST(HilbertCurve, every_step_leads_to_the_next_point_of_the_square)
{
  expect_unit_steps<2>(16);
}

TEST(HilbertCurve, every_step_leads_to_the_next_point_of_the_cube)
{
  expect_unit_steps<3>(8);
}

TEST(HilbertCurve, far_corners_have_places_inside_the_range)
{
  constexpr std::uint32_t last = (1u << curve_bits) - 1;
  EXPECT_LT(hilbert_index<2>({last, last}), std::uint64_t(1) << (2 * curve_bits));
  EXPECT_LT(hilbert_index<3>({last, last, last}), std::uint64_t(1) << (3 * curve_bits));
  EXPECT_NE(hilbert_index<3>({last, last, last}), hilbert_index<3>({last, last, last - 1}));
}

}  // namespace
}  // namespace berm::mesh::this_file
