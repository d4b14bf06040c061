// SPDX-License-Identifier: BSD-3-Clause
#include "bodies/rigid/rigid_body.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace berm::bodies::this_file {
namespace {

using Kind = SurfaceMesh<2>::Kind;

Real random_number(Real min, Real max)
{
  return min + (max - min) * *rc::gen::inRange(0, 1000001) / 1e6;
}

template <int dim>
void half_plane_is_clipped_to_the_box()
{
  Vec<dim> lower, upper, normal, point;
  for (int d = 0; d < dim; ++d) {
    lower[d] = random_number(-2, 0);
    upper[d] = lower[d] + random_number(0.5, 3);
    point[d] = random_number(lower[d], upper[d]);
    normal[d] = random_number(-1, 1);
  }
  RC_PRE(normal.norm() > 0.1);
  const HalfPlane<dim> plane{point, normal.normalized()};
  const SurfaceMesh<dim> surface = surface_mesh<dim>(RigidShape<dim>(plane), lower, upper);
  RC_ASSERT(surface.cells.size() == 1u);  // the plane's point is inside the box
  RC_ASSERT(surface.points.size() >= static_cast<std::size_t>(dim));
  for (const Vec<dim>& x : surface.points) {
    RC_ASSERT(std::abs(surface_at<dim>(plane, x).distance) < 1e-9);  // rounding of lengths near 10
    // Inside the box, and on one of its sides: no part of the plane in the box is left out.
    const Real beyond = (lower - x).cwiseMax(x - upper).maxCoeff();
    RC_ASSERT(std::abs(beyond) < 1e-7);
  }
}

RC_GTEST_PROP(SurfaceMesh, of_a_half_plane_ends_on_the_sides_of_the_box_in_the_plane, ())
{
  half_plane_is_clipped_to_the_box<2>();
}
RC_GTEST_PROP(SurfaceMesh, of_a_half_plane_ends_on_the_sides_of_the_box_in_space, ())
{
  half_plane_is_clipped_to_the_box<3>();
}

TEST(SurfaceMesh, of_a_half_plane_that_misses_the_box_has_no_cell)
{
  const HalfPlane<2> below{Vec<2>(0, -1), Vec<2>(0, 1)};
  EXPECT_TRUE(surface_mesh<2>(RigidShape<2>(below), Vec<2>(0, 0), Vec<2>(1, 1)).cells.empty());
}

TEST(SurfaceMesh, of_a_half_plane_on_the_side_of_the_box_is_that_side)
{
  const HalfPlane<2> bottom{Vec<2>(7, 0), Vec<2>(0, 1)};
  const auto surface = surface_mesh<2>(RigidShape<2>(bottom), Vec<2>(0, 0), Vec<2>(1, 1));
  ASSERT_EQ(surface.points.size(), 2u);
  EXPECT_NEAR((surface.points[0] - surface.points[1]).norm(), 1, 1e-6);  // the clip leaves 1e-9 of the box on each end
}

TEST(SurfaceMesh, of_a_circle_goes_round_once_and_lies_on_it)
{
  const Circle<2> circle{Vec<2>(1, 2), 0.5};
  const auto surface = surface_mesh<2>(RigidShape<2>(circle), Vec<2>(0, 0), Vec<2>(3, 3));
  Real area = 0;
  for (std::size_t k = 0; k < surface.points.size(); ++k) {
    const Vec<2> a = surface.points[k] - circle.center, b = surface.points[(k + 1) % surface.points.size()] - circle.center;
    EXPECT_NEAR(a.norm(), 0.5, 1e-14);
    area += (a[0] * b[1] - a[1] * b[0]) / 2;
  }
  EXPECT_NEAR(area, 64 * 0.25 * std::sin(2 * pi / 128), 1e-14);  // the polygon's exact area, counter-clockwise
}

TEST(SurfaceMesh, of_a_circle_that_has_turned_has_a_spoke_that_tells_the_angle)
{
  const Circle<2> circle{Vec<2>(1, 2), 0.5, 0.7};
  const auto surface = surface_mesh<2>(RigidShape<2>(circle), Vec<2>(0, 0), Vec<2>(3, 3));
  ASSERT_EQ(surface.cells.size(), 2u);
  EXPECT_EQ(surface.cells[0].points.size(), 128u);
  ASSERT_EQ(surface.cells[1].kind, Kind::line);
  const Vec<2> spoke = surface.points[surface.cells[1].points[1]] - surface.points[surface.cells[1].points[0]];
  EXPECT_NEAR((spoke - 0.5 * Vec<2>(std::cos(0.7), std::sin(0.7))).norm(), 0, 1e-14);
}

TEST(SurfaceMesh, of_a_turned_polygon_has_its_corners_in_order)
{
  const RigidBody<2> angle{"angle", make_shape<2>(PolygonSettings{{0, 2, 2, 1, 1, 0}, {0, 0, 1, 1, 2, 2}})};
  RigidState<2> state;
  state.displacement = {3, 4};
  state.orientation.angle = pi / 2;
  const auto surface = surface_mesh<2>(placed<2>(angle, state), Vec<2>(0, 0), Vec<2>(1, 1));
  const Vec<2> center(5. / 6, 5. / 6);
  const std::vector<Vec<2>> corners = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  ASSERT_EQ(surface.points.size(), 6u);
  ASSERT_EQ(surface.cells.size(), 1u);
  EXPECT_EQ(surface.cells[0].kind, Kind::polygon);
  for (std::size_t k = 0; k < 6; ++k) {
    const Vec<2> from = corners[k] - center;  // a quarter turn takes (x, y) to (-y, x)
    EXPECT_NEAR((surface.points[k] - (center + Vec<2>(3, 4) + Vec<2>(-from[1], from[0]))).norm(), 0, 1e-14);
  }
}

TEST(SurfaceMesh, of_a_prism_reaches_through_the_mesh)
{
  const auto prism = make_shape<3>(PolygonSettings{{0, 1, 0}, {0, 0, 1}});
  const auto surface = surface_mesh<3>(prism, Vec<3>(-1, -1, 2), Vec<3>(1, 1, 5));
  EXPECT_EQ(surface.cells.size(), 3u);
  EXPECT_EQ(surface.points.size(), 6u);
  for (const auto& x : surface.points) EXPECT_TRUE(x[2] == 2 || x[2] == 5);
}

TEST(SurfaceMesh, of_a_circle_in_space_reaches_through_the_mesh)
{
  const Circle<3> circle{Vec<3>(0, 0, 9), 1};
  const auto surface = surface_mesh<3>(RigidShape<3>(circle), Vec<3>(-1, -1, 2), Vec<3>(1, 1, 5));
  EXPECT_EQ(surface.cells.size(), 128u);
  Real min = infinity, max = -infinity;
  for (const auto& x : surface.points) min = std::min(min, x[2]), max = std::max(max, x[2]);
  EXPECT_EQ(min, 2);
  EXPECT_EQ(max, 5);
}

TEST(SurfaceMesh, of_a_sphere_lies_on_it_and_is_no_extruded_side)
{
  const Sphere<3> sphere{Vec<3>(1, 2, 3), 0.5};
  const auto surface = surface_mesh<3>(RigidShape<3>(sphere), Vec<3>(0, 0, 0), Vec<3>(5, 5, 5));
  ASSERT_FALSE(surface.cells.empty());
  for (const Vec<3>& x : surface.points) EXPECT_NEAR((x - sphere.center).norm(), 0.5, 1e-15);
  for (const auto& cell : surface.cells) EXPECT_EQ(cell.kind, SurfaceMesh<3>::Kind::polygon);
}

TEST(SurfaceMesh, of_a_turned_box_has_its_corners)
{
  BoxSettings settings{{1, 1}, {2, 4}, pi / 2};
  const auto surface = surface_mesh<2>(make_shape<2>(RigidShapeSettings(settings)), Vec<2>(0, 0), Vec<2>(1, 1));
  ASSERT_EQ(surface.points.size(), 4u);
  for (const auto& x : surface.points) {
    EXPECT_NEAR(std::abs(x[0] - 1), 2, 1e-12);
    EXPECT_NEAR(std::abs(x[1] - 1), 1, 1e-12);
  }
}

}  // namespace
}  // namespace berm::bodies::this_file
