// SPDX-License-Identifier: BSD-3-Clause
#include "bodies/rigid/proximity.hpp"

#include <gtest/gtest.h>

namespace berm::bodies::this_file {
namespace {

template <int dim>
ProximityPoints<dim> points_of(const RigidShapeSettings& first, const RigidShapeSettings& second, const Pose<dim>& first_pose = {},
                               const Pose<dim>& second_pose = {})
{
  RigidBody<dim> a, b;
  a.shape = make_shape<dim>(first), b.shape = make_shape<dim>(second);
  return proximity_points(*proximity_of<dim>(first, second), a, first_pose, b, second_pose, 1);
}

TEST(Proximity, of_two_circles_lies_on_the_line_between_their_centres)
{
  const auto found = points_of<2>(CircleSettings{{0, 0}, 2}, CircleSettings{{3, 4}, 4});
  ASSERT_EQ(found.count, 0) << "2 m apart, and 1 m is asked for";
  const auto near = points_of<2>(CircleSettings{{0, 0}, 2}, CircleSettings{{3, 4}, 7});
  ASSERT_EQ(near.count, 1);
  EXPECT_NEAR(near.points[0].gap, 0.5, 1e-15);
  EXPECT_LE((near.points[0].normal - Vec<2>(-0.6, -0.8)).norm(), 1e-15) << "out of the second";
  EXPECT_LE((near.points[0].position - Vec<2>(0.9, 1.2)).norm(), 1e-15) << "on the second";
}

TEST(Proximity, of_a_circle_and_a_corner_goes_through_the_corner_whichever_is_first)
{
  const RigidShapeSettings circle = CircleSettings{{2, 2}, 2}, box = BoxSettings{{0, 0}, {2, 2}};
  const Real gap = std::sqrt(2.) - 1, half = std::sqrt(0.5);
  const auto circle_first = points_of<2>(circle, box), box_first = points_of<2>(box, circle);
  ASSERT_EQ(circle_first.count, 1);
  ASSERT_EQ(box_first.count, 1);
  EXPECT_NEAR(circle_first.points[0].gap, gap, 1e-15);
  EXPECT_NEAR(box_first.points[0].gap, gap, 1e-15);
  EXPECT_LE((circle_first.points[0].position - Vec<2>(1, 1)).norm(), 1e-15);
  EXPECT_LE((box_first.points[0].position - Vec<2>(2 - half, 2 - half)).norm(), 1e-15);
  EXPECT_LE((circle_first.points[0].normal + box_first.points[0].normal).norm(), 1e-15);
}

// A box 2 m wide stands with a gap of 0.1 m on one 4 m wide: two corners of the upper one. Turned by a right angle it is as wide as high, and shifted by its pose.
TEST(Proximity, of_two_boxes_is_at_the_corners_of_either)
{
  const RigidShapeSettings upper = BoxSettings{{0, 1.1}, {2, 2}}, lower = BoxSettings{{0, -0.5}, {4, 1}};
  for (const Real angle : {0., pi / 2}) {
    Pose<2> pose;
    pose.orientation.angle = angle;
    pose.displacement = {0.5, 0};
    const auto found = points_of<2>(upper, lower, pose);
    ASSERT_EQ(found.count, 3) << "and farther the lower one's corner";
    for (int k = 0; k < 2; ++k) {
      EXPECT_NEAR(found.points[k].gap, 0.1, 1e-14);
      EXPECT_LE((found.points[k].normal - Vec<2>(0, 1)).norm(), 1e-14);
      EXPECT_NEAR(std::abs(found.points[k].position[0] - 0.5), 1, 1e-14);
    }
  }
  const auto turned_round = points_of<2>(lower, upper);
  ASSERT_EQ(turned_round.count, 2);
  EXPECT_LE((turned_round.points[0].normal - Vec<2>(0, -1)).norm(), 1e-14);
  EXPECT_NEAR(turned_round.points[0].position[1], 0.1, 1e-14) << "on the second: the upper one's base";
}

TEST(Proximity, in_space_is_known_of_spheres_and_of_circles_along_z)
{
  const SphereSettings sphere{{0, 2, 5}, 2};
  const CircleSettings circle{{0, 0, 0}, 1};
  const auto found = points_of<3>(circle, sphere);
  ASSERT_EQ(found.count, 1);
  EXPECT_NEAR(found.points[0].gap, 0.5, 1e-15);
  EXPECT_LE((found.points[0].normal - Vec<3>(0, -1, 0)).norm(), 1e-15);
  EXPECT_LE((found.points[0].position - Vec<3>(0, 1, 5)).norm(), 1e-15);
  EXPECT_TRUE(proximity_of<3>(circle, circle));
  EXPECT_TRUE(proximity_of<3>(circle, HalfPlaneSettings{{0, -1, 0}, {0, 1, 0}}));
  const BoxSettings box{{0, 0, 0}, {1, 1, 1}};
  EXPECT_FALSE(proximity_of<3>(box, box));
  EXPECT_FALSE(proximity_of<3>(box, circle));
  EXPECT_TRUE(proximity_of<3>(box, sphere));
}

}  // namespace
}  // namespace berm::bodies::this_file
