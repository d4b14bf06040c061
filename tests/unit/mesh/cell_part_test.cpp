// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/cell_part.hpp"

#include "mesh/box.hpp"

#include <gtest/gtest.h>

namespace berm::mesh::this_file {
namespace {

/// What a plane leaves of a mesh of a box: the sum over its cells.
template <int dim>
std::pair<Real, Vec<dim>> left_of(const Mesh<dim>& mesh, const Vec<dim>& normal, Real distance)
{
  Real volume = 0;
  Vec<dim> moment = Vec<dim>::Zero();
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
    std::array<Real, dim + 1> value;
    for (int k = 0; k <= dim; ++k) value[k] = normal.dot(mesh.position[mesh.nodes[cell][k]]) - distance;
    const CellPart<dim> part = positive_part(mesh, cell, value);
    volume += part.cut ? part.volume : mesh.volume(cell);
    if (dim == 2) moment += part.cut ? Vec<dim>(part.section * part.center) : Vec<dim>(mesh.section(cell) * mesh.centroid(cell));
  }
  return {volume, moment};
}

// What is above the line x + y = 0.7 in the unit square: all but a triangle of 0.7, with its centre at a third of that.
TEST(CellPart, of_triangles_adds_up_to_what_a_line_leaves_of_a_square)
{
  const Mesh<2> mesh = make_box<2>(BoxMesh{.lower = {0, 0}, .size = {1, 1}, .cells = {3, 4}});
  const auto [volume, moment] = left_of<2>(mesh, Vec<2>(1, 1), 0.7);
  EXPECT_NEAR(volume, 1 - 0.245, 1e-14);
  EXPECT_NEAR(moment[0], 0.5 - 0.245 * 0.7 / 3, 1e-14);
  EXPECT_NEAR(moment[1], 0.5 - 0.245 * 0.7 / 3, 1e-14);
}

TEST(CellPart, around_an_axis_counts_the_radius)
{
  Mesh<2> mesh = make_box<2>(BoxMesh{.lower = {0, 0}, .size = {1, 1}, .cells = {3, 4}});
  mesh.metric = Metric::axisymmetric;
  EXPECT_NEAR(left_of<2>(mesh, Vec<2>(1, 0), 0.15).first, (1 - 0.15 * 0.15) / 2, 1e-14) << "of a radian outside a pile";
}

// What is above the plane x + y + z = 0.7 in the unit cube; cells with one, two and three corners on one side are among those that it cuts.
TEST(CellPart, of_tetrahedra_adds_up_to_what_a_plane_leaves_of_a_cube)
{
  const Mesh<3> mesh = make_box<3>(BoxMesh{.lower = {0, 0, 0}, .size = {1, 1, 1}, .cells = {3, 2, 4}});
  EXPECT_NEAR(left_of<3>(mesh, Vec<3>(1, 1, 1), 0.7).first, 1 - 0.7 * 0.7 * 0.7 / 6, 1e-14);
  EXPECT_NEAR(left_of<3>(mesh, Vec<3>(0, 0, 1), 0.4).first, 0.6, 1e-14);
}

TEST(CellPart, is_all_where_no_corner_is_behind_and_nothing_where_all_are)
{
  const Mesh<2> mesh = make_box<2>(BoxMesh{.lower = {0, 0}, .size = {1, 1}, .cells = {1, 1}});
  EXPECT_FALSE(positive_part<2>(mesh, 0, {0, 0, 1}).cut) << "on the surface is outside";
  const CellPart<2> none_left = positive_part<2>(mesh, 0, {-1, -1, 0});
  EXPECT_TRUE(none_left.cut);
  EXPECT_NEAR(none_left.volume, 0, 1e-15);
}

}  // namespace
}  // namespace berm::mesh::this_file
