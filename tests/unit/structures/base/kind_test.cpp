// SPDX-License-Identifier: BSD-3-Clause
#include "structures/base/kind.hpp"

#include "samples/made_push.hpp"

#include <gtest/gtest.h>

namespace berm::base::this_file {
namespace {

std::string kind_with(const bodies::RigidShapeSettings& shape, settings::Geometry geometry = settings::Geometry::axisymmetric)
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
  EXPECT_EQ(kind_with(bodies::CircleSettings{{0, 0.1}, 0.2}, settings::Geometry::plane_strain), "pipe");
  EXPECT_EQ(kind_with(bodies::CircleSettings{{0, -0.25}, 0.2}, settings::Geometry::plane_strain), "pipe");
  EXPECT_EQ(kind_with(bodies::CircleSettings{{0, -0.35}, 0.2}, settings::Geometry::plane_strain), "t_bar");
  EXPECT_EQ(kind_with(bodies::BoxSettings{{0, 0.05}, {0.2, 0.1}, 0}, settings::Geometry::plane_strain), "footing");
}

TEST(Kind, is_that_which_the_input_names)
{
  settings::Case c = MadePush{}.settings();
  c.rigid[0].second.structure = "pile";
  EXPECT_EQ(kind_of(c), "pile");
  c.stage[0].kind = settings::StageKind::free;
  EXPECT_EQ(kind_of(c), "other");
}

TEST(Kind, of_what_is_dragged_or_lifted_alone_is_a_pipe)
{
  settings::Case c = MadePush{}.settings();
  c.stage[0].velocity = -0.1;
  EXPECT_EQ(kind_of(c), "pipe");
  c.stage[0].velocity = 0.1;
  c.stage[0].kind = settings::StageKind::drag;
  EXPECT_EQ(kind_of(c), "pipe");
}

TEST(Kind, of_a_body_that_is_open_below_is_a_skirt_where_its_wall_is_slender)
{
  EXPECT_EQ(kind_with(profile({1.9, 2, 2, 1.9}, {0, 0, 4, 4})), "skirt");
  EXPECT_EQ(kind_with(profile({0, 1.9, 1.9, 2, 2, 0}, {3.9, 3.9, 0, 0, 4, 4})), "skirt");  // with a lid
  EXPECT_EQ(kind_with(profile({1.9, 1.95, 2, 2, 1.9}, {0.1, 0, 0.1, 4, 4})), "skirt");     // its tip cut askew
  EXPECT_EQ(kind_with(profile({1, 2, 2, 1}, {0, 0, 0.5, 0.5})), "footing");                // a flat ring
  EXPECT_EQ(kind_with(profile({0, 1, 1, 2, 2, 0}, {0.2, 0.2, 0, 0, 4, 4})), "footing");    // a recess
  EXPECT_EQ(kind_with(profile({0, 1, 2, 2, 0}, {0.2, 0.2, 0, 9, 9})), "pile");             // a hollow base
  EXPECT_EQ(kind_with(profile({1.9, 2, 2, 1.9}, {0, 0, 4, 4}), settings::Geometry::space), "skirt");
}

TEST(Kind, of_a_body_that_stands_in_the_bed_and_is_loaded_sideways_is_a_pile_or_a_skirt)
{
  const auto kind_sideways = [](const bodies::RigidShapeSettings& shape, const auto& change) {
    MadePush made;
    made.shape = shape;
    made.geometry = settings::Geometry::space;
    settings::Case c = made.settings();
    c.gravity = {0, -standard_gravity, 0};
    c.stage[0].kind = settings::StageKind::drive;
    c.stage[0].velocity.reset();
    c.stage[0].drive.x.velocity = 0.1;
    change(c);
    return kind_of(c);
  };
  const auto as_it_is = [](settings::Case&) {};
  const bodies::CylinderSettings pile{{0, -2, 0}, {0, 1, 0}, 2, 12};
  EXPECT_EQ(kind_sideways(pile, as_it_is), "pile");
  EXPECT_EQ(kind_sideways(bodies::CylinderSettings{{0, -1, 0}, {0, 1, 0}, 2, 2.5}, as_it_is), "pile");  // a caisson
  EXPECT_EQ(kind_sideways(profile({1.9, 2, 2, 1.9}, {-4, -4, 0, 0}), as_it_is), "skirt");
  EXPECT_EQ(kind_sideways(pile, [](settings::Case& c) { c.stage[0].drive = {}, c.stage[0].drive.z.force = 5; }), "pile");
  EXPECT_EQ(kind_sideways(pile, [](settings::Case& c) { c.stage[0].kind = settings::StageKind::drag, c.stage[0].velocity = -1; }), "pile");
  EXPECT_EQ(kind_sideways(pile, [](settings::Case& c) { c.stage[0].drive = {}, c.stage[0].drive.y.force = 5; }), "other");  // pulled up
  EXPECT_EQ(kind_sideways(bodies::CylinderSettings{{0, 5.2, 0}, {0, 1, 0}, 2, 12}, as_it_is), "other");                     // 0.4 D deep
  EXPECT_EQ(kind_sideways(bodies::CylinderSettings{{0, -2, 0}, {1, 0, 0}, 2, 12}, as_it_is), "other");                      // it lies
  EXPECT_EQ(kind_sideways(bodies::SphereSettings{{0, -2, 0}, 2}, as_it_is), "other");
  EXPECT_EQ(kind_sideways(pile, [](settings::Case& c) { c.rigid[0].second.structure = "anchor"; }), "other");
  EXPECT_EQ(kind_sideways(pile, [](settings::Case& c) { c.rigid[0].second.structure = "skirt"; }), "skirt");
}

TEST(Kind, a_ring_has_its_outer_width_and_its_bore)
{
  const BodyProfile ring = *body_profile(profile({1.9, 2, 2, 1.9}, {0, 0, 4, 4}));
  EXPECT_NEAR(ring.width, 4, 1e-12);
  EXPECT_NEAR(ring.bore, 1.9, 1e-12);
  EXPECT_NEAR(ring.wall(), 0.1, 1e-12);
  EXPECT_TRUE(std::isinf(ring.lid));
  const BodyProfile bucket = *body_profile(profile({0, 2, 2, 1.8, 1.8, 0}, {4, 4, -1, -1, 3, 3}));
  EXPECT_NEAR(bucket.bore, 1.8, 1e-12);
  EXPECT_NEAR(bucket.lid, 4, 1e-12);
  EXPECT_EQ(body_profile(MadePush::cone())->bore, 0);
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
