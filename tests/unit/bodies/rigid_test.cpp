// SPDX-License-Identifier: BSD-3-Clause
#include "bodies/rigid.hpp"

#include <gtest/gtest.h>
#include <random>

namespace berm {
namespace {

constexpr Real edge = 1e-6;

struct NamedShape {
  const char* name;
  RigidShapeSettings settings;
};

template <int dim>
std::vector<NamedShape> shapes();
template <>
std::vector<NamedShape> shapes<2>()
{
  return {{"circle", CircleSettings{{0.3, -0.2}, 1.4}},
          {"half_plane", HalfPlaneSettings{{0.1, 0.2}, {3, 4}}},
          {"box", BoxSettings{{0.2, -0.1}, {1.2, 0.6}, 0}},
          {"turned_box", BoxSettings{{0.2, -0.1}, {1.2, 0.6}, 0.7}},
          {"box_turned_back", BoxSettings{{0.2, -0.1}, {1.2, 0.6}, -0.4}}};
}
template <>
std::vector<NamedShape> shapes<3>()
{
  return {{"cylinder", CircleSettings{{0.3, -0.2, 5}, 1.4}},
          {"half_space", HalfPlaneSettings{{0.1, 0.2, -0.3}, {1, 2, 2}}},
          {"box", BoxSettings{{0.2, -0.1, 0.1}, {1.2, 0.6, 0.8}, 0}}};
}

/// Whether a point lies in the rigid body, from its settings alone.
template <int dim>
bool inside(const RigidShapeSettings& settings, const Vec<dim>& x)
{
  if (const auto* circle = std::get_if<CircleSettings>(&settings))
    return std::hypot(x[0] - circle->center[0], x[1] - circle->center[1]) < circle->diameter / 2;
  if (const auto* plane = std::get_if<HalfPlaneSettings>(&settings)) {
    Real along = 0;
    for (int d = 0; d < dim; ++d) along += plane->normal[d] * (x[d] - plane->point[d]);
    return along < 0;
  }
  const auto& box = std::get<BoxSettings>(settings);
  const Real dx = x[0] - box.center[0], dy = x[1] - box.center[1];
  Real local[3] = {std::cos(box.angle) * dx + std::sin(box.angle) * dy, std::cos(box.angle) * dy - std::sin(box.angle) * dx, 0};
  if (dim == 3) local[2] = x[2] - box.center[2];
  for (int d = 0; d < dim; ++d)
    if (std::abs(local[d]) >= box.size[d] / 2) return false;
  return true;
}

template <int dim>
Vec<dim> random_vec(std::mt19937& random, Real reach)
{
  Vec<dim> x;
  for (int d = 0; d < dim; ++d) x[d] = std::uniform_real_distribution<Real>(-reach, reach)(random);
  return x;
}

template <class Dimension>
class RigidShapes : public testing::Test {
public:
  /// Calls try_it(shape, x) for random points near each shape.
  template <class Try>
  static void for_random_points(int count, const Try& try_it)
  {
    constexpr int dim = Dimension::value;
    std::mt19937 random(4);
    for (const NamedShape& named : shapes<dim>()) {
      SCOPED_TRACE(named.name);
      const auto shape = make_shape<dim>(named.settings);
      for (int n = 0; n < count; ++n) try_it(named.settings, shape, random_vec<dim>(random, 1.5));
    }
  }
};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(RigidShapes, Dimensions);

TYPED_TEST(RigidShapes, distance_is_negative_inside_and_only_there)
{
  constexpr int dim = TypeParam::value;
  int inner = 0;
  TestFixture::for_random_points(2000, [&](const auto& settings, const auto& shape, const Vec<dim>& x) {
    inner += inside<dim>(settings, x);
    EXPECT_EQ(surface_at<dim>(shape, x).distance < 0, inside<dim>(settings, x)) << x.transpose();
  });
  EXPECT_GT(inner, 100);
}

TYPED_TEST(RigidShapes, the_surface_is_found_at_the_distance_along_the_normal)
{
  // From x the step -distance * normal ends on the surface: a little less is on the side of x, a little more on the other.
  constexpr int dim = TypeParam::value;
  TestFixture::for_random_points(1000, [&](const auto& settings, const auto& shape, const Vec<dim>& x) {
    const auto at = surface_at<dim>(shape, x);
    EXPECT_NEAR(at.normal.norm(), 1, 1e-14);
    const Vec<dim> foot = x - at.distance * at.normal;
    EXPECT_NEAR(surface_at<dim>(shape, foot).distance, 0, 1e-13);
    EXPECT_FALSE(inside<dim>(settings, Vec<dim>(foot + edge * at.normal)));
    EXPECT_TRUE(inside<dim>(settings, Vec<dim>(foot - edge * at.normal)));
  });
}

TYPED_TEST(RigidShapes, no_point_of_the_other_side_is_nearer_than_the_distance)
{
  constexpr int dim = TypeParam::value;
  std::mt19937 random(9);
  TestFixture::for_random_points(40, [&](const auto& settings, const auto& shape, const Vec<dim>& x) {
    const auto at = surface_at<dim>(shape, x);
    const bool side = inside<dim>(settings, x);
    const Real reach = std::abs(at.distance);
    for (int n = 0; n < 200; ++n) {
      const Vec<dim> near = x + random_vec<dim>(random, 1).normalized() * reach * (1 - 1e-9);
      EXPECT_EQ(inside<dim>(settings, near), side);
    }
  });
}

TYPED_TEST(RigidShapes, the_normal_is_the_gradient_of_the_distance)
{
  constexpr int dim = TypeParam::value;
  int compared = 0;
  TestFixture::for_random_points(500, [&](const auto&, const auto& shape, const Vec<dim>& x) {
    constexpr Real h = 1e-6;
    const auto at = surface_at<dim>(shape, x);
    Vec<dim> gradient;
    for (int d = 0; d < dim; ++d) {
      const Vec<dim> step = h * Vec<dim>::Unit(d);
      const auto ahead = surface_at<dim>(shape, x + step), behind = surface_at<dim>(shape, x - step);
      // On the lines where two sides are equally near, the normal jumps and there is no gradient.
      if ((ahead.normal - behind.normal).norm() > 0.01) return;
      gradient[d] = (ahead.distance - behind.distance) / (2 * h);
    }
    EXPECT_NEAR((gradient - at.normal).norm(), 0, 1e-8);  // error of the difference: h^2 / radius^2 and round-off 1e-16 / h
    ++compared;
  });
  EXPECT_GT(compared, 1000);
}

TYPED_TEST(RigidShapes, a_moved_shape_is_seen_as_the_shape_from_the_point_moved_back)
{
  constexpr int dim = TypeParam::value;
  std::mt19937 random(2);
  TestFixture::for_random_points(200, [&](const auto&, const auto& shape, const Vec<dim>& x) {
    const Vec<dim> by = random_vec<dim>(random, 3);
    const auto there = surface_at<dim>(moved<dim>(shape, by), Vec<dim>(x + by)), here = surface_at<dim>(shape, x);
    EXPECT_NEAR(there.distance, here.distance, 1e-14);
    EXPECT_NEAR((center_of<dim>(moved<dim>(shape, by)) - center_of<dim>(shape) - by).norm(), 0, 1e-14);
    EXPECT_NEAR(lowest_level<dim>(moved<dim>(shape, by)) - lowest_level<dim>(shape), by[1], 1e-14);
  });
}

TYPED_TEST(RigidShapes, no_point_lies_below_the_lowest_level_but_some_lie_at_it)
{
  constexpr int dim = TypeParam::value;
  std::mt19937 random(6);
  for (const NamedShape& named : shapes<dim>()) {
    const auto shape = make_shape<dim>(named.settings);
    if (std::holds_alternative<HalfPlane<dim>>(shape)) continue;
    const Real level = lowest_level<dim>(shape);
    Real lowest = infinity;
    for (int n = 0; n < 50000; ++n) {
      const auto x = random_vec<dim>(random, 1.5);
      const auto at = surface_at<dim>(shape, x);  // its foot lies on the surface
      lowest = std::min(lowest, x[1] - at.distance * at.normal[1]);
    }
    EXPECT_GE(lowest, level - 1e-12) << named.name;
    EXPECT_LT(lowest, level + 1e-3) << named.name;
  }
}

TEST(RigidShape, of_known_points)
{
  const auto circle = make_shape<2>(CircleSettings{{1, 2}, 2});
  EXPECT_NEAR(surface_at<2>(circle, Vec<2>(1, 4)).distance, 1, 1e-15);
  EXPECT_EQ(surface_at<2>(circle, Vec<2>(1, 2)).distance, -1);  // the centre has no direction of its own: upwards
  EXPECT_EQ(surface_at<2>(circle, Vec<2>(1, 2)).normal, Vec<2>(0, 1));
  EXPECT_EQ(lowest_level<2>(circle), 1);
  EXPECT_EQ(width_of<2>(circle), 2);

  const auto box = make_shape<2>(BoxSettings{{0, 0}, {4, 2}, 0});
  EXPECT_NEAR(surface_at<2>(box, Vec<2>(5, 5)).distance, 5, 1e-14);  // the corner (2, 1) is 3 and 4 away
  EXPECT_NEAR((surface_at<2>(box, Vec<2>(5, 5)).normal - Vec<2>(0.6, 0.8)).norm(), 0, 1e-15);
  EXPECT_NEAR(surface_at<2>(box, Vec<2>(0.5, -0.75)).distance, -0.25, 1e-15);
  EXPECT_EQ(surface_at<2>(box, Vec<2>(0.5, -0.75)).normal, Vec<2>(0, -1));
  EXPECT_EQ(width_of<2>(box), 4);
  EXPECT_NEAR(lowest_level<2>(make_shape<2>(BoxSettings{{0, 0}, {2, 2}, pi / 4})), -std::sqrt(2.), 1e-15);

  const auto plane = make_shape<2>(HalfPlaneSettings{{0, -1}, {0, 5}});
  EXPECT_NEAR(surface_at<2>(plane, Vec<2>(7, 1)).distance, 2, 1e-15);
  EXPECT_EQ(lowest_level<2>(plane), -1);
  EXPECT_EQ(width_of<2>(plane), 0);
}

TEST(RigidShape, a_circle_in_space_is_a_cylinder_along_z)
{
  const auto cylinder = make_shape<3>(CircleSettings{{1, 2, 3}, 2});
  const auto circle = make_shape<2>(CircleSettings{{1, 2}, 2});
  std::mt19937 random(8);
  for (int n = 0; n < 100; ++n) {
    const auto x = random_vec<3>(random, 5);
    const auto in_space = surface_at<3>(cylinder, x);
    const auto in_plane = surface_at<2>(circle, Vec<2>(x[0], x[1]));
    EXPECT_NEAR(in_space.distance, in_plane.distance, 1e-14);
    EXPECT_NEAR((in_space.normal - Vec<3>(in_plane.normal[0], in_plane.normal[1], 0)).norm(), 0, 1e-14);
  }
}

}  // namespace
}  // namespace berm
