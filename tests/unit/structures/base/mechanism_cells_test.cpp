// SPDX-License-Identifier: BSD-3-Clause
#include "structures/base/mechanism_cells.hpp"

#include <gtest/gtest.h>

namespace berm::base::this_file {
namespace {

constexpr Real side = 0.1;

/// A bed of 40 by 20 points with volumes of side^2, of which those below row `rows` and left of `columns` have sheared.
run_folder::SavedSoil bed(int columns, int rows, int body)
{
  run_folder::SavedSoil made;
  made.fields = {{{"deviatoric_strain", "", ""}, {}}};
  for (int row = 0; row < 20; ++row)
    for (int column = 0; column < 40; ++column) {
      made.x.push_back((column + 0.5) * side);
      made.y.push_back((row + 0.5) * side);
      made.z.push_back(0);
      made.volume.push_back(static_cast<float>(side * side));
      made.body.push_back(body);
      made.fields[0].values.push_back(column < columns && row < rows ? 0.2F : 0.01F);
    }
  return made;
}

Real cells_across(const run_folder::SavedSoil& now, const std::vector<Real>& points_of_cell)
{
  return cells_across_mechanism(bed(0, 0, 0), now, points_of_cell, 2);
}

// Two points a triangle whose square has the side sqrt(2 * 2) * 0.1 = 0.2 m; 98 % of points 0.1 m apart.
TEST(MechanismCells, are_counted_across_the_smaller_side_of_what_has_sheared)
{
  EXPECT_NEAR(cells_across(bed(30, 10, 0), {2}), 0.9 / 0.2, 0.01);
  EXPECT_NEAR(cells_across(bed(8, 16, 0), {2}), 0.7 / 0.2, 0.01);
}

TEST(MechanismCells, are_larger_with_more_points_in_each)
{
  EXPECT_NEAR(cells_across(bed(30, 10, 0), {8}), 0.9 / 0.4, 0.01);
}

TEST(MechanismCells, do_not_count_across_a_bed_that_shears_from_end_to_end)
{
  EXPECT_NEAR(cells_across(bed(40, 10, 0), {2}), 0.9 / 0.2, 0.01);
  EXPECT_NEAR(cells_across(bed(30, 20, 0), {2}), 2.9 / 0.2, 0.01);
  EXPECT_TRUE(std::isnan(cells_across(bed(40, 20, 0), {2})));
}

TEST(MechanismCells, are_not_known_of_bodies_that_do_not_count)
{
  EXPECT_TRUE(std::isnan(cells_across_mechanism(bed(0, 0, 1), bed(30, 10, 1), {2, nan}, 2)));
}

}  // namespace
}  // namespace berm::base::this_file
