// SPDX-License-Identifier: BSD-3-Clause
#include "fem/outline.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace berm::fem::this_file {
namespace {

constexpr Index left = 2;

/// The left wall goes down from the ground at (0, 0); the ground is given from right to left.
OutlineLoop bed_with(const std::vector<Vec<2>>& ground)
{
  std::vector<Vec<2>> corners = {{0, 0}, {0, -4}, {10, -4}, {10, 0}};
  corners.insert(corners.end(), ground.begin(), ground.end());
  constexpr Index boundaries[] = {left, 1, 0, 3};
  OutlineLoop loop;
  const std::size_t n = corners.size();
  for (std::size_t k = 0; k < n; ++k)
    loop.push_back(
        {{corners[k], k, 0}, {(corners[k] + corners[(k + 1) % n]) / 2, k, 0.5}, boundaries[std::min<std::size_t>(k, 3)], k >= 3});
  return loop;
}

int join(std::vector<OutlineLoop>& loops)
{
  return join_walls(loops, {{0, 1, left}, {10, -1, 0}});
}

/// The level of the lowest end of the sides on the left wall, and of the highest.
std::pair<Real, Real> on_wall(const OutlineLoop& loop)
{
  std::pair<Real, Real> ends = {infinity, -infinity};
  for (std::size_t k = 0; k < loop.size(); ++k) {
    if (loop[k].boundary != left) continue;
    EXPECT_GT(loop[k].corner.x[1], loop[(k + 1) % loop.size()].corner.x[1]) << "the soil lies on the left of the outline";
    ends.first = std::min(ends.first, loop[(k + 1) % loop.size()].corner.x[1]);
    ends.second = std::max(ends.second, loop[k].corner.x[1]);
  }
  return ends;
}

TEST(JoinWalls, leaves_ground_that_has_not_come_to_a_wall)
{
  std::vector<OutlineLoop> loops = {bed_with({{8, 0}, {6, 1}, {4, 2}, {2, 2}, {0.5, 1.5}, {2, 1}, {2, 0}, {1, 0}})};
  EXPECT_EQ(join(loops), 0);
  EXPECT_EQ(loops.front().size(), 12u);
}

// The nose of a berm has come to the wall above the ground there, just before it or just beyond it.
TEST(JoinWalls, joins_a_nose_to_the_wall_and_leaves_the_cavity_below_it_open)
{
  for (const Real nose : {0.03, -0.03}) {
    std::vector<OutlineLoop> loops = {bed_with({{8, 0}, {6, 1}, {4, 2}, {2, 2}, {nose, 1.5}, {1, 1}, {2, 0.5}, {2, 0}, {1, 0}})};
    const Real area = area_within(loops.front());
    EXPECT_EQ(join(loops), 1) << nose;
    ASSERT_EQ(loops.size(), 1u);
    EXPECT_NEAR(area_within(loops.front()), area, 0.1) << "a side on the wall of a tenth of its neighbours";
    EXPECT_EQ(on_wall(loops.front()), std::pair(Real(-4), Real(1.55)));
    EXPECT_EQ(std::ranges::count(loops.front(), left, &OutlineSide::boundary), 2);
    for (const OutlineSide& side : loops.front()) EXPECT_GE(side.corner.x[0], 0);
    EXPECT_EQ(join(loops), 0) << "once";
  }
}

// A side that bulges beyond the wall, though its corners lie before it.
TEST(JoinWalls, joins_a_bulge)
{
  std::vector<OutlineLoop> loops = {bed_with({{8, 0}, {6, 1}, {4, 2}, {2, 2}, {0.2, 1.5}, {0.2, 1}, {2, 0.5}, {2, 0}, {1, 0}})};
  loops.front()[8].middle.x[0] = -0.02;
  EXPECT_EQ(join(loops), 1);
  for (const OutlineSide& side : loops.front()) EXPECT_GE(std::min(side.corner.x[0], side.middle.x[0]), 0);
}

// What is left of the cavity goes, corner by corner, and then its last side.
TEST(JoinWalls, closes_a_cavity_at_the_wall)
{
  std::vector<OutlineLoop> loops = {bed_with({{8, 0}, {6, 1}, {4, 2}, {2, 2}, {0, 1.6}, {0, 1.4}, {0.02, 0.7}})};
  loops.front()[8].boundary = left;
  loops.front()[8].free = false;
  EXPECT_EQ(join(loops), 0) << "no new place";
  EXPECT_EQ(on_wall(loops.front()), std::pair(Real(-4), Real(1.6)));
  EXPECT_TRUE(std::ranges::none_of(loops.front(), [](const OutlineSide& side) { return side.free && side.corner.x[0] == 0; }));
}

// A crest that has come down onto the wall below the ground there: the ground begins with the crest.
TEST(JoinWalls, drops_what_goes_back_along_the_wall)
{
  std::vector<OutlineLoop> loops = {bed_with({{8, 0}, {6, 1}, {4, 1}, {2, 0}, {0.01, -0.5}})};
  join(loops);
  EXPECT_EQ(on_wall(loops.front()), std::pair(Real(-4), Real(-0.5)));
}

}  // namespace
}  // namespace berm::fem::this_file
