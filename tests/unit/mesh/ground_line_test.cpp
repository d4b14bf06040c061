// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/ground_line.hpp"

#include <gtest/gtest.h>

namespace berm::mesh::this_file {
namespace {

constexpr Real round_off = 1e-14;

/// Level, down to a trench with a vertical wall, up again by 45 degrees, level.
GroundLine trench()
{
  return {{Vec<2>(-3, 0), Vec<2>(-1, 0), Vec<2>(-1, -1), Vec<2>(1, -1), Vec<2>(2, 0), Vec<2>(3, 0)}};
}

TEST(GroundLine, has_a_height_everywhere)
{
  const GroundLine line = trench();
  EXPECT_EQ(line.height(-5), 0);
  EXPECT_EQ(line.height(-2), 0);
  EXPECT_EQ(line.height(-1), -1) << "at a vertical wall the ground right of it";
  EXPECT_EQ(line.height(0), -1);
  EXPECT_NEAR(line.height(1.25), -0.75, round_off);
  EXPECT_EQ(line.height(7), 0);
  EXPECT_EQ(line.heights(-2, -1.5), (std::pair<Real, Real>(0, 0)));
  EXPECT_EQ(line.heights(-2, 1.5).first, -1);
  EXPECT_EQ(line.heights(-2, 1.5).second, 0);
}

TEST(GroundLine, knows_how_far_a_point_is)
{
  const GroundLine line = trench();
  EXPECT_NEAR(line.distance(Vec<2>(0, 1)), std::sqrt(2.), round_off) << "of the edge";
  EXPECT_NEAR(line.distance(Vec<2>(-0.75, -0.5)), 0.25, round_off) << "of the wall";
  EXPECT_NEAR(line.distance(Vec<2>(1, 0)), std::sqrt(0.5), round_off) << "of the inclined side";
}

TEST(GroundLine, is_simplified_to_the_corners_that_it_has)
{
  GroundLine line;
  for (int k = 0; k <= 40; ++k) line.corners.emplace_back(k / 10. - 2, std::abs(k / 10. - 2));
  const GroundLine simple = simplified(line);
  ASSERT_EQ(simple.corners.size(), 3u);
  EXPECT_NEAR(simple.corners[1].norm(), 0, round_off);
  for (const Real x : {-1.93, -0.41, 0.3, 1.7}) EXPECT_NEAR(simple.height(x), std::abs(x), 1e-12);
  EXPECT_EQ(simplified(trench()).corners.size(), trench().corners.size()) << "a vertical wall stays";
  EXPECT_TRUE(simplified({{Vec<2>(0, 0.5), Vec<2>(1, 0.5 + 1e-12), Vec<2>(2, 0.5)}}).level());
  EXPECT_TRUE(simplified({}).level());
}

// Each corner is within round-off of the line between its neighbours, and all of them are not.
TEST(GroundLine, keeps_a_curve)
{
  GroundLine line;
  constexpr int count = 1000;
  for (int k = 0; k <= count; ++k) line.corners.emplace_back(Real(k) / count, std::pow(Real(k) / count, 2));
  const GroundLine simple = simplified(line);
  for (const Real x : {0.1234, 0.5, 0.789}) EXPECT_NEAR(simple.height(x), x * x, 2e-6);
}

TEST(GroundLine, is_cut_at_the_edges_of_a_rectangle)
{
  const GroundLine inside = within(trench(), Vec<2>(-2, -0.5), Vec<2>(2.5, 1));
  ASSERT_EQ(inside.corners.size(), 6u);
  EXPECT_EQ(inside.corners.front(), Vec<2>(-2, 0));
  EXPECT_EQ(inside.corners[2], Vec<2>(-1, -0.5));
  EXPECT_EQ(inside.corners[3], Vec<2>(1.5, -0.5));
  EXPECT_EQ(inside.corners.back(), Vec<2>(2.5, 0));
  EXPECT_TRUE(within(trench(), Vec<2>(-2, 1), Vec<2>(2, 2)).level());
}

}  // namespace
}  // namespace berm::mesh::this_file
