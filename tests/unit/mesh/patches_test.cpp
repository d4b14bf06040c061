// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/patches.hpp"

#include "samples/sample_meshes.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace berm::mesh::this_file {
namespace {

/// The cells of a patch, beginning with `cell`; cut off where its ring does not close.
std::vector<Index> ring(const Patches& patches, Index cell)
{
  std::vector<Index> members = {cell};
  while (patches[members.back()] != cell && members.size() <= max_patch_cells) members.push_back(patches[members.back()]);
  return members;
}

/// The sample box in two regions that meet along a ragged line.
template <int dim>
Mesh<dim> two_regions(Mesh<dim> mesh)
{
  mesh.region_names = {"left", "right"};
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) mesh.region[cell] = mesh.centroid(cell).sum() < mesh.lower.sum() + 1.3 ? 0 : 1;
  return mesh;
}

template <int dim>
std::vector<Mesh<dim>> meshes();
template <>
std::vector<Mesh<2>> meshes<2>()
{
  return {make_box<2>(sample_box<2>()), shaken_box<2>(), make_box<2>(sample_box<2>(BoxPattern::criss_cross)), two_regions(shaken_box<2>(2)),
          make_box<2>({.lower = {0, 0}, .size = {1, 1}, .cells = {1, 1}})};
}
template <>
std::vector<Mesh<3>> meshes<3>()
{
  return {make_box<3>(sample_box<3>()), shaken_box<3>(), two_regions(shaken_box<3>(2)),
          make_box<3>({.lower = {0, 0, 0}, .size = {1, 1, 1}, .cells = {1, 1, 1}})};
}

template <class Dimension>
class PatchesOf : public testing::Test {
};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(PatchesOf, Dimensions);

TYPED_TEST(PatchesOf, hold_every_cell_once)
{
  constexpr int dim = TypeParam::value;
  for (const auto& mesh : meshes<dim>())
    for (const int cells : {2, 4, 6, 8}) {
      const auto patches = make_patches(mesh, cells);
      ASSERT_EQ(patches.size(), mesh.cell_count());
      for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
        std::vector<Index> members = ring(patches, cell);
        EXPECT_LE(members.size(), max_patch_cells);
        EXPECT_EQ(patches[members.back()], cell);  // a ring through every cell: none is in two
        std::rotate(members.begin(), std::min_element(members.begin(), members.end()), members.end());
        EXPECT_TRUE(std::is_sorted(members.begin(), members.end()));
        std::vector<Index> visited;
        for_each_in_patch(patches, members.front(), [&](Index member) { visited.push_back(member); });
        EXPECT_EQ(visited, members);
      }
    }
}

TYPED_TEST(PatchesOf, are_connected_by_faces_and_stay_in_one_region)
{
  constexpr int dim = TypeParam::value;
  for (const auto& mesh : meshes<dim>())
    for (const int cells : {2, 4, 6, 8}) {
      const auto patches = make_patches(mesh, cells);
      for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
        const std::vector<Index> patch = ring(patches, cell);
        std::vector<Index> reached = {cell};
        for (std::size_t k = 0; k < reached.size(); ++k)
          for (int face = 0; face <= dim; ++face) {
            const Index other = mesh.neighbor(reached[k], face);
            if (std::find(patch.begin(), patch.end(), other) != patch.end() &&
                std::find(reached.begin(), reached.end(), other) == reached.end())
              reached.push_back(other);
          }
        EXPECT_EQ(reached.size(), patch.size());
        for (Index member : reached) EXPECT_EQ(mesh.region[member], mesh.region[cell]);
      }
    }
}

TEST(Patches2D, leave_the_triangles_of_squares_cut_crosswise_alone)
{
  const auto mesh = make_box<2>(sample_box<2>(BoxPattern::criss_cross));
  const auto patches = make_patches(mesh);
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) EXPECT_EQ(patches[cell], cell);
}

TEST(Patches2D, are_pairs_with_few_exceptions)
{
  for (const auto& mesh : {make_box<2>(sample_box<2>()), shaken_box<2>(), two_regions(shaken_box<2>(2))}) {
    const auto patches = make_patches(mesh);
    Index pairs = 0;
    for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
      const std::size_t size = ring(patches, cell).size();
      pairs += size == 2;
      EXPECT_GE(size, 2);  // none is left alone
      EXPECT_LE(size, 4);
    }
    EXPECT_GE(pairs, 0.85 * mesh.cell_count());
  }
}

TEST(Patches3D, of_a_cube_cut_into_six_are_the_cube)
{
  const Mesh<3> mesh = make_box<3>({.lower = {0, 0, 0}, .size = {4, 3, 2}, .cells = {4, 3, 2}});
  const auto patches = make_patches(mesh);
  const auto cube_of = [&](Index cell) { return Vec<3>(mesh.centroid(cell).array().floor()); };
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
    const std::vector<Index> patch = ring(patches, cell);
    EXPECT_EQ(patch.size(), 6);
    for (const Index member : patch) EXPECT_EQ(cube_of(member), cube_of(cell)) << cell;
  }
}

TEST(Patches3D, are_about_as_many_as_there_are_cells_over_cells_a_node)
{
  for (const auto& mesh : {make_box<3>(sample_box<3>()), shaken_box<3>()}) {
    const auto patches = make_patches(mesh);
    Index count = 0;
    for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
      const std::vector<Index> patch = ring(patches, cell);
      EXPECT_GE(patch.size(), 4);
      EXPECT_LE(patch.size(), 9);
      count += patch.front() == *std::min_element(patch.begin(), patch.end());
    }
    EXPECT_NEAR(static_cast<Real>(mesh.cell_count()) / count, 6, 0.6);
  }
}

TEST(Patches, are_single_cells_where_one_is_asked_for)
{
  const auto patches = make_patches(shaken_box<2>(), 1);
  for (Index cell = 0; cell < patches.size(); ++cell) EXPECT_EQ(patches[cell], cell);
}

}  // namespace
}  // namespace berm::mesh::this_file
