// SPDX-License-Identifier: BSD-3-Clause
#include "fem/outline.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace berm::fem::this_file {
namespace {

/// A loop through these corners, whose first three sides are the right wall, the base and the left wall where it is the outline of a bed.
OutlineLoop loop_of(const std::vector<Vec<2>>& corners, std::size_t walls)
{
  OutlineLoop loop;
  const std::size_t n = corners.size();
  for (std::size_t k = 0; k < n; ++k)
    loop.push_back(
        {{corners[k], k, 0}, {(corners[k] + corners[(k + 1) % n]) / 2, k, 0.5}, k < walls ? static_cast<Index>(k) : 3, k >= walls});
  return loop;
}

std::vector<Vec<2>> with_ground(const std::vector<Vec<2>>& ground)
{
  std::vector<Vec<2>> corners = {{0, 0}, {0, -4}, {10, -4}, {10, 0}};
  corners.insert(corners.end(), ground.begin(), ground.end());
  return corners;
}

TEST(CloseFolds, leaves_ground_that_does_not_meet_itself)
{
  std::vector<OutlineLoop> loops = {loop_of(with_ground({{8, 0}, {7, 1}, {6, 2}, {5, 1}, {4, 0}, {2, 0}}), 3)};
  EXPECT_EQ(close_folds(loops), 0);
  EXPECT_EQ(loops.front().size(), 10u);
}

// The crest of a berm has fallen onto the ground beside it.
TEST(CloseFolds, joins_a_crest_to_the_ground_that_it_has_fallen_onto)
{
  for (const Real crest : {-0.1, 0.05}) {  // just in the ground, just above it
    std::vector<OutlineLoop> loops = {
        loop_of(with_ground({{8, 0}, {7, 2}, {5, 2}, {3.9, crest}, {5, 1}, {6, 0.5}, {6, 0}, {5, 0}, {4, 0}, {3, 0}, {2, 0}, {1, 0}}), 3)};
    EXPECT_EQ(close_folds(loops), 1) << crest;
    ASSERT_EQ(loops.size(), 1u);
    for (const auto& [corner, middle, boundary, free] : loops.front())
      EXPECT_FALSE(corner.x[0] > 4.5 && corner.x[1] > -0.01 && corner.x[1] < 1.5 && corner.x[0] < 6.5) << "the pocket is filled";
  }
}

// A neck of soil between two free surfaces is no void.
TEST(CloseFolds, leaves_a_thin_tongue_of_soil)
{
  std::vector<OutlineLoop> loops = {
      loop_of(with_ground({{8, 0}, {5.05, 0}, {5.05, 1}, {5.5, 2}, {4.5, 2}, {4.95, 1}, {4.95, 0}, {2, 0}}), 3)};
  EXPECT_EQ(close_folds(loops), 0);
  EXPECT_EQ(loops.front().size(), 12u);
}

// Sides in contact that have changed their order.
TEST(CloseFolds, unties_a_knot_of_short_sides_in_contact)
{
  std::vector<OutlineLoop> loops = {loop_of(with_ground({{8, 0}, {6, 0}, {5, -0.1}, {5.5, 0.05}, {5.2, -0.2}, {4, 0}, {2, 0}}), 3)};
  for (std::size_t k = 5; k < 9; ++k) loops.front()[k].free = false;
  EXPECT_EQ(close_folds(loops), 1);
  ASSERT_EQ(loops.size(), 1u);
  for (const auto& [corner, middle, boundary, free] : loops.front()) EXPECT_NE(corner.x, Vec<2>(5.5, 0.05));
}

// A tip of soil as long as two sides, squeezed into a crease beside the edge of a body at x = 5.
TEST(CloseFolds, unties_a_crease_beside_an_edge)
{
  std::vector<OutlineLoop> loops = {loop_of(
      with_ground({{8, 2}, {5, 2}, {5.001, -1}, {6, -0.3}, {6, 1}, {5.3, 0}, {4.999, -0.99}, {5, -2.4}, {4, -2.8}, {2, -2.9}, {1, -1}}),
      3)};
  for (const std::size_t in_contact : {5, 10, 11, 12}) loops.front()[in_contact].free = false;
  const std::size_t sides = loops.front().size();
  EXPECT_EQ(close_folds(loops), 1);
  ASSERT_EQ(loops.size(), 1u);
  EXPECT_LT(loops.front().size(), sides - 2);
  for (const auto& [corner, middle, boundary, free] : loops.front()) EXPECT_NE(corner.x, Vec<2>(6, -0.3));
}

// A body of which the sides from (6, -2) to (4, -2) are in contact, below flanks that have closed above it.
TEST(CloseFolds, leaves_a_hole_around_the_body)
{
  std::vector<OutlineLoop> loops = {
      loop_of(with_ground({{7, 0}, {5.06, 0}, {6, -1}, {6, -2}, {4, -2}, {4, -1}, {4.98, 0}, {3, 0}, {2, 0}}), 3)};
  loops.front()[7].free = false;
  EXPECT_EQ(close_folds(loops), 1);
  ASSERT_EQ(loops.size(), 2u);
  EXPECT_EQ(std::ranges::count(loops[1], false, &OutlineSide::free), 1);
  Real lowest = 0;
  for (const auto& [corner, middle, boundary, free] : loops[1]) lowest = std::min(lowest, corner.x[1]);
  EXPECT_EQ(lowest, -2);
  for (const auto& [corner, middle, boundary, free] : loops[0]) EXPECT_TRUE(corner.x[1] > -0.5 || corner.x[1] == -4);
}

}  // namespace
}  // namespace berm::fem::this_file
