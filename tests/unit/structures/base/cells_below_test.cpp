// SPDX-License-Identifier: BSD-3-Clause
#include "structures/base/cells_below.hpp"

#include "samples/made_run.hpp"

#include <gtest/gtest.h>

namespace berm::base::this_file {
namespace {

/// A disk of 1 m on the axis, with a fine zone of 4 mm around its edge at 0.5 m.
record::RunRecord on_edge_of_fine_cells(Real gradient)
{
  MadeRun made;
  made.law = MadeRun::clay_law();
  made.law.cohesion_gradient = gradient;
  record::RunRecord run = made.record();
  run.settings.geometry = settings::Geometry::axisymmetric;
  auto& bed = std::get<mesh::SeabedMesh>(run.settings.mesh);
  bed.left = 0;
  bed.length = 2.5;
  bed.depth = 1.25;
  bed.near_size = 0.004;
  bed.near_left = 0.45;
  bed.near_right = 0.55;
  bed.growth = 0.1;
  bed.far_size = 0.1;
  run.settings.rigid[0].second.shape = bodies::BoxSettings{.center = {0, 0.25}, .size = {1, 0.5}};
  return run;
}

TEST(CellsBelow, are_the_largest_between_the_fine_zone_and_the_middle)
{
  EXPECT_NEAR(largest_cell_below(on_edge_of_fine_cells(0).settings), 0.004 + 0.1 * 0.45, 1e-12);
}

TEST(CellsBelow, are_judged_in_clay_whose_strength_grows_below_the_body)
{
  const record::RunRecord run = on_edge_of_fine_cells(6000);
  const TrustMeasure measure = cells_below("footing");
  ASSERT_TRUE(measure.applies(run));
  EXPECT_NEAR(measure.value(run), 1 / 0.049, 1e-9);
  EXPECT_EQ(judge(*measure.limit, measure.value(run)), text::Standing::fair);
}

TEST(CellsBelow, are_not_where_the_middle_carries_little_or_the_fine_zone_reaches_below_all)
{
  const TrustMeasure measure = cells_below("footing");
  EXPECT_FALSE(measure.applies(on_edge_of_fine_cells(0))) << "uniform strength: the soil below the middle moves with the body";
  record::RunRecord fine = on_edge_of_fine_cells(6000);
  std::get<mesh::SeabedMesh>(fine.settings.mesh).near_left = 0;
  EXPECT_FALSE(measure.applies(fine));
  fine = on_edge_of_fine_cells(6000);
  fine.settings.rigid[0].second.shape = bodies::CircleSettings{{0, 0.5}, 1};
  EXPECT_FALSE(measure.applies(fine)) << "a ball has no flat base";
}

}  // namespace
}  // namespace berm::base::this_file
