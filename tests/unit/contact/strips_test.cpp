// SPDX-License-Identifier: BSD-3-Clause
#include "contact/strips.hpp"

#include "mesh/box.hpp"

#include <gtest/gtest.h>
#include <numeric>
#include <set>

namespace berm::contact::this_file {
namespace {

/// A mesh of many strips.
template <int dim>
mesh::Mesh<dim> box_of_many_cells()
{
  mesh::BoxMesh box;
  box.size = dim == 2 ? std::vector<Real>{3, 2} : std::vector<Real>{1, 1, 1};
  box.cells = dim == 2 ? std::vector<Real>{30, 20} : std::vector<Real>{6, 6, 6};
  return make_box<dim>(box);
}

/// All cells of a mesh but every seventh, in strips.
template <int dim>
ContactPoints<dim> near_cells(const mesh::Mesh<dim>& mesh)
{
  ContactPoints<dim> found;
  found.near_index = CellField<Index>::zeros(mesh.cell_count());
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
    if (cell % 7 == 3) continue;
    found.near_cells.push_back(cell);
    found.near_index[cell] = static_cast<Index>(found.near_cells.size());
  }
  order_by_strips(mesh, found);
  return found;
}

template <class Dimension>
class Strips : public testing::Test {
};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(Strips, Dimensions);

TYPED_TEST(Strips, of_one_colour_share_no_node)
{
  constexpr int dim = TypeParam::value;
  const mesh::Mesh<dim> mesh = box_of_many_cells<dim>();
  const ContactPoints<dim> found = near_cells(mesh);
  ASSERT_GT(found.first_near_cell.size(), 2 * found.color_begin.size()) << "few strips have a colour in common";
  for (std::size_t c = 0; c + 1 < found.color_begin.size(); ++c) {
    std::set<Index> of_color;
    for (Index s = found.color_begin[c]; s < found.color_begin[c + 1]; ++s) {
      std::set<Index> of_strip;
      for (Index k = found.first_near_cell[s]; k < found.first_near_cell[s + 1]; ++k)
        of_strip.insert(mesh.nodes[found.near_cells[k]].begin(), mesh.nodes[found.near_cells[k]].end());
      for (Index node : of_strip) EXPECT_TRUE(of_color.insert(node).second) << "node " << node << " of colour " << c;
    }
  }
}

TYPED_TEST(Strips, hold_each_cell_once_in_runs_along_the_mesh)
{
  constexpr int dim = TypeParam::value;
  const mesh::Mesh<dim> mesh = box_of_many_cells<dim>();
  const ContactPoints<dim> found = near_cells(mesh);
  std::set<Index> cells;
  for (std::size_t s = 0; s + 1 < found.first_near_cell.size(); ++s)
    for (Index k = found.first_near_cell[s]; k < found.first_near_cell[s + 1]; ++k) {
      EXPECT_TRUE(cells.insert(found.near_cells[k]).second);
      EXPECT_TRUE(k == found.first_near_cell[s] || found.near_cells[k - 1] < found.near_cells[k]);
    }
  EXPECT_EQ(cells.size(), static_cast<std::size_t>(mesh.cell_count() - (mesh.cell_count() + 3) / 7));
  EXPECT_EQ(found.first_near_cell.back(), static_cast<Index>(found.near_cells.size()));
  EXPECT_EQ(found.color_begin.back(), static_cast<Index>(found.first_near_cell.size()) - 1);
}

TEST(StripsOfNodes, are_of_one_colour_and_hold_all_points)
{
  for (const std::size_t points : {0u, 1u, 16u, 17u, 1000u}) {
    ContactPoints<2> found;
    found.list.resize(points);
    set_strips_of_nodes(found);
    EXPECT_EQ(found.color_begin.size(), 2u);
    int visited = 0;
    for_each_point(found, [&](ContactPoint<2>& point) {
      point.gap += 1;
#pragma omp atomic
      ++visited;
    });
    EXPECT_EQ(visited, static_cast<int>(points));
    for (const ContactPoint<2>& point : found.list) EXPECT_EQ(point.gap, 1);
  }
}

TEST(StripsOfNodes, are_none_before_the_first_step)
{
  ContactPoints<2> found;
  for_each_point(found, [](const ContactPoint<2>&) { FAIL(); });
}

}  // namespace
}  // namespace berm::contact::this_file
