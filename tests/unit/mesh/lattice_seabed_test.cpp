// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/lattice_seabed.hpp"

#include "mesh/patches.hpp"
#include "os/error.hpp"
#include "samples/error_of.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <map>
#include <set>

namespace berm::mesh::this_file {
namespace {

SeabedMesh lattice_bed()
{
  SeabedMesh bed;
  bed.pattern = SeabedPattern::lattice;
  bed.length = 12;
  bed.depth = 3.1;
  bed.headroom = 1.4;
  bed.near_size = 0.1;
  bed.near_left = -2;
  bed.near_right = 2;
  bed.near_depth = 0.7;
  bed.near_height = 0.5;
  bed.growth = 0.25;
  bed.far_size = 0.5;
  bed.layer = 0.6;
  return bed;
}

/// A position as a key, to a millionth of a metre.
std::pair<long, long> key(const Vec<2>& x)
{
  return {std::lround(x[0] * 1e6), std::lround(x[1] * 1e6)};
}

using PatchesOfRegions = std::set<std::pair<std::string, std::set<std::pair<long, long>>>>;

/// For each patch the centres of its cells, with x times `side`, and the name of their region.
PatchesOfRegions patches_of(const Mesh<2>& mesh, Real side)
{
  const Patches patches = make_patches(mesh);
  PatchesOfRegions all;
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
    std::set<std::pair<long, long>> centers;
    for_each_in_patch(patches, cell, [&](Index of) {
      const Vec<2> x = mesh.centroid(of);
      centers.insert(key({side * x[0], x[1]}));
    });
    all.insert({mesh.region_names[mesh.region[cell]], centers});
  }
  return all;
}

/// Patches of one that the other has not.
PatchesOfRegions missing(const PatchesOfRegions& one, const PatchesOfRegions& other)
{
  PatchesOfRegions all;
  std::set_difference(one.begin(), one.end(), other.begin(), other.end(), std::inserter(all, all.end()));
  return all;
}

TEST(LatticeSeabed, is_its_own_mirror_image_with_its_regions_and_patches)
{
  const Mesh<2> mesh = make_lattice_seabed(lattice_bed());
  EXPECT_EQ(missing(patches_of(mesh, 1), patches_of(mesh, -1)), PatchesOfRegions{});
  SeabedMesh even = lattice_bed();  // centres on the borders of regions
  even.growth = 0;
  EXPECT_EQ(missing(patches_of(make_lattice_seabed(even), 1), patches_of(make_lattice_seabed(even), -1)), PatchesOfRegions{});
  SeabedMesh to_the_right = lattice_bed(), to_the_left = lattice_bed();
  to_the_right.near_right = to_the_left.near_right = 0.5;
  to_the_left.near_left = -0.5, to_the_left.near_right = 2;
  EXPECT_EQ(missing(patches_of(make_lattice_seabed(to_the_right), 1), patches_of(make_lattice_seabed(to_the_left), -1)),
            PatchesOfRegions{});
}

TEST(LatticeSeabed, fills_the_bed_with_equilateral_triangles_in_its_fine_zone)
{
  const SeabedMesh bed = lattice_bed();
  const Mesh<2> mesh = make_lattice_seabed(bed);
  std::map<std::string, Real> area;
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
    area[mesh.region_names[mesh.region[cell]]] += mesh.section(cell);
    if (mesh.region_names[mesh.region[cell]] == "near") {
      EXPECT_NEAR(mesh.height(cell), std::sqrt(3.) / 2 * bed.near_size, 1e-12);
      EXPECT_NEAR(mesh.section(cell), std::sqrt(3.) / 4 * bed.near_size * bed.near_size, 1e-12);
    }
    EXPECT_GE(mesh.height(cell), 0.5 * bed.near_size);
  }
  EXPECT_NEAR(area["near"] + area["bed"] + area["layer"], bed.length * bed.depth, 1e-9);
  EXPECT_NEAR(area["headroom"], bed.length * bed.headroom, 1e-9);
  EXPECT_GE(area["near"], 4 * 0.7);
  EXPECT_LE(area["near"], 4.2 * 0.8);
  EXPECT_EQ(mesh.cell_count(), cells_in_lattice(bed));
  for (const auto& [name, axis, at] :
       {std::tuple{"left", 0, -6.}, {"right", 0, 6.}, {"base", 1, -3.1}, {"top", 1, 1.4}, {"surface", 1, 0.}}) {
    std::set<Index> there;
    for (Index i = 0; i < mesh.node_count(); ++i)
      if (std::abs(mesh.position[i][axis] - at) < 1e-9) there.insert(i);
    const auto& named = mesh.boundary_nodes[mesh.find_boundary(name)];
    EXPECT_EQ(std::set<Index>(named.begin(), named.end()), there) << name;
  }
}

