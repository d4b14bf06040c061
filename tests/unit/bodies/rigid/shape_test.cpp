// SPDX-License-Identifier: BSD-3-Clause
#include "bodies/rigid/rigid_body.hpp"
#include "bodies/rigid/rounding.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

namespace berm::bodies::this_file {
namespace {

constexpr Real edge = 1e-6;

Real about_z(Real angle, Angular<2>)
{
  return angle;
}
Vec<3> about_z(Real angle, const Angular<3>&)
{
  return {0, 0, angle};
}
/// A rotation about z, as a rotation in space or in the plane.
template <int dim>
Angular<dim> about_z(Real angle)
{
  return about_z(angle, no_angular<dim>());
}

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
          {"box_turned_back", BoxSettings{{0.2, -0.1}, {1.2, 0.6}, -0.4}},
          {"triangle", PolygonSettings{{-0.9, 1.1, 0.2}, {-0.7, -0.3, 1}}},
          {"clockwise_triangle", PolygonSettings{{0.2, 1.1, -0.9}, {1, -0.3, -0.7}}},
          {"notched_polygon", PolygonSettings{{-1, 0.1, 1, 1.2, 0.3, -0.2}, {-1, -0.2, -0.9, 0.8, 0.1, 1.1}}},
          {"cone_with_shaft", ProfileSettings{{0, 0.5, 0.5, 0}, {-0.8, 0.1, 1, 1}, 0}},
          {"cone_with_collar", ProfileSettings{{0, 0.7, 0.7, 0.4, 0.4, 0}, {-0.8, 0, 0.3, 0.3, 1, 1}, 0}},
          {"cone_with_round_corners", ProfileSettings{{0, 0.5, 0.5, 0}, {-0.8, 0.1, 1, 1}, 0.05}}};
}
template <>
std::vector<NamedShape> shapes<3>()
{
  return {{"cylinder", CircleSettings{{0.3, -0.2, 5}, 1.4}},
          {"half_space", HalfPlaneSettings{{0.1, 0.2, -0.3}, {1, 2, 2}}},
          {"box", BoxSettings{{0.2, -0.1, 0.1}, {1.2, 0.6, 0.8}, 0}},
          {"sphere", SphereSettings{{0.3, -0.2, 0.1}, 1.4}},
          {"prism", PolygonSettings{{-1, 0.1, 1, 1.2, 0.3, -0.2}, {-1, -0.2, -0.9, 0.8, 0.1, 1.1}}}};
}

/// Whether a point lies in the rigid body, from its settings alone.
template <int dim>
bool inside(const RigidShapeSettings& settings, const Vec<dim>& x)
{
  if (const auto* circle = std::get_if<CircleSettings>(&settings))
    return std::hypot(x[0] - circle->center[0], x[1] - circle->center[1]) < circle->diameter / 2;
  if (const auto* sphere = std::get_if<SphereSettings>(&settings))
    return std::hypot(x[0] - sphere->center[0], x[1] - sphere->center[1], x[dim - 1] - sphere->center[2]) < sphere->diameter / 2;
  if (const auto* plane = std::get_if<HalfPlaneSettings>(&settings)) {
    Real along = 0;
    for (int d = 0; d < dim; ++d) along += plane->normal[d] * (x[d] - plane->point[d]);
    return along < 0;
  }
  if (const auto* profile = std::get_if<ProfileSettings>(&settings)) {
    // A polygon with arcs of 400 points is within 2e-7 of the arc.
    const auto shape = make_shape<2>(*profile);
    PolygonSettings fine;
    for (const Vec<2>& corner : rounded_corners(*shape.core.corners, shape.radius, 400)) {
      fine.x.push_back(shape.core.center[0] + corner[0]);
      fine.y.push_back(shape.core.center[1] + corner[1]);
    }
    return inside<dim>(fine, x);
  }
  if (const auto* polygon = std::get_if<PolygonSettings>(&settings)) {  // the angle under which the corners go round the point
    Real round = 0;
    for (std::size_t k = 0; k < polygon->x.size(); ++k) {
      const std::size_t next = (k + 1) % polygon->x.size();
      const Real ax = polygon->x[k] - x[0], ay = polygon->y[k] - x[1], bx = polygon->x[next] - x[0], by = polygon->y[next] - x[1];
      round += std::atan2(ax * by - ay * bx, ax * bx + ay * by);
    }
    return std::abs(round) > pi;
  }
  const auto& box = std::get<BoxSettings>(settings);
  const Real dx = x[0] - box.center[0], dy = x[1] - box.center[1];
  Real local[3] = {std::cos(box.angle) * dx + std::sin(box.angle) * dy, std::cos(box.angle) * dy - std::sin(box.angle) * dx, 0};
  if (dim == 3) local[2] = x[2] - box.center[2];
  for (int d = 0; d < dim; ++d)
    if (std::abs(local[d]) >= box.size[d] / 2) return false;
  return true;
}

