// SPDX-License-Identifier: BSD-3-Clause

#include "os/error.hpp"
#include "samples/sample_case.hpp"

#include <gtest/gtest.h>

namespace berm::problem::this_file {
namespace {

/// A ball of 0.4 m above the axis of an elastic cylinder, pushed by a force of 100 N until the soil bears 50 N.
settings::Case ball_over_cylinder()
{
  settings::StageSettings push = stage_of(settings::StageKind::push, "push");
  push.force = 100;
  push.until.force = 50;
  settings::Case c = pipe_over_box({push});
  c.geometry = settings::Geometry::axisymmetric;
  c.rigid[0].second.shape = bodies::CircleSettings{{0, 1.3}, 0.4};
  return c;
}

TEST(PerRadian, masses_and_forces_are_a_radian_s_part_of_the_input)
{
  const Model<2> model = build<2>(ball_over_cylinder(), ".", ".").model;
  EXPECT_DOUBLE_EQ(model.rigid_bodies[0].mass, 2 / (2 * pi));
  EXPECT_DOUBLE_EQ(*model.stages[0].force, 100 / (2 * pi));
  EXPECT_DOUBLE_EQ(*model.stages[0].until.force, 50 / (2 * pi));
}

TEST(PerRadian, plane_strain_is_left_as_it_is)
{
  settings::Case c = ball_over_cylinder();
  c.geometry = settings::Geometry::plane_strain;
  const Model<2> model = build<2>(c, ".", ".").model;
  EXPECT_EQ(model.rigid_bodies[0].mass, 2);
  EXPECT_EQ(*model.stages[0].force, 100);
  EXPECT_EQ(model.mesh.metric, mesh::Metric::cartesian);
}

TEST(Axis, is_held_across_without_a_support)
{
  const Model<2> model = build<2>(ball_over_cylinder(), ".", ".").model;
  int on_axis = 0;
  for (Index i = 0; i < model.mesh.node_count(); ++i) {
    const bool axis = model.mesh.position[i][0] == 0;
    EXPECT_EQ(model.conditions.tables[0].held[i], axis ? 1 : 0);
    on_axis += axis;
  }
  EXPECT_EQ(on_axis, 5);
}

TEST(Axis, a_mesh_beyond_it_is_refused_and_one_that_round_off_puts_there_is_not)
{
  settings::Case c = ball_over_cylinder();
  auto& box = std::get<mesh::BoxMesh>(c.mesh);
  box.lower = {-0.1, 0};
  EXPECT_THROW(build<2>(c, ".", "."), KeyError);
  box.lower = {-1e-12, 0};
  EXPECT_EQ(build<2>(c, ".", ".").model.mesh.lower[0], 0);
}

TEST(Metric, of_the_mesh_weighs_cells_with_the_radius_and_their_sections_without)
{
  const mesh::Mesh<2> mesh = build<2>(ball_over_cylinder(), ".", ".").model.mesh;
  Real volume = 0, section = 0;
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) volume += mesh.volume(cell), section += mesh.section(cell);
  EXPECT_NEAR(section, 4, 1e-13);
  EXPECT_NEAR(volume, 2 * 2 * 2 / 2., 1e-13);  // R^2 / 2 times the height
}

}  // namespace
}  // namespace berm::problem::this_file
