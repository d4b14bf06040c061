// SPDX-License-Identifier: BSD-3-Clause
#include "structures/base/kind.hpp"

#include "samples/made_push.hpp"

#include <gtest/gtest.h>

namespace berm::base::this_file {
namespace {

std::string kind_with(const bodies::RigidShapeSettings& shape, problem::Geometry geometry = problem::Geometry::axisymmetric)
{
  MadePush made;
  made.shape = shape;
  made.geometry = geometry;
  return kind_of(made.settings());
}

bodies::ProfileSettings profile(std::vector<Real> x, std::vector<Real> y)
{
  return {std::move(x), std::move(y)};
}

TEST(Kind, of_a_body_around_an_axis_follows_from_its_profile)
{
  EXPECT_EQ(kind_with(MadePush::cone()), "cone");
  EXPECT_EQ(kind_with(profile({0, 0.1, 0.1, 0}, {0, 0, 3, 3})), "pile");
  EXPECT_EQ(kind_with(profile({0, 0.1, 0.1, 0}, {0, 0, 0.2, 0.2})), "footing");
  EXPECT_EQ(kind_with(profile({0, 0.07, 0.1, 0.1, 0}, {0, 0.03, 0.1, 3, 3})), "pile");  // a round tip
  EXPECT_EQ(kind_with(profile({0, 0.1, 0.1, 0}, {0, 0.02, 0.1, 0.1})), "footing");      // a spudcan: 157 degrees
  EXPECT_EQ(kind_with(bodies::BoxSettings{{0, 0.05}, {0.2, 0.1}, 0}), "footing");
  EXPECT_EQ(kind_with(bodies::CircleSettings{{0, 0.1}, 0.2}), "ball");
  EXPECT_EQ(kind_with(bodies::CircleSettings{{1, 0.1}, 0.2}), "pipe");  // a ring
}

TEST(Kind, of_a_circle_in_plane_strain_is_a_pipe_unless_it_begins_deep)
{
  EXPECT_EQ(kind_with(bodies::CircleSettings{{0, 0.1}, 0.2}, problem::Geometry::plane_strain), "pipe");
  EXPECT_EQ(kind_with(bodies::CircleSettings{{0, -0.25}, 0.2}, problem::Geometry::plane_strain), "pipe");
  EXPECT_EQ(kind_with(bodies::CircleSettings{{0, -0.35}, 0.2}, problem::Geometry::plane_strain), "t_bar");
  EXPECT_EQ(kind_with(bodies::BoxSettings{{0, 0.05}, {0.2, 0.1}, 0}, problem::Geometry::plane_strain), "footing");
}

TEST(Kind, is_that_which_the_input_names)
{
  problem::Case c = MadePush{}.settings();
  c.rigid[0].second.structure = "pile";
  EXPECT_EQ(kind_of(c), "pile");
  c.stage[0].kind = problem::StageKind::free;
  EXPECT_EQ(kind_of(c), "other");
}

TEST(Kind, of_what_is_dragged_or_lifted_alone_is_a_pipe)
{
  problem::Case c = MadePush{}.settings();
  c.stage[0].velocity = -0.1;
  EXPECT_EQ(kind_of(c), "pipe");
  c.stage[0].velocity = 0.1;
  c.stage[0].kind = problem::StageKind::drag;
  EXPECT_EQ(kind_of(c), "pipe");
}

TEST(Kind, a_cone_has_its_angle_and_the_height_of_its_shoulder)
{
  const BodyProfile cone = *body_profile(MadePush::cone());
  EXPECT_TRUE(cone.conical);
  EXPECT_NEAR(cone.apex_angle(), 60 * degree, 1e-12);
  EXPECT_NEAR(cone.shoulder, 0.1 * std::sqrt(3.), 1e-12);
  EXPECT_NEAR(cone.width, 0.2, 1e-12);
  const BodyProfile ball = *body_profile(bodies::CircleSettings{{0, 0.1}, 0.2});
  EXPECT_EQ(ball.shoulder, 0.1);
  EXPECT_FALSE(body_profile(bodies::HalfPlaneSettings{}).has_value());
}

}  // namespace
}  // namespace berm::base::this_file
