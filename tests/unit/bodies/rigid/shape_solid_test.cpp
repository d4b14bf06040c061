// SPDX-License-Identifier: BSD-3-Clause
#include "bodies/rigid/dynamics.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>
#include <random>

namespace berm::bodies::this_file {
namespace {

struct NamedSolid {
  const char* name;
  RigidShapeSettings settings;
  Real facets;  ///< m, by how much the surface mesh misses the surface
};

/// A cone with its shaft, its axis askew.
ProfileSettings cone(Real corner_radius)
{
  return {{0, 0.5, 0.5, 0}, {-0.8, 0.1, 1, 1}, corner_radius, {0.1, 0.2, -0.1}, {1, 2, 2}};
}

std::vector<NamedSolid> solids()
{
  // 48 sectors of a circle of radius r miss it by r (1 - cos(pi / 48)) = 0.0022 r; an arc of 8 chords by a hundredth of its radius, one of 4 by a fortieth.
  return {{"flat_cylinder", CylinderSettings{{0.1, -0.2, 0.3}, {1, 0, 0}, 0.8, 1.4}, 0.0009},
          {"turned_cylinder", CylinderSettings{{0.1, -0.2, 0.3}, {1, -2, 0.5}, 0.8, 1.4}, 0.0009},
          {"upside_down_cylinder", CylinderSettings{{0.1, -0.2, 0.3}, {0, -1, 0}, 0.8, 1.4}, 0.0009},
          {"cylinder_with_round_ends", CylinderSettings{{0.1, -0.2, 0.3}, {1, -2, 0.5}, 0.8, 1.4, CylinderEnds::round}, 0.003},
          {"cylinder_with_round_edges", CylinderSettings{{0.1, -0.2, 0.3}, {0, 1, 3}, 0.8, 1.4, CylinderEnds::flat, 0.1}, 0.0014},
          {"plate", BoxSettings{{0.2, -0.1, 0.1}, {1.6, 0.1, 0.9}}, 1e-13},
          {"turned_box", BoxSettings{{0.2, -0.1, 0.1}, {1.2, 0.6, 0.8}, 0, {0.3, -0.7, 1.1}}, 1e-13},
          {"box_with_round_edges", BoxSettings{{0.2, -0.1, 0.1}, {1.2, 0.6, 0.8}, 0, {0.3, -0.7, 1.1}, 0.1}, 0.005},
          {"cone", cone(0), 0.0012},
          {"cone_with_round_corners", cone(0.05), 0.002},
          {"ring", ProfileSettings{{0.5, 0.6, 0.6, 0.5}, {-0.5, -0.5, 0.6, 0.6}, 0, {0.1, 0, 0}, {0, 1, 0.5}}, 0.0015},
          {"sphere", SphereSettings{{0.3, -0.2, 0.1}, 1.4}, 0.008}};
}

Vec<3> random_vec(std::mt19937& random, Real reach)
{
  std::uniform_real_distribution<Real> number(-reach, reach);
  return {number(random), number(random), number(random)};
}

/// Distance of a point from a triangle, by minimisation over its two sides' coordinates: brute force.
Real distance_from(const Vec<3>& x, const Vec<3>& a, const Vec<3>& b, const Vec<3>& c)
{
  const auto from_line = [&](const Vec<3>& p, const Vec<3>& q) {
    const Real square = (q - p).squaredNorm(), t = square > 0 ? std::clamp((x - p).dot(q - p) / square, Real(0), Real(1)) : 0;
    return (x - p - t * (q - p)).norm();
  };
  Real least = std::min({from_line(a, b), from_line(b, c), from_line(c, a)});
  const Vec<3> normal = (b - a).cross(c - a);
  const Real square = normal.squaredNorm();
  if (square == 0) return least;
  const auto side = [&](const Vec<3>& p, const Vec<3>& q) { return (q - p).cross(x - p).dot(normal) >= 0; };
  if (side(a, b) && side(b, c) && side(c, a)) least = std::min(least, std::abs((x - a).dot(normal)) / std::sqrt(square));
  return least;
}

using Triangle = std::array<Vec<3>, 3>;

std::vector<Triangle> triangles_of(const SurfaceMesh<3>& surface)
{
  static const std::vector<Index> sides[] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  std::vector<Triangle> triangles;
  const auto add = [&](const std::vector<Index>& corners) {
    for (std::size_t k = 1; k + 1 < corners.size(); ++k)
      triangles.push_back({surface.points[corners[0]], surface.points[corners[k]], surface.points[corners[k + 1]]});
  };
  for (const auto& cell : surface.cells)
    if (cell.kind == SurfaceMesh<3>::Kind::hexahedron)
      for (const std::vector<Index>& side : sides) add(side);
    else
      add(cell.points);
  return triangles;
}

std::vector<Triangle> triangles_of(const RigidShape<3>& shape)
{
  return triangles_of(surface_mesh<3>(shape, Vec<3>(-9, -9, -9), Vec<3>(9, 9, 9)));
}

TEST(Solid, distance_is_that_from_its_surface_mesh_by_brute_force)
{
  std::mt19937 random(1);
  for (const NamedSolid& named : solids()) {
    const auto shape = make_shape<3>(named.settings);
    const std::vector<Triangle> triangles = triangles_of(shape);
    for (int n = 0; n < 300; ++n) {
      const Vec<3> x = random_vec(random, 1.5);
      Real least = infinity;
      for (const Triangle& t : triangles) least = std::min(least, distance_from(x, t[0], t[1], t[2]));
      EXPECT_NEAR(std::abs(surface_at<3>(shape, x).distance), least, named.facets) << named.name << ", " << x.transpose();
    }
  }
}

TEST(Solid, normal_is_the_gradient_of_the_distance_and_leads_to_the_surface)
{
  std::mt19937 random(2);
  int compared = 0;
  for (const NamedSolid& named : solids()) {
    const auto shape = make_shape<3>(named.settings);
    for (int n = 0; n < 500; ++n) {
      constexpr Real h = 1e-6;
      const Vec<3> x = random_vec(random, 1.5);
      const auto at = surface_at<3>(shape, x);
      EXPECT_NEAR(at.normal.norm(), 1, 1e-13) << named.name;
      EXPECT_NEAR(surface_at<3>(shape, Vec<3>(x - at.distance * at.normal)).distance, 0, 1e-12) << named.name;
      Vec<3> gradient;
      bool smooth = true;
      for (int d = 0; d < 3; ++d) {
        const auto ahead = surface_at<3>(shape, Vec<3>(x + h * Vec<3>::Unit(d))),
                   behind = surface_at<3>(shape, Vec<3>(x - h * Vec<3>::Unit(d)));
        smooth = smooth && (ahead.normal - behind.normal).norm() < 1e-4;  // not where two sides are equally near, nor close to an edge
        gradient[d] = (ahead.distance - behind.distance) / (2 * h);
      }
      if (!smooth) continue;
      EXPECT_NEAR((gradient - at.normal).norm(), 0, 1e-7) << named.name;
      ++compared;
    }
  }
  EXPECT_GT(compared, 5000);
}

TEST(Solid, surface_mesh_is_closed_and_faces_outwards)
{
  for (const NamedSolid& named : solids()) {
    if (std::holds_alternative<SphereSettings>(named.settings)) continue;  // drawn only
    Vec<3> area = Vec<3>::Zero();
    Real volume = 0;
    for (const auto& [a, b, c] : triangles_of(make_shape<3>(named.settings))) {
      area += (b - a).cross(c - a) / 2;
      volume += a.dot(b.cross(c)) / 6;
    }
    EXPECT_NEAR(area.norm(), 0, 1e-13) << named.name;  // zero of any closed surface
    EXPECT_GT(volume, 0) << named.name;
  }
}

TEST(Solid, centre_and_moments_of_inertia_are_those_of_random_points_within)
{
  std::mt19937 random(3);
  for (const NamedSolid& named : solids()) {
    const auto shape = make_shape<3>(named.settings);
    const Real reach = reach_of<3>(shape);
    constexpr int count = 200000;
    Vec<3> sum = Vec<3>::Zero();
    Matrix<3> squares = Matrix<3>::Zero();
    int inside = 0;
    for (int n = 0; n < count; ++n) {
      const Vec<3> from = random_vec(random, reach);
      if (surface_at<3>(shape, Vec<3>(center_of<3>(shape) + from)).distance >= 0) continue;
      ++inside;
      sum += from;
      squares += from * from.transpose();
    }
    ASSERT_GT(inside, 4000) << named.name;
    // The deviation of a mean of n is that of one over sqrt(n): five of it.
    const Real tolerance = 5 / std::sqrt(Real(inside));
    EXPECT_LT((sum / inside).norm(), tolerance * reach) << named.name;
    const Matrix<3> sampled = (Matrix<3>::Identity() * squares.trace() - squares) / inside;
    const Matrix<3> axes = axes_of<3>(shape), own = axes * inertia_over_mass<3>(shape).asDiagonal() * axes.transpose();
    EXPECT_LT((sampled - own).norm(), tolerance * own.norm()) << named.name << "\n" << sampled << "\n" << own;
  }
}

TEST(Solid, moments_of_inertia_are_those_of_known_ones)
{
  const Real r = 0.4, l = 1.4;
  const Vec<3> flat = inertia_over_mass<3>(make_shape<3>(CylinderSettings{{0, 0, 0}, {0, 1, 0}, 2 * r, l}));
  EXPECT_NEAR(flat[1], r * r / 2, 1e-15);
  EXPECT_NEAR(flat[0], (3 * r * r + l * l) / 12, 1e-15);
  // A cylinder of length h with two half spheres: their centres of mass are 3 r / 8 from its ends.
  const Real h = l - 2 * r, middle = r * r * h, ends = 4. / 3 * r * r * r;
  const Vec<3> round = inertia_over_mass<3>(make_shape<3>(CylinderSettings{{0, 0, 0}, {0, 1, 0}, 2 * r, l, CylinderEnds::round}));
  EXPECT_NEAR(round[1], (middle * r * r / 2 + ends * 0.4 * r * r) / (middle + ends), 1e-6);  // of arcs of 1000 chords
  EXPECT_NEAR(round[0], (middle * (3 * r * r + h * h) / 12 + ends * (0.4 * r * r + h * h / 4 + 3. / 8 * h * r)) / (middle + ends), 1e-6);
  // A box that is all edge is a sphere; a cone of height h and radius r.
  const Vec<3> ball = inertia_over_mass<3>(make_shape<3>(BoxSettings{{0, 0, 0}, {1, 1, 1}, 0, {}, 0.5}));
  EXPECT_NEAR((ball - Vec<3>::Constant(0.1)).norm(), 0, 1e-15);
  const auto cone = make_shape<3>(ProfileSettings{{0, 2, 0}, {0, 1, 1}});
  EXPECT_NEAR((center_of<3>(cone) - Vec<3>(0, 0.75, 0)).norm(), 0, 1e-15);
  EXPECT_NEAR((inertia_over_mass<3>(cone) - Vec<3>(0.6375, 1.2, 0.6375)).norm(), 0, 1e-14);  // 3/20 r^2 + 3/80 h^2 and 3/10 r^2
}

TEST(Solid, lowest_level_width_and_reach_are_those_of_its_surface_mesh)
{
  std::mt19937 random(4);
  for (const NamedSolid& named : solids()) {
    const auto shape = make_shape<3>(named.settings);
    const auto mesh = surface_mesh<3>(shape, Vec<3>(-9, -9, -9), Vec<3>(9, 9, 9));
    Real reach = 0;
    for (const Vec<3>& x : mesh.points) reach = std::max(reach, (x - center_of<3>(shape)).norm());
    EXPECT_LE(reach, reach_of<3>(shape) + 1e-12) << named.name;
    EXPECT_GE(reach, 0.9 * reach_of<3>(shape)) << named.name;
    for (int n = 0; n < 100; ++n) {
      const Vec<3> up = random_vec(random, 1).normalized();
      Real lowest = infinity;
      for (const Vec<3>& x : mesh.points) lowest = std::min(lowest, up.dot(x));
      EXPECT_NEAR(lowest_level<3>(shape, up), lowest, named.facets + 1e-12) << named.name;
    }
  }
  EXPECT_NEAR(width_of<3>(make_shape<3>(cone(0))), 1, 1e-15);
  EXPECT_NEAR(width_of<3>(make_shape<3>(cone(0.05))), 1, 1e-15);
}

TEST(Solid, of_a_profile_has_across_its_axis_the_distances_of_the_profile_in_the_plane)
{
  // One input for both geometries: the section of the solid is the profile.
  const ProfileSettings settings{{0, 0.7, 0.7, 0.4, 0.4, 0}, {-0.8, 0, 0.3, 0.3, 1, 1}, 0.03};
  const auto flat = make_shape<2>(settings);
  const auto solid = make_shape<3>(settings);
  std::mt19937 random(5);
  for (int n = 0; n < 1000; ++n) {
    const Vec<3> x = random_vec(random, 1.2);
    EXPECT_NEAR(surface_at<3>(solid, x).distance, surface_at<2>(flat, Vec<2>(std::hypot(x[0], x[2]), x[1])).distance, 1e-13);
  }
}

/// Angular momentum of a body that turned from the begin of a step, at its middle.
Vec<3> momentum_of(const RigidBody<3>& body, RigidState<3> state, Real dt)
{
  state.orientation.turn_by(-dt / 2 * state.angular_velocity);
  return times_inertia(body, state, state.angular_velocity);
}

TEST(FreeBody, that_tumbles_keeps_its_angular_momentum_and_its_energy)
{
  // About the axis of its middle moment of inertia a box's rotation is unstable: it turns over again and again.
  const auto shape = make_shape<3>(BoxSettings{{0, 0, 0}, {1, 2, 3}, 0, {0.3, 0.2, 0.1}});
  RigidBody<3> box{"box", shape, 2, Motion::free, Rotation::free, 2 * inertia_over_mass<3>(shape), axes_of<3>(shape)};
  RigidState<3> state;
  state.angular_velocity = box.axes * Vec<3>(0.02, 4, 0.01);
  constexpr Real dt = 1e-3;
  Vec<3> momentum = Vec<3>::Zero();
  Real energy = 0, least = infinity, most = -infinity, over = infinity;
  for (int n = 0; n < 20000; ++n) {  // 80 rad in all, 4e-3 a step
    free_body<3>(box, state, Vec<3>::Zero(), dt);
    move_body(box, state, dt);
    const Vec<3> now = momentum_of(box, state, dt);
    RigidState<3> halfway = state;
    halfway.orientation.turn_by(-dt / 2 * state.angular_velocity);
    const Real kinetic = kinetic_energy(box, halfway);
    if (n == 0) momentum = now, energy = kinetic;
    EXPECT_NEAR((now - momentum).norm(), 0, 1e-10 * momentum.norm());  // 20 000 roundings of 1e-15 of the angular velocity
    least = std::min(least, kinetic), most = std::max(most, kinetic);
    over = std::min(over, (box.axes.transpose() * state.orientation.matrix().transpose() * state.angular_velocity)[1]);
  }
  EXPECT_LT(over, -3.9);                   // it has turned over,
  EXPECT_LT(most - least, 1e-5 * energy);  // and its energy swings by the square of the step's angle, 1.6e-5
}

TEST(DrivenBody, whose_rotation_is_given_about_one_axis_turns_freely_about_the_others)
{
  // Held about z and pushed by a moment about x, a box askew turns about x by M / I', where I' is that of a body held about z and free about y.
  const auto shape = make_shape<3>(BoxSettings{{0, 0, 0}, {1, 2, 3}, 0, {0.3, 0.2, 0.1}});
  const RigidBody<3> box{"box", shape, 2, Motion::driven, Rotation::free, 2 * inertia_over_mass<3>(shape), axes_of<3>(shape)};
  RigidState<3> state;
  DriveNow<3> drive{{false, false, false, true, true, false}, {0, 0, 0, 5, 0, 0}};
  constexpr Real dt = 1e-6;
  drive_body(box, state, drive, dt);
  const Matrix<3> inertia = box.axes * box.inertia.asDiagonal() * box.axes.transpose();
  const Vec<2> expected = inertia.topLeftCorner<2, 2>().inverse() * Vec<2>(5 * dt, 0);
  EXPECT_NEAR((state.angular_velocity.head<2>() - expected).norm(), 0, 1e-9 * expected.norm());
  EXPECT_EQ(state.angular_velocity[2], 0);
}

}  // namespace
}  // namespace berm::bodies::this_file
