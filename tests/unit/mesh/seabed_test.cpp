// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/seabed.hpp"

#include "mesh/mesh_settings.hpp"
#include "os/error.hpp"
#include "os/gmsh_program.hpp"
#include "samples/sample_meshes.hpp"
#include "samples/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace berm::mesh::this_file {
namespace {

SeabedMesh sample_bed()
{
  return {.length = 0.65,
          .depth = 0.14,
          .headroom = 0.03,
          .left = 0.3,
          .near_size = 0.002,
          .near_left = -0.03,
          .near_right = 0.06,
          .near_depth = 0.025,
          .near_height = 0.015,
          .far_size = 0.012,
          .layer = 0.02};
}

Real area_of(const Mesh<2>& mesh, const std::string& name)
{
  const Index region = mesh.find_region(name);
  Real area = 0;
  for (Index c = 0; c < mesh.cell_count(); ++c)
    if (mesh.region[c] == region) area += mesh.volume(c);
  return area;
}

void expect_area(const Mesh<2>& mesh, const std::string& name, Real expected)
{
  // Coordinates are written with 16 digits; sums of a thousand cells stay far below 1e-9.
  EXPECT_NEAR(area_of(mesh, name), expected, 1e-9 * expected) << name;
}

TEST(SeabedMesh, regions_have_their_exact_areas)
{
  const TemporaryFolder folder;
  const auto mesh = make_mesh<2>(sample_bed(), ".", folder.path());
  expect_area(mesh, "near", 0.09 * 0.025);
  expect_area(mesh, "bed", (0.65 - 0.04) * (0.14 - 0.02) - 0.09 * 0.025);
  expect_area(mesh, "layer", 0.65 * 0.14 - (0.65 - 0.04) * (0.14 - 0.02));
  expect_area(mesh, "headroom", 0.65 * 0.03);
  EXPECT_EQ(mesh.region_names.size(), 4u);
}

TEST(SeabedMesh, the_fine_zone_may_begin_at_the_left_wall)
{
  for (const Real layer : {0., 0.02}) {
    const TemporaryFolder folder;
    SeabedMesh bed = sample_bed();
    bed.left = 0;
    bed.near_left = 0;
    bed.layer = layer;
    const auto mesh = make_mesh<2>(bed, ".", folder.path());
    expect_area(mesh, "near", 0.06 * 0.025);
    expect_area(mesh, "bed", (0.65 - layer) * (0.14 - layer) - 0.06 * 0.025);
    expect_area(mesh, "headroom", 0.65 * 0.03);
    Index on_wall = 0;
    for (const Index i : mesh.boundary_nodes[mesh.find_boundary("left")]) {
      EXPECT_EQ(mesh.position[i][0], 0);
      ++on_wall;
    }
    for (Index i = 0; i < mesh.node_count(); ++i) on_wall -= mesh.position[i][0] == 0;
    EXPECT_EQ(on_wall, 0);  // all nodes there, and no others
  }
}

TEST(SeabedMesh, without_a_layer_the_bed_reaches_the_walls)
{
  const TemporaryFolder folder;
  SeabedMesh bed = sample_bed();
  bed.layer = 0;
  const auto mesh = make_mesh<2>(bed, ".", folder.path());
  expect_area(mesh, "bed", 0.65 * 0.14 - 0.09 * 0.025);
  expect_area(mesh, "headroom", 0.65 * 0.03);
  EXPECT_EQ(mesh.find_region("layer"), none);
  EXPECT_NEAR(mesh.lower[0], -0.3, 1e-15);
}

TEST(SeabedMesh, surface_and_borders_of_the_layer_are_lines_of_the_mesh)
{
  const TemporaryFolder folder;
  const SeabedMesh bed = sample_bed();
  const auto mesh = make_mesh<2>(bed, ".", folder.path());
  Index headroom = mesh.find_region("headroom"), layer = mesh.find_region("layer");
  for (Index c = 0; c < mesh.cell_count(); ++c)
    for (const Index i : mesh.nodes[c]) {
      const Vec<2> x = mesh.position[i];
      // To rounding: gmsh writes the surface's nodes as y = 0 up to 1e-17 or so.
      if (mesh.region[c] == headroom) {
        EXPECT_GE(x[1], -1e-12);
      } else {
        EXPECT_LE(x[1], 1e-12);
        const Real inside = std::min({x[0] + 0.3 - bed.layer, 0.35 - bed.layer - x[0], x[1] + bed.depth - bed.layer});
        if (mesh.region[c] == layer) {
          EXPECT_LE(inside, 1e-12);
        } else {
          EXPECT_GE(inside, -1e-12);
        }
      }
    }
}

TEST(SeabedMesh, boundaries_lie_on_the_walls)
{
  const TemporaryFolder folder;
  const auto mesh = make_mesh<2>(sample_bed(), ".", folder.path());
  const auto expect_on = [&](const char* name, int direction, Real coordinate) {
    std::vector<Index> expected;
    for (Index i = 0; i < mesh.node_count(); ++i)
      if (std::abs(mesh.position[i][direction] - coordinate) < 1e-12) expected.push_back(i);
    ASSERT_NE(mesh.find_boundary(name), none) << name;
    EXPECT_EQ(mesh.boundary_nodes[mesh.find_boundary(name)], expected) << name;
  };
  expect_on("left", 0, -0.3);
  expect_on("right", 0, 0.35);
  expect_on("base", 1, -0.14);
  expect_on("top", 1, 0.03);
}

TEST(SeabedMesh, cells_have_the_size_that_was_asked_for)
{
  const TemporaryFolder folder;
  const SeabedMesh bed = sample_bed();
  const auto mesh = make_mesh<2>(bed, ".", folder.path());
  // A mesher keeps sizes on average, single cells within a factor of 2. An equilateral triangle of side h has area sqrt(3)/4 h2.
  const Real wanted = std::sqrt(3.) / 4 * bed.near_size * bed.near_size;
  Index count = 0;
  Real area = 0;
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    EXPECT_GT(mesh.height(c), 0.4 * bed.near_size);
    const Vec<2> x = mesh.centroid(c);
    const bool near = x[0] > bed.near_left && x[0] < bed.near_right && x[1] > -bed.near_depth && x[1] < bed.near_height;
    if (!near) continue;
    ++count;
    area += mesh.volume(c);
    EXPECT_LT(mesh.volume(c), 2 * wanted);
    EXPECT_GT(mesh.volume(c), wanted / 2);
  }
  EXPECT_NEAR(area / count / wanted, 1, 0.1);
  EXPECT_NEAR(mesh.cell_count() / expected_cells(bed), 1, 0.06);
  for (Index c = 0; c < mesh.cell_count(); ++c) EXPECT_LT(mesh.volume(c), 3 * std::sqrt(3.) / 4 * 0.012 * 0.012);
}

