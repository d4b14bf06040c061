// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/patches.hpp"

#include "sample_meshes.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace berm {
namespace {

Index size_of(const Patch& patch)
{
  return static_cast<Index>(std::find(patch.begin(), patch.end(), none) - patch.begin());
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
class Patches : public testing::Test {
};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(Patches, Dimensions);

TYPED_TEST(Patches, hold_every_cell_once)
{
  constexpr int dim = TypeParam::value;
  for (const auto& mesh : meshes<dim>())
    for (const int rounds : {1, 2, 3}) {
      const auto patches = make_patches(mesh, rounds);
      ASSERT_EQ(patches.size(), mesh.cell_count());
      for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
        const Patch& patch = patches[cell];
        const Index size = size_of(patch);
        EXPECT_TRUE(std::all_of(patch.begin() + size, patch.end(), [](Index other) { return other == none; }));
        EXPECT_TRUE(std::is_sorted(patch.begin(), patch.begin() + size));
        EXPECT_EQ(std::count(patch.begin(), patch.begin() + size, cell), 1);
        for (Index k = 0; k < size; ++k) EXPECT_EQ(patches[patch[k]], patch);  // its members have the same patch: no cell is in two
      }
    }
}

TYPED_TEST(Patches, are_connected_by_faces_and_stay_in_one_region)
{
  constexpr int dim = TypeParam::value;
  for (const auto& mesh : meshes<dim>())
    for (const int rounds : {1, 2, 3}) {
      const auto patches = make_patches(mesh, rounds);
      for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
        const Patch& patch = patches[cell];
        const auto end = patch.begin() + size_of(patch);
        std::vector<Index> reached = {cell};
        for (std::size_t k = 0; k < reached.size(); ++k)
          for (Index other : mesh.neighbor[reached[k]])
            if (std::find(patch.begin(), end, other) != end && std::find(reached.begin(), reached.end(), other) == reached.end())
              reached.push_back(other);
        EXPECT_EQ(static_cast<Index>(reached.size()), size_of(patch));
        for (Index member : reached) EXPECT_EQ(mesh.region[member], mesh.region[cell]);
      }
    }
}

TEST(Patches2D, are_pairs_with_few_exceptions)
{
  for (const auto& mesh : meshes<2>()) {
    const auto patches = make_patches(mesh, 1);
    Index pairs = 0;
    for (const Patch& patch : patches) {
      pairs += size_of(patch) == 2;
      EXPECT_GE(size_of(patch), 2);  // none is left alone
      EXPECT_LE(size_of(patch), 4);
    }
    EXPECT_GE(pairs, 0.85 * mesh.cell_count());
  }
}

TEST(Patches3D, are_of_four_cells_with_few_exceptions)
{
  for (const auto& mesh : meshes<3>()) {
    const auto patches = make_patches(mesh, 2);
    Index fours = 0;
    for (const Patch& patch : patches) {
      fours += size_of(patch) == 4;
      EXPECT_GE(size_of(patch), 2);
    }
    EXPECT_GE(fours, mesh.cell_count() > 10 ? 0.7 * mesh.cell_count() : 0);
  }
}

}  // namespace
}  // namespace berm