TEST(LatticeSeabed, has_the_middle_of_a_side_of_the_surface_below_the_body)
{
  const Mesh<2> mesh = make_lattice_seabed(lattice_bed());
  Real nearest = 1;
  for (const Index i : mesh.boundary_nodes[mesh.find_boundary("surface")]) nearest = std::min(nearest, std::abs(mesh.position[i][0]));
  EXPECT_NEAR(nearest, 0.05, 1e-12);
}

TEST(LatticeSeabed, has_patches_of_two_or_three_cells_in_its_fine_zone_but_for_its_middle_and_ends)
{
  const Mesh<2> mesh = make_lattice_seabed(lattice_bed());
  const Patches patches = make_patches(mesh);
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
    if (mesh.region_names[mesh.region[cell]] != "near") continue;
    int count = 0;
    for_each_in_patch(patches, cell, [&](Index) { ++count; });
    EXPECT_LE(count, 3);
    const Real x = std::abs(mesh.centroid(cell)[0]);
    EXPECT_TRUE(count >= 2 || x < 1e-9 || x > 1.9) << mesh.centroid(cell).transpose();
  }
}

TEST(LatticeSeabed, has_no_thin_row_where_the_fine_zone_comes_near_to_the_base)
{
  SeabedMesh bed = lattice_bed();
  bed.layer = 0;
  for (Real depth = 0.8; depth < 1; depth += 0.013) {
    bed.depth = depth;
    const Mesh<2> mesh = make_lattice_seabed(bed);
    for (Index cell = 0; cell < mesh.cell_count(); ++cell) EXPECT_GT(mesh.height(cell), 0.4 * bed.near_size) << depth;
  }
}

TEST(LatticeSeabed, of_half_a_bed_is_half_of_that_of_the_whole)
{
  SeabedMesh half = lattice_bed();
  half.length = 6;
  half.left = 0;
  half.near_left = 0;
  const Mesh<2> whole = make_lattice_seabed(lattice_bed()), right = make_lattice_seabed(half);
  std::set<std::pair<long, long>> of_whole, of_half;
  for (const Vec<2>& x : whole.position)
    if (x[0] > 1e-9) of_whole.insert(key(x));
  for (const Vec<2>& x : right.position)
    if (x[0] > 1e-9) of_half.insert(key(x));
  EXPECT_EQ(of_half, of_whole);
}

TEST(LatticeSeabed, goes_along_with_a_slope)
{
  SeabedMesh bed = lattice_bed();
  bed.slope = 0.1;
  const Mesh<2> level = make_lattice_seabed(lattice_bed()), sloping = make_lattice_seabed(bed);
  ASSERT_EQ(level.cell_count(), sloping.cell_count());
  for (const Index i : sloping.boundary_nodes[sloping.find_boundary("surface")])
    EXPECT_NEAR(sloping.position[i][1], std::tan(0.1) * sloping.position[i][0], 1e-12);
}

TEST(LatticeSeabed, is_refused_in_space_with_a_trench_or_a_step_and_away_from_the_body)
{
  SeabedMesh trench = lattice_bed(), step = lattice_bed();
  trench.trench = Trench{0.2, 1, 0.5, 0};
  step.step = Step{0.2, 0, 0.5};
  SeabedMesh space = lattice_bed(), elsewhere = lattice_bed(), beside_axis = lattice_bed();
  space.width = 2, space.near_back = -0.3, space.near_front = 0.3;
  elsewhere.near_left = 1;
  beside_axis.left = 0, beside_axis.near_left = 0.9;
  for (const SeabedMesh& bed : {trench, step, space, elsewhere, beside_axis})
    EXPECT_NE(test::error_of<KeyError>([&] { make_lattice_seabed(bed); }).find("mesh.pattern"), std::string::npos);
}

}  // namespace
}  // namespace berm::mesh::this_file