TEST(SeabedMesh, is_the_same_every_time)
{
  const TemporaryFolder first, second;
  make_mesh<2>(sample_bed(), ".", first.path());
  make_mesh<2>(sample_bed(), ".", second.path());
  EXPECT_GT(first.read("mesh.msh").size(), 1000u);
  EXPECT_EQ(first.read("mesh.msh"), second.read("mesh.msh"));
  EXPECT_EQ(first.read("mesh.geo"), second.read("mesh.geo"));
}

TEST(SeabedMesh, may_have_its_fine_zone_anywhere_in_the_bed)
{
  const TemporaryFolder folder;
  SeabedMesh bed = sample_bed();
  bed.far_size.reset();
  bed.growth = 0.3;
  bed.near_left = -0.2;
  bed.near_right = -0.15;
  const auto left = make_mesh<2>(bed, ".", folder.path());
  expect_area(left, "near", 0.05 * 0.025);
  EXPECT_NEAR(left.cell_count() / expected_cells(bed), 1, 0.06);
  bed.near_left = 0.1;
  bed.near_right = 0.2;
  expect_area(make_mesh<2>(bed, ".", folder.path()), "near", 0.1 * 0.025);
}

TEST(SeabedMesh, may_be_small_enough_for_numbers_with_exponents)
{
  const TemporaryFolder folder;
  SeabedMesh bed = sample_bed();
  bed.left.reset();
  for (Real* length : {&bed.length, &bed.depth, &bed.headroom, &bed.near_size, &bed.near_left, &bed.near_right, &bed.near_depth,
                       &bed.near_height, &*bed.far_size, &bed.layer})
    *length *= 1e-3;
  const auto mesh = make_mesh<2>(bed, ".", folder.path());
  expect_area(mesh, "near", 0.09 * 0.025 * 1e-6);
  EXPECT_NEAR(mesh.cell_count() / expected_cells(bed), 1, 0.06);
}

// A grid of samples over the whole bed would miss the fine zone.
TEST(SeabedMesh, counts_the_cells_of_a_fine_zone_that_is_small_in_a_large_bed)
{
  SeabedMesh bed;
  bed.length = bed.depth = bed.headroom = 1e6;
  bed.near_size = 1e-4;
  bed.near_left = -1;
  bed.near_right = 1;
  bed.near_depth = bed.near_height = 0.5;
  EXPECT_GT(expected_cells(bed), 2 / (1e-8 * std::sqrt(3.) / 4));
  EXPECT_THROW(check(bed), InputError);
  bed.near_size = 1e-12;
  EXPECT_THROW(check(bed), InputError);
}

TEST(SeabedMesh, lengths_that_do_not_fit_are_refused)
{
  const TemporaryFolder folder;
  const auto refused = [&](const char* word, const auto& change) {
    SeabedMesh bed = sample_bed();
    change(bed);
    try {
      write_geo(bed, folder / "mesh.geo");
      ADD_FAILURE() << "accepted: " << word;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
    }
  };
  refused("length", [](SeabedMesh& bed) { bed.length = NAN; });
  refused("depth", [](SeabedMesh& bed) { bed.depth = 0; });
  refused("growth", [](SeabedMesh& bed) { bed.growth = -1; });
  refused("near_left", [](SeabedMesh& bed) { bed.near_left = -0.29; });
  refused("near_right", [](SeabedMesh& bed) { bed.near_right = 0.34; });
  refused("near_right", [](SeabedMesh& bed) { bed.near_right = -0.03; });
  refused("near_depth", [](SeabedMesh& bed) { bed.near_depth = 0.12; });
  refused("near_depth", [](SeabedMesh& bed) { bed.near_depth = 0; });
  refused("near_height", [](SeabedMesh& bed) { bed.near_height = 0; });
  refused("headroom", [](SeabedMesh& bed) { bed.headroom = 0.016; });
  refused("far_size", [](SeabedMesh& bed) { bed.far_size = 0.001; });
  refused("layer", [](SeabedMesh& bed) { bed.layer = 0.001; });
  refused("near_left", [](SeabedMesh& bed) { bed.left = 0.01; });
  refused("cells", [](SeabedMesh& bed) { bed.near_size = 1e-7; });
  EXPECT_THROW(make_mesh<3>(sample_bed(), ".", folder.path()), InputError);
  EXPECT_THROW(write_geo(sample_bed(), folder / "no folder/mesh.geo"), RunError);
}

}  // namespace
}  // namespace berm::mesh::this_file
