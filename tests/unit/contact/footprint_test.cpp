// SPDX-License-Identifier: BSD-3-Clause
#include "contact/footprint.hpp"

#include "bodies/fill.hpp"
#include "contact/detect.hpp"
#include "mesh/box.hpp"

#include <gtest/gtest.h>
#include <numeric>

namespace berm::contact::this_file {
namespace {

/// A bed of cells of 0.1 m below y = 0, filled by a lattice, with a rigid body on it.
struct Bed {
  mesh::Mesh<2> mesh;
  bodies::Particles<2> particles;
  ContactPoints<2> found;

  explicit Bed(Real spacing)
  {
    mesh::BoxMesh box;
    box.lower = {-1, -0.5};
    box.size = {2, 1};
    box.cells = {20, 10};
    mesh = make_box<2>(box);
    bodies::BodySettings body;
    bodies::BlockSettings block;
    block.center = {0, -0.25};
    block.size = {2, 0.5};
    block.spacing = spacing;
    body.block = block;
    particles = fill<2>(mesh, "bed", body, {1000, 0, 0});
    found.node_area = found.node_weight = NodeField<Real>::zeros(mesh.node_count());
  }
  Real covered(const bodies::RigidShape<2>& shape, Detection detection = Detection::particle)
  {
    bodies::RigidBody<2> rigid;
    rigid.shape = shape;
    bodies::Pose<2> listed = found.listed = bodies::Pose<2>::nowhere();
    NodeField<Real> mass(mesh.node_count(), 1);
    detect<2>(mesh, particles, rigid, {}, listed, detection, ParticleRim::whole, mass, found);
    find_footprints(mesh, particles, shape, 0, found);
    return std::accumulate(found.footprints.begin(), found.footprints.end(), Real(0), [](Real sum, const auto& f) { return sum + f.area; });
  }
};

bodies::Box<2> plate(Real x, Real y = 0.1)
{
  return {Vec<2>(x, y), Vec<2>(0.4, 0.1), Matrix<2>::Identity()};
}

TEST(Footprints, add_up_to_the_width_of_a_plate_for_any_number_of_particles_and_any_place)
{
  // Columns of the lattice cover the plate whatever lies where: round-off only.
  for (const Real spacing : {0.05, 1. / 30, 0.025, 0.02, 1. / 60}) {
    Bed bed(spacing);
    for (const Real x : {0., 0.013, 0.021, 0.05, -0.037}) {
      EXPECT_NEAR(bed.covered(plate(x)), 0.8, 1e-12);
      EXPECT_NEAR(bed.covered(plate(x), Detection::gap), 0.8, 1e-12);
    }
  }
}

TEST(Footprints, of_a_polygon_are_those_of_the_same_box)
{
  Bed bed(0.025);
  const auto corners = std::make_shared<const std::vector<Vec<2>>>(
      std::vector<Vec<2>>{Vec<2>(-0.4, -0.1), Vec<2>(0.4, -0.1), Vec<2>(0.4, 0.1), Vec<2>(-0.4, 0.1)});
  EXPECT_NEAR(bed.covered(bodies::Polygon<2>{Vec<2>(0.013, 0.1), Matrix<2>::Identity(), corners}), 0.8, 1e-12);
}

TEST(Footprints, of_a_half_plane_end_where_the_particles_do)
{
  Bed bed(0.025);
  EXPECT_NEAR(bed.covered(bodies::HalfPlane<2>{Vec<2>(0, 0), Vec<2>(0, -1)}), 2, 1e-12);
}

TEST(Footprints, are_none_where_a_particle_width_is_open)
{
  Bed bed(0.025);
  EXPECT_GT(bed.covered(plate(0, 0.1 + 0.49 * 0.025)), 0.79);
  EXPECT_EQ(bed.covered(plate(0, 0.1 + 0.51 * 0.025)), 0);
}

TEST(Footprints, of_a_circle_close_round_it)
{
  // A lattice without what lies in the circle: all of it is covered. The neighbours' borders are within it by construction.
  Bed bed(0.01);
  const bodies::Circle<2> hole{Vec<2>(0, -0.25), 0.1};
  bodies::Particles<2> left(bed.mesh, bed.particles.size(), {});
  bed.particles.visit([&](Index cell, Index b, int l) {
    const bodies::Particle<2> p = bed.particles.read(b, l);
    if ((p.x - hole.center).norm() > hole.radius) left.insert(cell, p);
  });
  left.sort_occupied();
  bed.particles = left;
  EXPECT_NEAR(bed.covered(hole), 2 * pi * hole.radius, 1e-12);
}

/// The bed's right half around the axis.
struct RoundBed : Bed {
  explicit RoundBed(Real spacing) : Bed(spacing)
  {
    mesh.metric = mesh::Metric::axisymmetric;
    bodies::Particles<2> right(mesh, particles.size(), {});
    particles.visit([&](Index cell, Index b, int l) {
      bodies::Particle<2> p = particles.read(b, l);
      p.volume *= p.x[0];
      if (p.x[0] > 0) right.insert(cell, p);
    });
    right.sort_occupied();
    particles = right;
  }
};

TEST(Footprints, around_an_axis_add_up_to_the_area_of_a_radian)
{
  for (const Real spacing : {0.05, 0.025, 1. / 60}) {
    RoundBed bed(spacing);
    EXPECT_NEAR(bed.covered(plate(0)), 0.4 * 0.4 / 2, 1e-12);  // a round plate of the radius 0.4 m: R^2 / 2
    EXPECT_NEAR(bed.covered(bodies::Box<2>{Vec<2>(0.5, 0.1), Vec<2>(0.2, 0.1), Matrix<2>::Identity()}), (0.7 * 0.7 - 0.3 * 0.3) / 2, 1e-12);
    EXPECT_NEAR(bed.covered(bodies::HalfPlane<2>{Vec<2>(0, 0), Vec<2>(0, -1)}), 1. / 2, 1e-12);
  }
}

TEST(Footprints, around_an_axis_that_end_within_a_particle_have_the_radius_of_what_is_left)
{
  // Borders halfway between columns of one width, and a side on which the radius grows evenly: round-off only, wherever the plate ends.
  for (const Real spacing : {0.05, 0.025, 1. / 60}) {
    RoundBed bed(spacing);
    for (const Real radius : {0.387, 0.4, 0.413}) {
      const bodies::Box<2> round{Vec<2>(0, 0.1), Vec<2>(radius, 0.1), Matrix<2>::Identity()};
      EXPECT_NEAR(bed.covered(round), radius * radius / 2, 1e-12);
    }
  }
}

TEST(Footprints, of_a_ball_add_up_to_its_surface)
{
  // Pieces of an arc are taken as straight: an error of the square of half a particle's angle, 0.025 rad, over 6.
  RoundBed bed(0.01);
  const bodies::Circle<2> hole{Vec<2>(0, -0.25), 0.2};
  bodies::Particles<2> left(bed.mesh, bed.particles.size(), {});
  bed.particles.visit([&](Index cell, Index b, int l) {
    const bodies::Particle<2> p = bed.particles.read(b, l);
    if ((p.x - hole.center).norm() > hole.radius) left.insert(cell, p);
  });
  left.sort_occupied();
  bed.particles = left;
  EXPECT_NEAR(bed.covered(hole) / (2 * hole.radius * hole.radius), 1, 1e-3);
}

TEST(Shares, add_up_to_the_covered_surface_whichever_points_press)
{
  Bed bed(0.02);
  for (const Detection detection : {Detection::particle, Detection::gap}) {
    const Real covered = bed.covered(plate(0.013), detection);
    for (const std::size_t every : {1, 2, 3}) {
      for (std::size_t k = 0; k < bed.found.list.size(); ++k)
        bed.found.list[k].impulse = k % every == 0 ? bed.found.list[k].normal : Vec<2>::Zero();
      share_surface(bed.found);
      Real sum = 0;
      for (const ContactPoint<2>& point : bed.found.list) {
        sum += point.area;
        if (point.impulse.isZero()) {
          EXPECT_EQ(point.area, 0);
        }
      }
      // Where a node is the point, a footprint can be far from any that presses: then it is out of contact.
      if (detection == Detection::particle || every == 1)
        EXPECT_NEAR(sum, covered, 1e-12);
      else
        EXPECT_LT(sum, covered + 1e-12);
    }
  }
}

TEST(WaterParts, are_pore_pressure_over_normal_stress_between_none_and_all)
{
  Bed bed(0.02);
  bed.covered(plate(0.013));
  for (const auto& [water, total, part] : {std::tuple{2e3, 8e3, 0.25}, {8e3, 8e3, 1.}, {8e3, -1e3, 1.}, {-2e3, 8e3, 0.}, {0., 0., 0.}}) {
    for (ContactPoint<2>& point : bed.found.list) {
      point.touching = true;
      point.pore_pressure = water;
      point.soil_pressure = total;
    }
    find_water_fractions(bed.found, bed.mesh);
    for (const ContactPoint<2>& point : bed.found.list) EXPECT_NEAR(point.water_fraction, part, 1e-12);
  }
}

TEST(WaterParts, are_those_of_touching_points_around)
{
  Bed bed(0.02);
  bed.covered(plate(0.013));
  for (std::size_t k = 0; k < bed.found.list.size(); ++k) {
    ContactPoint<2>& point = bed.found.list[k];
    point.touching = k % 4 != 0;
    point.soil_pressure = 1e3 * Real(1 + k % 3);
    point.pore_pressure = point.touching ? 0.4 * point.soil_pressure : 1e9;
  }
  find_water_fractions(bed.found, bed.mesh);
  Real most = 0;
  for (const ContactPoint<2>& point : bed.found.list) most = std::max(most, point.water_fraction);
  EXPECT_NEAR(most, 0.4, 1e-12);
}

TEST(Shares, go_to_bonded_points_that_carry_nothing_too)
{
  Bed bed(0.02);
  const Real covered = bed.covered(plate(0.013));
  for (std::size_t k = 0; k < bed.found.list.size(); ++k) {
    ContactPoint<2>& point = bed.found.list[k];
    point.bonded = k % 2 == 0;
    point.impulse = k % 3 == 0 ? point.normal : Vec<2>((k % 3 == 1 ? -1. : 0.) * point.normal);
  }
  share_surface(bed.found);
  Real sum = 0;
  for (const ContactPoint<2>& point : bed.found.list) {
    sum += point.area;
    EXPECT_EQ(point.area > 0, point.bonded || point.impulse.dot(point.normal) > 0);
  }
  EXPECT_NEAR(sum, covered, 1e-12);
}

}  // namespace
}  // namespace berm::contact::this_file
