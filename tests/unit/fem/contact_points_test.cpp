// SPDX-License-Identifier: BSD-3-Clause
#include "fem/contact_points.hpp"

#include "samples/fem_sample_bed.hpp"

#include <gtest/gtest.h>

namespace berm::fem::this_file {
namespace {

const FemInterface rough{0.5, 0, false, 1e6};
const Vec<2> normal = Vec<2>(3, 4) / 5;
const Vec<2> tangent = Vec<2>(-4, 3) / 5;

Real pressure(const FemTraction& now)
{
  return now.state.traction.dot(normal);
}
Real shear(const FemTraction& now)
{
  return now.state.traction.dot(tangent);
}

// Tractions are some thousand pascal: 1e-9 is rounding.
constexpr Real rounding = 1e-9;

TEST(UpdateTraction, is_zero_where_the_soil_is_off_the_body)
{
  const FemTraction now = update_traction(rough, normal, {}, 1e-3 * normal + 5e-3 * tangent);
  EXPECT_EQ(now.state.traction, Vec<2>(0, 0));
  EXPECT_EQ(now.stiffness, Matrix<2>(Matrix<2>::Zero()));
  EXPECT_NEAR(now.state.gap, 1e-3, 1e-15);
}

TEST(UpdateTraction, a_point_that_just_touches_carries_nothing_but_is_stiff)
{
  const FemTraction now = update_traction(rough, normal, {}, Vec<2>::Zero());
  EXPECT_EQ(now.state.traction.norm(), 0);
  EXPECT_LT((now.stiffness + 1e6 * Matrix<2>::Identity()).norm(), 1e-9);
}

TEST(UpdateTraction, pushes_the_soil_out_and_holds_it_while_friction_suffices)
{
  const FemTraction now = update_traction(rough, normal, {}, -2e-3 * normal + 0.5e-3 * tangent);
  EXPECT_NEAR(pressure(now), 2000, rounding);
  EXPECT_NEAR(shear(now), -500, rounding);  // against the movement
  EXPECT_NEAR(now.state.gap, -2e-3, 1e-15);
}

TEST(UpdateTraction, slides_both_ways_at_friction_times_pressure)
{
  for (const Real way : {1., -1.}) {
    const FemTraction now = update_traction(rough, normal, {}, -2e-3 * normal + way * 5e-3 * tangent);
    EXPECT_NEAR(pressure(now), 2000, rounding);
    EXPECT_NEAR(shear(now), -way * 1000, rounding);
  }
}

TEST(UpdateTraction, friction_acts_on_what_the_water_does_not_carry)
{
  for (const Real share : {-0.5, 0., 0.4, 1.2}) {
    FemInterface wet = rough;
    wet.pore_pressure = share * 2000;
    const FemTraction now = update_traction(wet, normal, {}, -2e-3 * normal + 5e-3 * tangent);
    EXPECT_NEAR(pressure(now), 2000, rounding);
    EXPECT_NEAR(shear(now), -1000 * std::max(0., 1 - share), rounding);
  }
}

TEST(UpdateTraction, adhesion_adds_to_the_friction_of_closed_points_alone)
{
  FemInterface adhesive = rough;
  adhesive.adhesion = 300;
  EXPECT_NEAR(shear(update_traction(adhesive, normal, {}, -2e-3 * normal + 5e-3 * tangent)), -1300, rounding);
  EXPECT_EQ(update_traction(adhesive, normal, {}, 1e-6 * normal + 5e-3 * tangent).state.traction.norm(), 0);
}

TEST(UpdateTraction, adhesion_ends_without_a_jump_where_a_point_opens)
{
  FemInterface clay = rough;
  clay.friction = 0;
  clay.adhesion = 300;
  // The full adhesion from a tenth of it as pressure on; below, ten times the pressure.
  EXPECT_NEAR(shear(update_traction(clay, normal, {}, -31e-6 * normal + 5e-3 * tangent)), -300, rounding);
  EXPECT_NEAR(shear(update_traction(clay, normal, {}, -10e-6 * normal + 5e-3 * tangent)), -100, rounding);
  EXPECT_NEAR(shear(update_traction(clay, normal, {}, -1e-9 * normal + 5e-3 * tangent)), -0.01, rounding);
}

TEST(UpdateTraction, goes_on_from_the_shear_that_was_there)
{
  const FemContactState before{-2e-3, 2000 * normal + 800 * tangent};
  EXPECT_NEAR(shear(update_traction(rough, normal, before, 0.3e-3 * tangent)), 500, rounding);
  EXPECT_NEAR(shear(update_traction(rough, normal, before, -0.3e-3 * tangent)), 1000, rounding);
}

TEST(UpdateTraction, a_gap_must_close_before_it_carries)
{
  const FemContactState open{1e-3, Vec<2>::Zero()};
  EXPECT_EQ(update_traction(rough, normal, open, -0.9e-3 * normal).state.traction.norm(), 0);
  EXPECT_NEAR(pressure(update_traction(rough, normal, open, -3e-3 * normal)), 2000, rounding);
}

TEST(UpdateTraction, a_sticking_surface_pulls_too)
{
  FemInterface glue = rough;
  glue.tied = true;
  const FemTraction now = update_traction(glue, normal, {}, 1e-3 * normal + 5e-3 * tangent);
  EXPECT_NEAR(pressure(now), -1000, rounding);
  EXPECT_NEAR(shear(now), -5000, rounding);
}

TEST(UpdateTraction, stiffness_is_the_derivative_of_the_traction)
{
  FemInterface glue = rough, clay = rough, bonded = rough;
  bonded.tension = 1500;
  glue.tied = true;
  clay.friction = 0;
  clay.adhesion = 400;
  const FemContactState before{-1e-3, 1000 * normal + 100 * tangent};
  // Open, sticking, sliding either way; far from where one becomes the other.
  for (const FemInterface& interface : {rough, glue, clay, bonded})
    for (const Vec<2>& local : {Vec<2>(2e-3, 0), Vec<2>(-1e-3, 1e-4), Vec<2>(-1e-3, 5e-3), Vec<2>(-1e-3, -5e-3)}) {
      const Vec<2> movement = local[0] * normal + local[1] * tangent;
      const Matrix<2> stiffness = update_traction(interface, normal, before, movement).stiffness;
      for (int d = 0; d < 2; ++d) {
        // The traction is linear between its kinks: differences are exact, to rounding of 1e-12 Pa over the step of 1e-5 m.
        const Vec<2> step = 1e-5 * Vec<2>::Unit(d);
        const Vec<2> slope = (update_traction(interface, normal, before, movement + step).state.traction -
                              update_traction(interface, normal, before, movement - step).state.traction) /
                             2e-5;
        EXPECT_LT((stiffness.col(d) - slope).norm(), 1e-6) << "along " << d << " at " << local.transpose();
      }
    }
}

TEST(UpdateTraction, a_bonded_point_pulls_up_to_its_tension_and_keeps_its_adhesion)
{
  const FemInterface clay{0.5, 300, false, 1e6, 2000};
  const FemTraction held = update_traction(clay, normal, {}, 1e-3 * normal + 5e-3 * tangent);
  EXPECT_NEAR(pressure(held), -1000, rounding);
  EXPECT_NEAR(shear(held), -300, rounding);
  EXPECT_NEAR(held.state.slip, 4.7e-3, 1e-12);  // 5 mm less what 300 Pa stretch the spring by
  EXPECT_FALSE(parts(clay, held.state));
  const FemTraction at_limit = update_traction(clay, normal, {}, 3e-3 * normal);
  EXPECT_NEAR(pressure(at_limit), -2000, rounding);
  EXPECT_TRUE(parts(clay, at_limit.state));
}

TEST(UpdateTraction, a_point_that_has_parted_pulls_no_more_even_where_it_was_pressed_on_again)
{
  const FemInterface clay{0, 0, false, 1e6, 2000};
  FemContactState parted;
  parted.parted = 1;
  EXPECT_EQ(update_traction(clay, normal, parted, 1e-3 * normal).state.traction.norm(), 0);
  const FemTraction pressed = update_traction(clay, normal, parted, -1e-3 * normal);
  EXPECT_NEAR(pressure(pressed), 1000, rounding);
  EXPECT_EQ(update_traction(clay, normal, pressed.state, 2e-3 * normal).state.traction.norm(), 0);
}

class PointsOfPipe : public testing::TestWithParam<Real> {
protected:
  settings::Case c = bed_around(pipe_at(GetParam()));
  bodies::Circle<2> circle = std::get<bodies::Circle<2>>(shapes_of(c)[0]);
  QuadraticMesh mesh = quadratic_mesh_of(c);
  std::vector<BoundarySide> skin = contact_sides(mesh, circle);
  std::vector<FemContactPoint> points = make_contact_points(skin, mesh.position, circle);
};

TEST_P(PointsOfPipe, stand_for_the_length_of_the_arc)
{
  const Real half_angle = circle.center[1] < -circle.radius ? pi : std::acos(circle.center[1] / circle.radius);
  Real sum = 0;
  for (const FemContactPoint& point : points) sum += point.area;
  // The parabola of a side of half angle a = 0.05 is a part a^4 / 30 = 2e-7 longer or shorter than its arc, and Simpson's rule as much off again.
  EXPECT_NEAR(sum / (2 * half_angle * circle.radius), 1, 1e-6);
}

TEST_P(PointsOfPipe, have_the_normal_of_the_circle_and_their_arm_from_its_centre)
{
  for (const FemContactPoint& point : points) {
    const Vec<2> arm = mesh.position[point.node] - circle.center;
    EXPECT_EQ(point.arm, arm);
    EXPECT_NEAR(point.normal.norm(), 1, 1e-15);
    // The normal is taken a thousandth of half a side (0.01 m) from the point: at the end of the arc 5e-5 rad off.
    EXPECT_LT((point.normal - arm.normalized()).norm(), 1e-3 * 0.011 / circle.radius);
  }
}

TEST_P(PointsOfPipe, are_one_for_each_node_on_the_arc)
{
  EXPECT_EQ(points.size(), 2 * skin.size() + (circle.center[1] < -circle.radius ? 0 : 1));
}

INSTANTIATE_TEST_SUITE_P(At, PointsOfPipe, testing::Values(0.04, 0.2, 0.7));  // D/10, D/2, buried

TEST(ContactPoints, at_the_corner_of_a_box_have_the_normal_of_both_sides_by_their_length)
{
  // Sides of 0.2 m below and 0.1 m at the right of the corner (1, -1).
  NodeField<Vec<2>> position;
  for (const Vec<2>& x : {Vec<2>(0.8, -1), Vec<2>(0.9, -1), Vec<2>(1, -1), Vec<2>(1, -0.95), Vec<2>(1, -0.9)}) position.push_back(x);
  const bodies::RigidShape<2> box = make_shape<2>(bodies::BoxSettings{{0, 0}, {2, 2}});
  const auto points = make_contact_points({{2, 0, 1}, {4, 2, 3}}, position, box);
  ASSERT_EQ(points.size(), 5u);
  EXPECT_LT((points[2].normal - Vec<2>(0.1, -0.2).normalized()).norm(), 1e-12);
  EXPECT_NEAR(points[2].area, (0.2 + 0.1) / 6, 1e-15);
  EXPECT_LT((points[0].normal - Vec<2>(0, -1)).norm(), 1e-15);
  EXPECT_LT((points[4].normal - Vec<2>(1, 0)).norm(), 1e-15);
  EXPECT_NEAR(points[1].area, 4 * 0.2 / 6, 1e-15);
  EXPECT_NEAR(points[3].area, 4 * 0.1 / 6, 1e-15);
}

}  // namespace
}  // namespace berm::fem::this_file
