// SPDX-License-Identifier: BSD-3-Clause
#include "run_folder/ground.hpp"

#include <gtest/gtest.h>

namespace berm::run_folder::this_file {
namespace {

/// Two squares in a row, each of two triangles, on a grid of 5 x 3 nodes that is numbered from below.
SavedSoil two_squares()
{
  SavedSoil soil;
  for (int k = 0; k < 15; ++k) soil.x.push_back(0.1 * (k % 5)), soil.y.push_back(-0.2 + 0.1 * (k / 5));
  soil.triangles = {{0, 2, 12, 1, 7, 6}, {0, 12, 10, 6, 11, 5}, {2, 4, 14, 3, 9, 8}, {2, 14, 12, 8, 13, 7}};
  return soil;
}

TEST(Ground, is_the_free_surface_from_wall_to_wall)
{
  EXPECT_EQ(ground_points(two_squares()), (std::vector<Index>{10, 11, 12, 13, 14}));
}

TEST(Ground, without_elements_or_walls_has_no_points)
{
  SavedSoil soil;
  EXPECT_TRUE(ground_points(soil).empty());
  soil.x = {0, 1, 0.5, 0.5, 0.7, 0.2, 2}, soil.y = {0, 0, 1, 0, 0.5, 0.5, 0};
  soil.triangles = {{0, 1, 2, 3, 4, 5}};  // the last point, the rightmost, belongs to none
  EXPECT_TRUE(ground_points(soil).empty());
}

}  // namespace
}  // namespace berm::run_folder::this_file
