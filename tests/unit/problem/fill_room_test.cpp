// SPDX-License-Identifier: BSD-3-Clause
#include "problem/fill_room.hpp"

#include "samples/sample_case.hpp"

#include <gtest/gtest.h>

namespace berm::problem::this_file {
namespace {

/// The area of a triangle with the corners (0.3, 0.2), (1.7, 0.2), (0.3, 1.6) in a box of 2 m.
Problem<2> with_triangle(settings::Geometry geometry)
{
  settings::Case c = pipe_over_box({stage_of(settings::StageKind::free, "works")});
  c.rigid.clear();
  c.geometry = geometry;
  std::get<mesh::BoxMesh>(c.mesh).cells = {7, 7};
  bodies::FillSettings fill;
  fill.name = "fill";
  fill.stage = "works";
  fill.material = "solid";
  fill.area = {{0.3, 1.7, 0.3}, {0.2, 0.2, 1.6}};
  c.body[0].second.fill = {fill};
  return build<2>(c, ".", ".");
}

/// Cells at the bounds are divided by forty: to a hundredth of a cell along these.
constexpr Real of_bounds = 0.01 * 2. / 7 * 5;

TEST(WorkRegion, has_the_volume_of_its_polygon_between_two_levels)
{
  const Problem<2> problem = with_triangle(settings::Geometry::plane_strain);
  const Earthwork<2>& work = problem.model.earthworks[0];
  EXPECT_NEAR((WorkRegion<2>{problem.model, work, {-infinity, infinity}}.volume()), 1.4 * 1.4 / 2, of_bounds);
  EXPECT_NEAR((WorkRegion<2>{problem.model, work, {0.9, infinity}}.volume()), 0.7 * 0.7 / 2, of_bounds);
}

TEST(WorkRegion, has_it_per_radian_around_an_axis)
{
  const Problem<2> problem = with_triangle(settings::Geometry::axisymmetric);
  const Real center = 0.3 + 1.4 / 3;
  EXPECT_NEAR((WorkRegion<2>{problem.model, problem.model.earthworks[0], {-infinity, infinity}}.volume()), 1.4 * 1.4 / 2 * center,
              of_bounds);
}

TEST(WorkRegion, leaves_out_rigid_bodies)
{
  const Problem<2> problem = with_triangle(settings::Geometry::plane_strain);
  const bodies::RigidShape<2> disk = bodies::make_shape<2>(bodies::CircleSettings{{0.7, 0.6}, 0.4});
  EXPECT_NEAR((WorkRegion<2>{problem.model, problem.model.earthworks[0], {-infinity, infinity}, {disk}}.volume()),
              1.4 * 1.4 / 2 - pi * 0.04, of_bounds);
}

TEST(WorkRegion, tells_the_part_of_a_particle_that_lies_in_it)
{
  const Problem<2> problem = with_triangle(settings::Geometry::plane_strain);
  const WorkRegion<2> region{problem.model, problem.model.earthworks[0], {-infinity, infinity}};
  EXPECT_EQ(region.fraction_within({0.6, 0.5}, 0.01), 1);
  EXPECT_EQ(region.fraction_within({1.5, 1.5}, 0.01), 0);
  EXPECT_NEAR(region.fraction_within({0.6, 0.2}, 0.01), 0.5, 1e-12);
  EXPECT_NEAR(region.fraction_within({0.32, 0.5}, 0.01), 0.7, 1e-12) << "0.05 of 0.1 m to its right, 0.02 to its left";
}

}  // namespace
}  // namespace berm::problem::this_file