/// Whether x is a corner of a polygon; a step at a sharp one may cross its other side.
template <int dim>
bool is_corner(const RigidShapeSettings& settings, const Vec<dim>& x)
{
  const auto* polygon = std::get_if<PolygonSettings>(&settings);
  const auto* profile = std::get_if<ProfileSettings>(&settings);
  const PolygonSettings whole = profile != nullptr && profile->corner_radius == 0 ? whole_of(*profile) : PolygonSettings{};
  if (!whole.x.empty()) polygon = &whole;
  for (std::size_t k = 0; polygon != nullptr && k < polygon->x.size(); ++k)
    if (std::hypot(x[0] - polygon->x[k], x[1] - polygon->y[k]) < 1e-12) return true;
  return false;
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
    if (is_corner<dim>(settings, foot)) return;
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

/// A rigid body of this shape that has moved by `by` and turned by `angle`.
template <int dim>
struct Placed {
  RigidBody<dim> rigid;
  RigidState<dim> state;
  Real turned = 0;

  Placed(const RigidShape<dim>& shape, const Vec<dim>& by, Real angle) : rigid{"body", shape}
  {
    state.displacement = by;
    if (!std::holds_alternative<HalfPlane<dim>>(shape)) state.orientation.turn_by(about_z<dim>(turned = angle));
  }
  /// Where its point that was at x at the start is now, by plane trigonometry.
  Vec<dim> now(const Vec<dim>& x) const
  {
    const Vec<dim> center = center_of<dim>(rigid.shape), from = x - center;
    Vec<dim> moved = x + state.displacement;
    const Real radius = std::hypot(from[0], from[1]), angle = std::atan2(from[1], from[0]) + turned;
    moved[0] = center[0] + state.displacement[0] + radius * std::cos(angle);
    moved[1] = center[1] + state.displacement[1] + radius * std::sin(angle);
    return moved;
  }
};

TYPED_TEST(RigidShapes, a_placed_shape_is_seen_as_the_shape_from_the_point_moved_and_turned_back)
{
  constexpr int dim = TypeParam::value;
  std::mt19937 random(2);
  TestFixture::for_random_points(200, [&](const auto&, const auto& shape, const Vec<dim>& x) {
    const Vec<dim> by = random_vec<dim>(random, 3);
    const Placed<dim> body(shape, by, by[1]);
    const auto there = surface_at<dim>(placed<dim>(body.rigid, body.state), body.now(x)), here = surface_at<dim>(shape, x);
    EXPECT_NEAR(there.distance, here.distance, 1e-13);
    const Vec<dim> foot = x - here.distance * here.normal;
    EXPECT_NEAR((body.now(foot) - (body.now(x) - there.distance * there.normal)).norm(), 0, 1e-13);
    EXPECT_NEAR((center_now(body.rigid, body.state) - center_of<dim>(shape) - by).norm(), 0, 1e-14);
    EXPECT_NEAR((center_of<dim>(placed<dim>(body.rigid, body.state)) - center_of<dim>(shape) - by).norm(), 0, 1e-14);
  });
}

TYPED_TEST(RigidShapes, velocity_at_a_point_is_that_of_the_point_that_moves_and_turns_with_the_body)
{
  constexpr int dim = TypeParam::value;
  constexpr Real h = 1e-5;
  std::mt19937 random(3);
  TestFixture::for_random_points(50, [&](const auto&, const auto& shape, const Vec<dim>& x) {
    Placed<dim> body(shape, random_vec<dim>(random, 3), 0.8), before = body, after = body;
    body.state.velocity = random_vec<dim>(random, 2);
    if (!std::holds_alternative<HalfPlane<dim>>(shape)) body.state.angular_velocity = about_z<dim>(1.7);
    for (auto* moved : {&before, &after}) {
      const Real dt = moved == &before ? -h : h;
      moved->state.displacement += dt * body.state.velocity;
      moved->turned += std::holds_alternative<HalfPlane<dim>>(shape) ? 0 : dt * 1.7;
    }
    // The central difference is off by h^2 omega^3 r / 6 and by round-off 1e-16 / h.
    const Vec<dim> difference = (after.now(x) - before.now(x)) / (2 * h);
    EXPECT_NEAR((velocity_at(body.rigid, body.state, body.now(x)) - difference).norm(), 0, 1e-8);
  });
}

TYPED_TEST(RigidShapes, a_turned_body_reaches_no_farther_than_its_reach)
{
  constexpr int dim = TypeParam::value;
  for (const NamedShape& named : shapes<dim>()) {
    const auto shape = make_shape<dim>(named.settings);
    if (!is_bounded<dim>(shape)) continue;
    const Real reach = reach_of<dim>(shape);
    Real farthest = 0;
    for (int n = 0; n < 1000; ++n) {
      Vec<dim> away = Vec<dim>::Zero();
      away[0] = std::cos(2 * pi * n / 1000);
      away[1] = std::sin(2 * pi * n / 1000);
      const Vec<dim> x = center_of<dim>(shape) + 1.001 * reach * away;
      const auto at = surface_at<dim>(shape, x);
      EXPECT_GT(at.distance, 0) << named.name;
      farthest = std::max(farthest, (x - at.distance * at.normal - center_of<dim>(shape)).template head<2>().norm());
    }
    if (dim == 3 && std::holds_alternative<Box<dim>>(shape)) {  // its corners lie out of the plane of these points
      EXPECT_LT(farthest, reach) << named.name;
      EXPECT_NEAR(reach, std::sqrt(0.6 * 0.6 + 0.3 * 0.3 + 0.4 * 0.4), 1e-15);
    } else {
      EXPECT_NEAR(farthest, reach, 1e-3 * reach) << named.name;
    }
  }
}

TYPED_TEST(RigidShapes, no_point_lies_below_the_lowest_level_but_some_lie_at_it)
{
  constexpr int dim = TypeParam::value;
  std::mt19937 random(6);
  for (const NamedShape& named : shapes<dim>()) {
    const auto shape = make_shape<dim>(named.settings);
    if (!is_bounded<dim>(shape)) continue;
    const Real level = lowest_level<dim>(shape, Vec<dim>::UnitY());
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

TEST(RigidShape, moments_of_inertia_are_those_of_known_solids)
{
  EXPECT_NEAR((inertia_over_mass<3>(make_shape<3>(SphereSettings{{0, 0, 0}, 4})) - Vec<3>(1.6, 1.6, 1.6)).norm(), 0, 1e-15);
  const Vec<3> box = inertia_over_mass<3>(make_shape<3>(BoxSettings{{0, 0, 0}, {1, 2, 3}}));
  EXPECT_NEAR((box - Vec<3>(13, 10, 5) / 12).norm(), 0, 1e-15);
  const Vec<3> cylinder = inertia_over_mass<3>(make_shape<3>(CircleSettings{{0, 0, 0}, 2}));
  EXPECT_EQ(cylinder[0], infinity);
  EXPECT_EQ(cylinder[2], 0.5);
}

TEST(Orientation, of_a_constant_angular_velocity_is_its_angle_whatever_the_steps)
{
  const Vec<3> omega(0.3, -0.7, 0.5);
  Orientation<3> once, often;
  once.turn_by(omega);
  for (int n = 0; n < 1000; ++n) often.turn_by(omega / 1000);
  EXPECT_LT(angle_between(once, often), 1e-7);  // acos near 1 loses half of the digits
  EXPECT_NEAR((rotation_of(often) - omega).norm(), 0, 1e-13);
  EXPECT_NEAR((once.matrix() * omega - omega).norm(), 0, 1e-15);  // the axis stays
  EXPECT_NEAR((once.matrix() * once.matrix().transpose() - Matrix<3>::Identity()).norm(), 0, 1e-15);
}

TEST(RigidShape, of_known_points)
{
  const auto circle = make_shape<2>(CircleSettings{{1, 2}, 2});
  EXPECT_NEAR(surface_at<2>(circle, Vec<2>(1, 4)).distance, 1, 1e-15);
  EXPECT_EQ(surface_at<2>(circle, Vec<2>(1, 2)).distance, -1);  // the centre has no direction of its own: upwards
  EXPECT_EQ(surface_at<2>(circle, Vec<2>(1, 2)).normal, Vec<2>(0, 1));
  EXPECT_EQ(lowest_level<2>(circle, Vec<2>::UnitY()), 1);
  EXPECT_EQ(width_of<2>(circle), 2);

  const auto box = make_shape<2>(BoxSettings{{0, 0}, {4, 2}, 0});
  EXPECT_NEAR(surface_at<2>(box, Vec<2>(5, 5)).distance, 5, 1e-14);  // the corner (2, 1) is 3 and 4 away
  EXPECT_NEAR((surface_at<2>(box, Vec<2>(5, 5)).normal - Vec<2>(0.6, 0.8)).norm(), 0, 1e-15);
  EXPECT_NEAR(surface_at<2>(box, Vec<2>(0.5, -0.75)).distance, -0.25, 1e-15);
  EXPECT_EQ(surface_at<2>(box, Vec<2>(0.5, -0.75)).normal, Vec<2>(0, -1));
  EXPECT_EQ(width_of<2>(box), 4);
  EXPECT_NEAR(lowest_level<2>(make_shape<2>(BoxSettings{{0, 0}, {2, 2}, pi / 4}), Vec<2>::UnitY()), -std::sqrt(2.), 1e-15);

  const auto plane = make_shape<2>(HalfPlaneSettings{{0, -1}, {0, 5}});
  EXPECT_NEAR(surface_at<2>(plane, Vec<2>(7, 1)).distance, 2, 1e-15);
  EXPECT_EQ(lowest_level<2>(plane, Vec<2>::UnitY()), -1);
  EXPECT_EQ(width_of<2>(plane), 0);
}

TEST(RigidShape, rounded_has_arcs_at_its_corners_and_its_sides_where_they_were)
{
  const Vec<2> corner(2, 1), diagonal = Vec<2>(1, 1).normalized();
  for (const RigidShapeSettings& sharp :
       {RigidShapeSettings(BoxSettings{{0, 0}, {4, 2}, 0}), RigidShapeSettings(PolygonSettings{{-2, 2, 2, -2}, {-1, -1, 1, 1}}),
        RigidShapeSettings(ProfileSettings{{0, 2, 2, 0}, {-1, -1, 1, 1}, 0.1})}) {
    const RigidShape<2> round = rounded(make_shape<2>(sharp), 0.25);
    EXPECT_NEAR(surface_at<2>(round, Vec<2>(1, 1.5)).distance, 0.5, 1e-15);
    EXPECT_NEAR(surface_at<2>(round, corner).distance, 0.25 * (std::sqrt(2.) - 1), 1e-15) << "of the corner from the arc";
    EXPECT_NEAR((surface_at<2>(round, corner).normal - diagonal).norm(), 0, 1e-14);
    EXPECT_NEAR(width_of<2>(round), 4, 1e-15);
    EXPECT_NEAR(lowest_level<2>(round, Vec<2>::UnitY()), -1, 1e-15);
  }
  EXPECT_NEAR(surface_at<2>(rounded(make_shape<2>(BoxSettings{{0, 0}, {4, 0.02}, 0}), 0.25), Vec<2>(0, 0.5)).distance, 0.49, 1e-15)
      << "a thin plate has no room for such arcs, and keeps its thickness";
  const RigidShape<2> rounder = make_shape<2>(ProfileSettings{{0, 2, 2, 0}, {-1, -1, 1, 1}, 0.5});
  EXPECT_EQ(surface_at<2>(rounded(rounder, 0.25), corner).distance, surface_at<2>(rounder, corner).distance);
}

// A step, whose re-entrant corner lies at (1, 0) between a tread along x and a riser along y.
TEST(RigidShape, fillets_take_the_place_of_re_entrant_corners)
{
  const RigidShape<2> step = make_shape<2>(PolygonSettings{{-3, 3, 3, 1, 1, -3}, {-2, -2, 0, 0, 2, 2}});
  const RigidShape<2> round = rounded(step, 0.25);
  const std::vector<Fillet> fillets = fillets_of(round, 0.5);
  ASSERT_EQ(fillets.size(), 1u);
  const auto surface = [&](const Vec<2>& x) { return with_fillets(fillets, surface_at<2>(round, x), x); };
  const Vec<2> diagonal = Vec<2>(1, 1).normalized();
  EXPECT_NEAR(surface({1, 0}).distance, -0.5 * (std::sqrt(2.) - 1), 1e-14) << "of the sharp corner, which lies in the fillet";
  EXPECT_NEAR((surface({1, 0}).normal - diagonal).norm(), 0, 1e-14);
  EXPECT_NEAR(surface({1.49, 0}).normal[0], 0.02, 1e-3) << "the normal turns from side to side";
  EXPECT_NEAR(surface({1.51, 0.01}).distance, 0.01, 1e-14);
  EXPECT_EQ(surface({1.51, 0.01}).normal, Vec<2>(0, 1));
  for (const Vec<2>& elsewhere : {Vec<2>(-3.1, -2.1), Vec<2>(-3.1, 0), Vec<2>(0, -2.1), Vec<2>(3, 2)})
    EXPECT_EQ(surface(elsewhere).distance, surface_at<2>(round, elsewhere).distance);
  EXPECT_TRUE(fillets_of(rounded(make_shape<2>(BoxSettings{{0, 0}, {4, 2}, 0}), 0.25), 0.5).empty());
}

TEST(RigidShape, polygon_has_the_centroid_area_moments_and_levels_of_known_ones)
{
  // A box as a polygon, far from the origin and either way round.
  const auto box = make_shape<2>(BoxSettings{{1000, 2000}, {4, 2}, 0});
  for (const bool back : {false, true}) {
    PolygonSettings settings{{998, 1002, 1002, 998}, {1999, 1999, 2001, 2001}};
    if (back) std::reverse(settings.x.begin(), settings.x.end());
    if (back) std::reverse(settings.y.begin(), settings.y.end());
    const auto polygon = make_shape<2>(settings);
    EXPECT_NEAR((center_of<2>(polygon) - Vec<2>(1000, 2000)).norm(), 0, 1e-10);
    EXPECT_NEAR(inertia_over_mass<2>(polygon)[2], (16. + 4.) / 12, 1e-12);
    EXPECT_NEAR(inertia_over_mass<2>(polygon)[2], inertia_over_mass<2>(box)[2], 1e-12);
    EXPECT_NEAR(width_of<2>(polygon), 4, 1e-12);
    EXPECT_NEAR(reach_of<2>(polygon), std::sqrt(5.), 1e-12);
    EXPECT_NEAR(lowest_level<2>(polygon, Vec<2>::UnitY()), 1999, 1e-10);
    EXPECT_NEAR(surface_at<2>(polygon, Vec<2>(1005, 2005)).distance, 5, 1e-10);
  }
  // A square of side 2 without its upper right quarter: centroid and moment from three unit squares.
  const auto angle = make_shape<2>(PolygonSettings{{0, 2, 2, 1, 1, 0}, {0, 0, 1, 1, 2, 2}});
  EXPECT_NEAR((center_of<2>(angle) - Vec<2>(5. / 6, 5. / 6)).norm(), 0, 1e-15);
  // Squares of mass 1/3 at (1/2, 1/2), (3/2, 1/2), (1/2, 3/2): 1/6 each about themselves, then the distances from the centroid.
  EXPECT_NEAR(inertia_over_mass<2>(angle)[2], 1. / 6 + (2. / 9 + 2 * 5. / 9) / 3, 1e-14);
  EXPECT_NEAR(surface_at<2>(angle, Vec<2>(1.5, 1.5)).distance, 0.5, 1e-14);  // in the notch
  EXPECT_NEAR(surface_at<2>(angle, Vec<2>(0.9, 0.9)).distance, -std::sqrt(0.02), 1e-14);
  EXPECT_NEAR(inertia_over_mass<2>(make_shape<2>(CircleSettings{{3, 4}, 2}))[2], 0.5, 1e-15);
}

TEST(RigidShape, polygon_is_refused_where_its_sides_cross_or_touch)
{
  using P = PolygonSettings;
  EXPECT_TRUE(is_simple(P{{0, 2, 2, 1, 1, 0}, {0, 0, 1, 1, 2, 2}}));
  EXPECT_TRUE(is_simple(P{{0, 0, 1, 1, 2, 2}, {0, 2, 2, 1, 1, 0}}));
  EXPECT_TRUE(is_simple(P{{0, 1, 2, 1}, {0, 0, 0, 1}}));         // a corner in the middle of a side
  EXPECT_FALSE(is_simple(P{{0, 1}, {0, 1}}));                    // too few
  EXPECT_FALSE(is_simple(P{{0, 1, 2}, {0, 1, 2}}));              // all in line
  EXPECT_FALSE(is_simple(P{{0, 1, 0, 1}, {0, 1, 1, 0}}));        // two sides cross
  EXPECT_FALSE(is_simple(P{{0, 1, 1, 1}, {0, 0, 0, 1}}));        // a corner twice
  EXPECT_FALSE(is_simple(P{{0, 2, 2, 1, 0}, {0, 0, 2, 0, 2}}));  // a corner on another side
  EXPECT_FALSE(is_simple(P{{0, 3, 1, 1}, {0, 0, 0, 1}}));        // a side that goes back
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
}  // namespace berm::bodies::this_file
