// SPDX-License-Identifier: BSD-3-Clause

#include "os/error.hpp"
#include "samples/sample_case.hpp"

#include <gtest/gtest.h>

namespace berm::problem::this_file {
namespace {

/// A quarter of a ball of 0.4 m above a quarter of an elastic block, pushed by a force of 100 N on the whole until the soil bears 50 N.
settings::Case quarter_of_ball()
{
  settings::StageSettings push = stage_of(settings::StageKind::push, "push");
  push.force = 100;
  push.until.force = 50;
  settings::Case c = pipe_over_box({push});
  c.geometry = settings::Geometry::space;
  c.symmetry = {"x", "z"};
  mesh::BoxMesh box;
  box.lower = {1, 0, 3};
  box.size = {1, 2, 1};
  box.cells = {2, 4, 2};
  c.mesh = box;
  c.rigid[0].second.shape = bodies::SphereSettings{{1, 1.3, 3}, 0.4};
  return c;
}

TEST(Symmetry, masses_and_forces_are_a_quarter_of_the_input)
{
  const Model<3> model = build<3>(quarter_of_ball(), ".", ".").model;
  EXPECT_EQ(model.parts, 4);
  EXPECT_DOUBLE_EQ(model.rigid_bodies[0].mass, 2. / 4);
  EXPECT_DOUBLE_EQ(*model.stages[0].force, 100. / 4);
  EXPECT_DOUBLE_EQ(*model.stages[0].until.force, 50. / 4);
}

TEST(Symmetry, planes_are_held_across_and_only_across_without_a_support)
{
  const Model<3> model = build<3>(quarter_of_ball(), ".", ".").model;
  for (Index i = 0; i < model.mesh.node_count(); ++i) {
    const Vec<3>& x = model.mesh.position[i];
    EXPECT_EQ(model.conditions.tables[0].held[i], (x[0] == 1 ? 1 : 0) + (x[2] == 3 ? 4 : 0));
  }
}

TEST(Symmetry, a_case_without_is_left_as_it_is)
{
  settings::Case c = quarter_of_ball();
  c.symmetry.clear();
  const Model<3> model = build<3>(c, ".", ".").model;
  EXPECT_EQ(model.parts, 1);
  EXPECT_EQ(model.rigid_bodies[0].mass, 2);
  EXPECT_EQ(model.conditions.tables[0].held[0], 0);
}

TEST(Symmetry, refuses_a_rigid_body_that_its_plane_does_not_halve)
{
  settings::Case c = quarter_of_ball();
  std::get<bodies::SphereSettings>(c.rigid[0].second.shape).center[2] = 3.1;
  EXPECT_THROW(build<3>(c, ".", "."), KeyError);
  c.symmetry = {"x"};
  EXPECT_NO_THROW(build<3>(c, ".", "."));
  c.rigid[0].second.shape = bodies::HalfPlaneSettings{{0, 0, 0}, {0.1, 1, 0}};
  EXPECT_THROW(build<3>(c, ".", "."), KeyError);
}

TEST(Symmetry, refuses_a_rigid_body_that_leans_and_takes_one_that_does_not)
{
  const auto refusal = [](const bodies::RigidShapeSettings& shape) {
    settings::Case c = quarter_of_ball();
    c.symmetry = {"z"};
    c.rigid[0].second.shape = shape;
    try {
      build<3>(c, ".", ".");
    } catch (const KeyError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const auto cylinder = [](Vec<3> axis) {
    bodies::CylinderSettings s;
    s.center = {1, 1.5, 3};
    s.axis = {axis[0], axis[1], axis[2]};
    s.diameter = 0.2, s.length = 0.6;
    return s;
  };
  const auto box = [](std::vector<Real> rotation) {
    bodies::BoxSettings s;
    s.center = {1, 1.5, 3};
    s.size = {0.2, 0.3, 0.4};
    s.rotation = rotation;
    return s;
  };
  for (const Vec<3>& axis : {Vec<3>(0, 0, 1), Vec<3>(1, 0, 0), Vec<3>(1, 2, 0)}) EXPECT_EQ(refusal(cylinder(axis)), "") << axis.transpose();
  EXPECT_EQ(refusal(box({})), "");
  EXPECT_EQ(refusal(box({0, 0, 0.3})), "");
  bodies::ProfileSettings cone;
  cone.x = {0, 0.2, 0};
  cone.y = {0, 0.3, 0.3};
  cone.position = {1, 1.3, 3};
  EXPECT_EQ(refusal(cone), "");
  cone.axis = {1, 1, 0};
  EXPECT_EQ(refusal(cone), "");
  for (const std::string& message :
       {refusal(cylinder({0, 0.01, 1})), refusal(cylinder({1, 0, 1})), refusal(box({0.01, 0, 0})), refusal(box({0, 0.3, 0}))})
    EXPECT_NE(message.find("rigid.pipe: is not its own mirror image across the plane of symmetry z = 3 m: rotate it"), std::string::npos)
        << message;
}

}  // namespace
}  // namespace berm::problem::this_file
