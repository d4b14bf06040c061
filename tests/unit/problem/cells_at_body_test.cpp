// SPDX-License-Identifier: BSD-3-Clause
#include "problem/cells_at_body.hpp"

#include <gtest/gtest.h>

namespace berm::problem::this_file {
namespace {

/// A box of 2 m with squares of 0.1 m.
Model<2> model_of_squares()
{
  Model<2> model;
  mesh::BoxMesh box;
  box.size = {2, 2};
  box.cells = {20, 20};
  model.mesh = mesh::make_box<2>(box);
  return model;
}

/// The same, where beyond 1.5 m of an axis columns or rows are four times as large.
Model<2> model_of_squares_and_larger(int axis)
{
  Model<2> model = model_of_squares();
  for (Vec<2>& x : model.mesh.position)
    if (x[axis] > 1.5) x[axis] = 1.5 + 4 * (x[axis] - 1.5);
  model.mesh.complete();
  return model;
}

bodies::RigidShape<2> circle(Real x, Real y, Real radius)
{
  bodies::CircleSettings settings;
  settings.center = {x, y};
  settings.diameter = 2 * radius;
  return bodies::make_shape<2>(bodies::RigidShapeSettings(settings));
}

TEST(CellsAtBody, have_the_side_of_the_squares_of_a_box)
{
  const Model<2> model = model_of_squares();
  Index start = 0;
  EXPECT_NEAR(cell_size_at<2>(model, circle(1, 1, 0.3), start), 0.1, 1e-12);
}

TEST(CellsAtBody, are_the_largest_that_the_lower_half_meets_as_it_moves)
{
  const Model<2> model = model_of_squares_and_larger(0);
  Index start = 0;
  EXPECT_NEAR(cell_size_at<2>(model, circle(1, 1, 0.3), start), 0.1, 1e-12);
  EXPECT_NEAR(cell_size_at<2>(model, circle(2, 1, 0.3), start), 0.2, 1e-12) << "the square of the same area";
  EXPECT_NEAR(cell_size_at<2>(model, circle(1, 1, 0.3), start), 0.1, 1e-12) << "and back";
}

TEST(CellsAtBody, are_not_those_in_the_air_beside_a_leg)
{
  Model<2> model = model_of_squares_and_larger(1);
  Index start = 0;
  bodies::BoxSettings leg;
  leg.center = {1, 2.4};
  leg.size = {0.4, 3};
  const bodies::RigidShape<2> shape = bodies::make_shape<2>(bodies::RigidShapeSettings(leg));
  model.surface = 1.1;
  EXPECT_NEAR(cell_size_at<2>(model, shape, start), 0.1, 1e-12) << "it reaches 0.9 m, and its middle 2.4 m";
  model.surface = 1.6;
  EXPECT_NEAR(cell_size_at<2>(model, shape, start), 0.2, 1e-12);
}

TEST(CellsAtBody, are_not_known_beyond_the_mesh)
{
  const Model<2> model = model_of_squares();
  Index start = 0;
  EXPECT_TRUE(std::isnan(cell_size_at<2>(model, circle(5, 1, 0.3), start)));
}

TEST(CellsAtBody, are_of_the_region_below_its_lowest_point)
{
  Model<2> model = model_of_squares();
  model.surface = 1.5;
  model.mesh.region_names = {"upper", "trench"};
  for (Index cell = 0; cell < model.mesh.cell_count(); ++cell) {
    Vec<2> middle = Vec<2>::Zero();
    for (const Index node : model.mesh.nodes[cell]) middle += model.mesh.position[node] / 3;
    model.mesh.region[cell] = middle[1] < 1 && middle[0] > 0.5 ? 1 : 0;
  }
  const bodies::RigidShape<2> pipe = circle(1, 1.8, 0.3);
  EXPECT_EQ(region_below<2>(model, pipe, 0.4), "upper");
  EXPECT_EQ(region_below<2>(model, pipe, 0.6), "trench");
  EXPECT_EQ(region_below<2>(model, circle(0.35, 1.8, 0.3), 0.6), "upper") << "beside it";
  EXPECT_EQ(region_below<2>(model, pipe, 3), "") << "below the mesh";
}

TEST(CellsAtBody, are_below_the_ground_where_the_body_is)
{
  Model<2> model = model_of_squares();
  model.surface = 0;
  model.mesh.region_names = {"lower", "upper"};
  for (Index cell = 0; cell < model.mesh.cell_count(); ++cell) {
    Real middle = 0;
    for (const Index node : model.mesh.nodes[cell]) middle += model.mesh.position[node][1] / 3;
    model.mesh.region[cell] = middle > 0.9 ? 1 : 0;
  }
  model.ground.line.corners = {{0, 1}, {2, 2}};
  EXPECT_EQ(region_below<2>(model, circle(0.5, 1.8, 0.3), 0.2), "upper") << "on a slope, where it is 1.25 m high";
  EXPECT_EQ(region_below<2>(model, circle(0.5, 1.8, 0.3), 0.5), "lower");
  EXPECT_EQ(region_below<2>(model, circle(1.5, 1.8, 0.3), 0.5), "upper") << "where it is 1.75 m high";
  model.ground.line.corners = {{0, 1.8}, {0.7, 1.8}, {0.7, 1.2}, {1.3, 1.2}, {1.3, 1.8}, {2, 1.8}};
  EXPECT_EQ(region_below<2>(model, circle(1, 1.8, 0.25), 0.5), "lower") << "in a trench";
  EXPECT_EQ(region_below<2>(model, circle(0.35, 1.8, 0.25), 0.5), "upper") << "beside it";
  model.surface = 1.8;
  model.ground.embedment_counts_from_it = false;
  EXPECT_EQ(region_below<2>(model, circle(1, 1.8, 0.25), 0.5), "upper") << "from the level that the input names";
}

}  // namespace
}  // namespace berm::problem::this_file
