// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/spatial_seabed.hpp"

#include "mesh/mesh_settings.hpp"
#include "mesh/patches.hpp"
#include "os/error.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace berm::mesh::this_file {
namespace {

/// Half a bed: its back wall is a plane of symmetry.
SeabedMesh sample_bed()
{
  return {.length = 2,
          .depth = 0.8,
          .headroom = 0.4,
          .left = 0.9,
          .near_size = 0.05,
          .near_left = -0.2,
          .near_right = 0.4,
          .near_depth = 0.2,
          .near_height = 0.1,
          .growth = 0.2,
          .far_size = 0.2,
          .layer = 0.1,
          .width = 1,
          .back = 0,
          .near_back = 0,
          .near_front = 0.3};
}

Real volume_of(const Mesh<3>& mesh, const std::string& name)
{
  Real volume = 0;
  for (Index c = 0; c < mesh.cell_count(); ++c)
    if (mesh.region[c] == mesh.find_region(name)) volume += mesh.volume(c);
  return volume;
}

Real smallest_height(const Mesh<3>& mesh)
{
  Real smallest = infinity;
  for (Index c = 0; c < mesh.cell_count(); ++c) smallest = std::min(smallest, mesh.height(c));
  return smallest;
}

/// The message that refuses the bed; empty where it is taken.
std::string refusal_of(const SeabedMesh& bed)
{
  try {
    make_spatial_seabed(bed);
  } catch (const KeyError& error) {
    return error.what();
  }
  return "";
}

#define EXPECT_SAYS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)

TEST(SpatialSeabed, regions_have_their_exact_volumes_and_no_layer_lies_at_the_plane_of_symmetry)
{
  const Mesh<3> mesh = make_spatial_seabed(sample_bed());
  const Real near = 0.6 * 0.2 * 0.3, inner = 1.8 * 0.7 * 0.9;
  // Sums of ten thousand volumes stay far below 1e-9.
  EXPECT_NEAR(volume_of(mesh, "near"), near, 1e-9);
  EXPECT_NEAR(volume_of(mesh, "bed"), inner - near, 1e-9);
  EXPECT_NEAR(volume_of(mesh, "layer"), 2 * 0.8 * 1 - inner, 1e-9);
  EXPECT_NEAR(volume_of(mesh, "headroom"), 2 * 0.4 * 1, 1e-9);
}

TEST(SpatialSeabed, boundaries_have_all_nodes_of_their_planes_and_no_others)
{
  const Mesh<3> mesh = make_spatial_seabed(sample_bed());
  const std::tuple<const char*, int, Real> planes[] = {{"left", 0, -0.9}, {"right", 0, 1.1}, {"base", 1, -0.8}, {"top", 1, 0.4},
                                                       {"back", 2, 0},    {"front", 2, 1},   {"surface", 1, 0.}};
  for (const auto& [name, axis, at] : planes) {
    Index there = 0;
    for (const Vec<3>& x : mesh.position) there += std::abs(x[axis] - at) < 1e-12;
    EXPECT_GT(there, 0) << name;
    const std::vector<Index>& nodes = mesh.boundary_nodes[mesh.find_boundary(name)];
    EXPECT_EQ(static_cast<Index>(nodes.size()), there) << name;
    for (const Index i : nodes) EXPECT_NEAR(mesh.position[i][axis], at, 1e-12) << name;
  }
}

TEST(SpatialSeabed, its_number_of_cells_is_known_before_it_is_made)
{
  SeabedMesh bed = sample_bed();
  EXPECT_EQ(expected_cells(bed), make_spatial_seabed(bed).cell_count());
  bed.growth = 0;
  EXPECT_EQ(expected_cells(bed), make_spatial_seabed(bed).cell_count());
}

TEST(SpatialSeabed, the_fine_zone_alone_sets_the_time_step)
{
  // The smallest height of a Kuhn tetrahedron in a cube of side h is h over the root of 2; bricks outside have no shorter side than that.
  EXPECT_NEAR(smallest_height(make_spatial_seabed(sample_bed())), 0.05 / std::sqrt(2.), 1e-9);
}

TEST(SpatialSeabed, no_side_of_a_brick_is_longer_than_its_size_at_that_distance)
{
  const SeabedMesh bed = sample_bed();
  const Mesh<3> mesh = make_spatial_seabed(bed);
  for (Index c = 0; c < mesh.cell_count(); ++c)
    for (int d = 0; d < 3; ++d) {
      Real low = infinity, high = -infinity;
      for (const Index i : mesh.nodes[c]) low = std::min(low, mesh.position[i][d]), high = std::max(high, mesh.position[i][d]);
      ASSERT_LE(high - low, *bed.far_size * 1.001);
    }
}

TEST(SpatialSeabed, patches_have_six_cells)
{
  const Mesh<3> mesh = make_spatial_seabed(sample_bed());
  const Patches patches = make_patches(mesh);
  Index in_sixes = 0;
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    int count = 0;
    for_each_in_patch(patches, c, [&](Index) { ++count; });
    in_sixes += count == 6;
  }
  EXPECT_GT(in_sixes, 0.8 * mesh.cell_count());
}

