// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/uneven_seabed.hpp"

#include "mesh/mesh_settings.hpp"
#include "os/error.hpp"
#include "samples/temporary_folder.hpp"

#include <functional>
#include <gtest/gtest.h>

namespace berm::mesh::this_file {
namespace {

SeabedMesh sample_bed()
{
  return {.length = 0.65,
          .depth = 0.14,
          .headroom = 0.06,
          .left = 0.3,
          .near_size = 0.003,
          .near_left = -0.05,
          .near_right = 0.07,
          .near_depth = 0.025,
          .near_height = 0.015,
          .far_size = 0.015};
}

Real area_of(const Mesh<2>& mesh, const std::string& name)
{
  const Index region = mesh.find_region(name);
  Real area = 0;
  for (Index c = 0; c < mesh.cell_count(); ++c)
    if (mesh.region[c] == region) area += mesh.volume(c);
  return area;
}

Mesh<2> mesh_of(const SeabedMesh& bed)
{
  const TemporaryFolder folder;
  return make_mesh<2>(bed, ".", folder.path());
}

/// Soil below the surface and nothing of it above, cells that follow it, and none of them flat.
void expect_good(const SeabedMesh& bed)
{
  const Mesh<2> mesh = mesh_of(bed);
  const GroundLine ground = ground_of(bed);
  const FineZone fine = fine_zone_of(bed);
  const Index headroom = mesh.find_region("headroom");
  Index near = 0, surface = 0;
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    EXPECT_GT(mesh.height(c), 0.3 * bed.near_size) << mesh.centroid(c).transpose();
    const Vec<2> x = mesh.centroid(c);
    EXPECT_EQ(mesh.region[c] == headroom, x[1] > ground.height(x[0])) << x.transpose();
    const Real y = x[1] - std::tan(bed.slope) * x[0];
    if (x[0] < fine.left || x[0] > fine.right || y < fine.lower || y > fine.upper) continue;
    ++near;
    EXPECT_LT(mesh.volume(c), 2 * std::sqrt(3.) / 4 * bed.near_size * bed.near_size);
  }
  EXPECT_GT(near, 100);
  for (const Index i : mesh.boundary_nodes[mesh.find_boundary("surface")]) {
    EXPECT_LT(ground.distance(mesh.position[i]), 1e-12);
    surface += mesh.position[i][0] > fine.left && mesh.position[i][0] < fine.right;
  }
  EXPECT_GE(surface, static_cast<Index>(0.9 * (fine.right - fine.left) / bed.near_size));
  for (const Index i : mesh.boundary_nodes[mesh.find_boundary("base")])
    EXPECT_NEAR(mesh.position[i][1], -bed.depth + std::tan(bed.slope) * mesh.position[i][0], 1e-12);
}

TEST(UnevenSeabed, slopes_both_ways)
{
  for (const Real slope : {-30., -10., 5., 20., 45.})
    for (const Real layer : {0., 0.02}) {
      SCOPED_TRACE(testing::Message() << slope << " deg, layer " << layer);
      SeabedMesh bed = sample_bed();
      bed.slope = slope * degree;
      bed.layer = layer;
      expect_good(bed);
    }
}

TEST(UnevenSeabed, has_trenches_of_any_sides)
{
  for (const Real side : {15., 45., 70., 89.})
    for (const Real center : {0., -0.06, 0.1, 0.2}) {
      SCOPED_TRACE(testing::Message() << side << " deg, center " << center);
      SeabedMesh bed = sample_bed();
      bed.trench = Trench{.depth = 0.03, .width = 0.04, .side_slope = side * degree, .center = center};
      if (side == 15) bed.trench->depth = 0.015;
      expect_good(bed);
    }
}

TEST(UnevenSeabed, has_steps_up_and_down)
{
  for (const Real height : {-0.03, 0.02})
    for (const Real face : {20., 60., 89.})
      for (const Real position : {-0.049, 0.02, 0.0695}) {
        SCOPED_TRACE(testing::Message() << height << " m, " << face << " deg, at " << position);
        SeabedMesh bed = sample_bed();
        bed.step = Step{.height = height, .position = position, .face_slope = face * degree};
        expect_good(bed);
      }
}

TEST(UnevenSeabed, has_a_trench_on_a_slope)
{
  SeabedMesh bed = sample_bed();
  bed.slope = 10 * degree;
  bed.layer = 0.02;
  bed.trench = Trench{.depth = 0.02, .width = 0.05, .side_slope = 60 * degree};
  expect_good(bed);
  EXPECT_NEAR(ground_of(bed).height(0.01), -0.02 + std::tan(10 * degree) * 0.01, 1e-15);
  EXPECT_NEAR(ground_before_trench(bed).height(0.01), std::tan(10 * degree) * 0.01, 1e-15);
}

TEST(UnevenSeabed, has_the_area_that_its_trench_leaves)
{
  SeabedMesh bed = sample_bed();
  const Mesh<2> flat = mesh_of(bed);
  bed.trench = Trench{.depth = 0.03, .width = 0.04, .side_slope = 45 * degree};
  const Mesh<2> cut = mesh_of(bed);
  const auto soil = [](const Mesh<2>& mesh) { return area_of(mesh, "near") + area_of(mesh, "bed"); };
  EXPECT_NEAR(soil(flat) - soil(cut), 0.03 * (0.04 + 0.03), 1e-12);
}

TEST(UnevenSeabed, ascends_along_x_by_a_positive_slope)
{
  SeabedMesh bed = sample_bed();
  EXPECT_TRUE(ground_of(bed).level());
  bed.slope = 10 * degree;
  EXPECT_NEAR(ground_of(bed).height(0.1), 0.1 * std::tan(10 * degree), 1e-15);
  EXPECT_NEAR(ground_of(bed).height(0), 0, 1e-15);
}

TEST(UnevenSeabed, refuses_what_does_not_fit_with_key_and_advice)
{
  const auto refused = [](const char* begin, const char* advice, const std::function<void(SeabedMesh&)>& change) {
    SeabedMesh bed = sample_bed();
    change(bed);
    try {
      check(bed);
      ADD_FAILURE() << "accepted: " << begin;
    } catch (const KeyError& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with(std::string("mesh.") + begin)) << error.what();
      EXPECT_NE(std::string(error.what()).find(advice), std::string::npos) << error.what();
    }
  };
  const auto trench = [](Real depth, Real width, Real side, Real center = 0) {
    return [=](SeabedMesh& bed) { bed.trench = Trench{depth, width, side * degree, center}; };
  };
  const auto step = [](Real height, Real position, Real face) {
    return [=](SeabedMesh& bed) { bed.step = Step{height, position, face * degree}; };
  };
  refused("slope: is 573 deg", "write \"10 deg\"", [](SeabedMesh& bed) { bed.slope = 10; });
  refused("slope", "-45 and 45", [](SeabedMesh& bed) { bed.slope = -46 * degree; });
  refused("slope", "-45 and 45", [](SeabedMesh& bed) { bed.slope = NAN; });
  refused("trench.side_slope: is 89.5 deg", "at most 89 deg", trench(0.03, 0.04, 89.5));
  refused("trench.side_slope", "more than 0", trench(0.03, 0.04, 0));
  refused("trench.depth", "mesh.depth larger", trench(0.2, 0.04, 45));
  refused("trench.depth", "must be positive", trench(-0.03, 0.04, 45));
  refused("trench.depth", "less than a cell", trench(0.001, 0.04, 45));
  refused("trench.width", "narrower than a cell", trench(0.03, 0.001, 45));
  refused("trench.center", "mesh.length larger", trench(0.03, 0.04, 45, 0.3));
  refused("trench.center", "mesh.length larger", trench(0.03, 0.04, 4));
  refused("near_depth", "mesh.depth larger", trench(0.12, 0.04, 45));
  refused("step.height", "at least a cell", step(0.001, 0, 45));
  refused("step.height", "mesh.depth larger", step(-0.2, 0, 45));
  refused("step.face_slope", "at most 89 deg", step(0.02, 0, 90));
  refused("step.position", "mesh.length larger", step(0.02, 0.34, 45));
  refused("headroom", "at least 0.063 m", step(0.045, 0, 45));
  refused("step: cannot be combined with a trench", "Gmsh", [&](SeabedMesh& bed) { trench(0.03, 0.04, 45)(bed), step(0.02, 0, 45)(bed); });
}

}  // namespace
}  // namespace berm::mesh::this_file
