// SPDX-License-Identifier: BSD-3-Clause
#include "bodies/rigid/dynamics.hpp"

#include <gtest/gtest.h>

namespace berm::bodies::this_file {
namespace {

constexpr Real dt = 1e-3;

/// A disk of 2 kg/m and 0.04 kg m, at rest.
struct Disk {
  RigidBody<2> body{"disk", make_shape<2>(CircleSettings{{1, 1.3}, 0.4}), 2, Motion::driven, Rotation::free, 0.04};
  RigidState<2> state{};

  void step(const DriveNow<2>& drive, const Vec<2>& arm) { drive_body(body, state, drive, dt, arm); }
};

// By hand, 0.2 m above the centre: J = 0.3/(1/m + 0.2^2/I) = 0.2 N s/m, so v = 0.1 m/s and omega = -1 rad/s.
TEST(DriveAtAPoint, gives_that_point_its_velocity_and_turns_the_body)
{
  Disk disk;
  disk.step({{false, true, true}, {0.3, 0, 0}}, {0, 0.2});
  EXPECT_NEAR(disk.state.velocity[0], 0.1, 1e-14);
  EXPECT_NEAR(disk.state.velocity[1], 0, 1e-14);
  EXPECT_NEAR(disk.state.angular_velocity, -1, 1e-13);
}

TEST(DriveAtAPoint, is_that_at_the_centre_where_the_body_does_not_turn)
{
  Disk disk, other;
  disk.state.reaction = other.state.reaction = {3, 7};
  disk.step({{false, true, false}, {0.3, -50, 0}}, {0, 0});
  other.step({{false, true, false}, {0.3, -50, 0}}, {0.1, 0.1});
  EXPECT_NEAR((disk.state.velocity - other.state.velocity).norm(), 0, 1e-15);
  EXPECT_EQ(other.state.angular_velocity, 0);
}

TEST(DriveAtAPoint, by_a_force_turns_by_its_moment)
{
  Disk disk;
  disk.step({{true, true, true}, {6, 0, 0}}, {0, 0.2});
  EXPECT_NEAR(disk.state.velocity[0], dt * 6 / 2, 1e-15);
  EXPECT_NEAR(disk.state.velocity[1], 0, 1e-15);
  EXPECT_NEAR(disk.state.angular_velocity, -dt * 6 * 0.2 / 0.04, 1e-13);
}

TEST(DriveAtAPoint, of_a_body_whose_turning_is_given_carries_the_centre_around_the_point)
{
  Disk disk;
  disk.step({{false, false, false}, {0, 0, 2}}, {0, 0.2});
  EXPECT_NEAR(disk.state.velocity[0], 2 * 0.2, 1e-14);
  EXPECT_NEAR(disk.state.velocity[1], 0, 1e-14);
  EXPECT_NEAR(disk.state.angular_velocity, 2, 1e-15);
}

}  // namespace
}  // namespace berm::bodies::this_file