TEST(SpatialSeabed, surface_follows_slope_trench_and_step)
{
  SeabedMesh bed = sample_bed();
  bed.slope = 0.1;
  bed.trench = Trench{.depth = 0.1, .width = 0.2, .side_slope = 45 * degree, .center = 0.1};
  SeabedMesh stepped = sample_bed();
  stepped.step = Step{.height = 0.1, .position = 0.5, .face_slope = 45 * degree};
  for (const SeabedMesh& uneven : {bed, stepped}) {
    const Mesh<3> mesh = make_spatial_seabed(uneven);
    const GroundLine line = ground_of(uneven);
    for (const Index i : mesh.boundary_nodes[mesh.find_boundary("surface")])
      EXPECT_NEAR(mesh.position[i][1], line.height(mesh.position[i][0]), 1e-12);
    Real soil = 0;
    for (const char* region : {"near", "bed", "layer"}) soil += volume_of(mesh, region);
    const Real face = 0.1 * 0.1 / 2, rise = uneven.step ? face + 0.1 * (1.1 - 0.6) : -(0.2 * 0.1 + 2 * face);
    // Cells follow straight parts of the surface, whose corners are nodes: the volume is exact but for the slope, along which the bed has its depth everywhere.
    EXPECT_NEAR(soil, 2 * 0.8 + rise, 1e-9);
  }
}

TEST(SpatialSeabed, layer_at_the_base_has_one_thickness_below_trench_and_step)
{
  SeabedMesh trench = sample_bed(), step = sample_bed();
  trench.trench = Trench{.depth = 0.1, .width = 0.2, .side_slope = 45 * degree, .center = 0.1};
  step.step = Step{.height = 0.1, .position = 0.5, .face_slope = 45 * degree};
  for (const SeabedMesh& uneven : {trench, step}) {
    const Mesh<3> mesh = make_spatial_seabed(uneven);
    const auto nodes_at = [&](Real y) {
      return std::count_if(mesh.position.begin(), mesh.position.end(), [&](const Vec<3>& x) { return std::abs(x[1] - y) < 1e-12; });
    };
    EXPECT_EQ(nodes_at(-0.7), nodes_at(-0.8));  // each level of bricks has as many
  }
}

TEST(SpatialSeabed, refuses_what_is_inconsistent_by_one_clear_message)
{
  const auto message_of = [](const auto& change) {
    SeabedMesh bed = sample_bed();
    change(bed);
    return refusal_of(bed);
  };
  EXPECT_EQ(refusal_of(sample_bed()), "");
  EXPECT_SAYS(message_of([](SeabedMesh& b) { b.near_front.reset(); }), "mesh.near_front: is missing");
  EXPECT_SAYS(message_of([](SeabedMesh& b) { b.near_front = 0.95; }), "mesh.near_front: 0.95 m must be 0.15 m or more from the front wall");
  EXPECT_SAYS(message_of([](SeabedMesh& b) { b.near_back = -0.1; }), "mesh.near_back: -0.1 m must be");
  EXPECT_SAYS(message_of([](SeabedMesh& b) { b.near_front = 0.02; }), "narrower than near_size");
  EXPECT_SAYS(message_of([](SeabedMesh& b) { b.near_size = 1e-3; }), "mesh.near_size: about");
  EXPECT_SAYS(message_of([](SeabedMesh& b) { b.trench = Trench{.depth = 0.1, .width = 0.2, .side_slope = 80 * degree, .center = 0.1}; }),
              "mesh.trench.side_slope: is 80 deg");
  EXPECT_SAYS(message_of([](SeabedMesh& b) { b.step = Step{.height = 0.2, .position = 0.5, .face_slope = 45 * degree}; }),
              "mesh.headroom: the surface rises by 0.2 m");
}

TEST(SpatialSeabed, a_plane_case_refuses_its_keys_and_one_in_space_asks_for_them)
{
  EXPECT_THROW(make_mesh<2>(sample_bed(), ".", "."), KeyError);
  SeabedMesh plane = sample_bed();
  plane.width.reset();
  EXPECT_THROW(make_mesh<3>(plane, ".", "."), KeyError);
}

}  // namespace
}  // namespace berm::mesh::this_file
