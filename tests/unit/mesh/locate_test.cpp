// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/mesh.hpp"

#include "samples/sample_meshes.hpp"

#include <gtest/gtest.h>

namespace berm::mesh::this_file {
namespace {

template <int dim>
Real smallest_shape(const Mesh<dim>& mesh, Index cell, const Vec<dim>& x)
{
  Real smallest = infinity;
  for (int k = 0; k <= dim; ++k) smallest = std::min(smallest, mesh.shape(cell).value(k, x));
  return smallest;
}

template <int dim>
void expect_found(const Mesh<dim>& mesh, int count)
{
  std::mt19937 random(3);
  std::uniform_int_distribution<Index> any_cell(0, mesh.cell_count() - 1);
  for (int n = 0; n < count; ++n) {
    const Vec<dim> x = random_point<dim>(random, mesh.lower, mesh.upper);
    const Location found = locate(mesh, x, any_cell(random));
    ASSERT_TRUE(found.inside) << x.transpose();
    ASSERT_GE(smallest_shape(mesh, found.cell, x), -1e-12);
  }
}

TEST(Locate, finds_the_cell_of_any_point_from_any_start)
{
  expect_found(shaken_box<2>(), 2000);
  expect_found(shaken_box<3>(), 2000);
  expect_found(make_box<2>(sample_box<2>(BoxPattern::criss_cross)), 2000);
}

TEST(Locate, finds_nodes_and_points_on_faces)
{
  const auto mesh = shaken_box<3>();
  for (Index i = 0; i < mesh.node_count(); ++i) EXPECT_TRUE(locate<3>(mesh, mesh.position[i], i % mesh.cell_count()).inside);
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    const Vec<3> middle = (mesh.position[mesh.nodes[c][0]] + mesh.position[mesh.nodes[c][1]]) / 2;
    EXPECT_TRUE(locate<3>(mesh, middle, 0).inside);
  }
}

TEST(Locate, finds_points_on_faces_of_a_mesh_far_from_the_origin)
{
  // Here rounding of the shape functions (1e-16 x 1000 m / 0.01 m = 1e-11) exceeds the 1e-12 that a point may be outside its cell.
  const auto mesh = make_box<2>({.lower = {1000, -700}, .size = {0.1, 0.1}, .cells = {10, 10}});
  for (Index i = 0; i < mesh.node_count(); ++i)
    for (const Index start : {0, 57, 199}) EXPECT_TRUE(locate<2>(mesh, mesh.position[i], start).inside);
  expect_found(make_box<2>({.lower = {1000, -700}, .size = {0.1, 0.1}, .cells = {10, 10}}), 500);
}

TEST(Locate, finds_points_of_a_mesh_at_survey_coordinates)
{
  // Coordinates have a resolution of 9e-10 m, which is 9e-8 of a cell: a point of a face may lie so far beyond it.
  const auto mesh = make_box<2>({.lower = {499'876.543, 6'543'210.987}, .size = {0.1, 0.1}, .cells = {10, 10}});
  const Real resolution = std::numeric_limits<Real>::epsilon() * mesh.upper[1];
  for (Index c = 0; c < mesh.cell_count(); ++c)
    for (int k = 0; k < 3; ++k) {
      const Vec<2>&a = mesh.position[mesh.nodes[c][k]], &b = mesh.position[mesh.nodes[c][(k + 1) % 3]];
      for (const Real part : {0., 0.3, 0.7}) {
        const Vec<2> x = a + part * (b - a);
        const Location found = locate<2>(mesh, x, 57);
        EXPECT_TRUE(found.inside) << x.transpose();
        EXPECT_GE(smallest_shape(mesh, found.cell, x), -resolution / 0.007);  // heights of 7 mm
      }
    }
  for (const Real beyond : {1e-6, 1e-3}) {
    EXPECT_FALSE(locate<2>(mesh, mesh.upper + Vec<2>(beyond, -0.05), 57).inside);
    EXPECT_FALSE(locate<2>(mesh, mesh.lower - Vec<2>(-0.05, beyond), 57).inside);
  }
}

template <int dim>
void expect_outside(const Mesh<dim>& mesh)
{
  std::mt19937 random(4);
  std::uniform_int_distribution<Index> any_cell(0, mesh.cell_count() - 1);
  const Vec<dim> size = mesh.upper - mesh.lower;
  int tried = 0;
  while (tried < 500) {
    const Vec<dim> x = random_point<dim>(random, mesh.lower - size, mesh.upper + size);
    if ((x.array() > mesh.lower.array()).all() && (x.array() < mesh.upper.array()).all()) continue;
    ++tried;
    const Location found = locate(mesh, x, any_cell(random));
    ASSERT_FALSE(found.inside) << x.transpose();
    bool beyond_free_face = false;
    for (int k = 0; k <= dim; ++k) beyond_free_face |= mesh.neighbor(found.cell, k) == none && mesh.shape(found.cell).value(k, x) < 0;
    ASSERT_TRUE(beyond_free_face);
  }
}

TEST(Locate, reports_points_outside_and_the_cell_where_it_left_the_mesh)
{
  expect_outside(shaken_box<2>());
  expect_outside(shaken_box<3>());
}

TEST(Locate, reports_a_position_that_is_no_number_as_outside)
{
  const auto mesh = shaken_box<2>();
  EXPECT_FALSE(locate<2>(mesh, {NAN, 0.5}, 7).inside);
  EXPECT_FALSE(locate<2>(mesh, {0.5, infinity}, 7).inside);
}

TEST(Locate, finds_points_behind_a_hole)
{
  // A slit from the left cuts the way; a walk straight up from below it ends at a boundary although the mesh goes on above.
  const auto whole = make_box<2>({.lower = {}, .size = {10, 10}, .cells = {10, 10}});
  Mesh<2> mesh;
  mesh.position = whole.position;
  mesh.region_names = {"box"};
  const auto in_slit = [](const Vec<2>& x) { return x[0] < 8 && x[1] > 4 && x[1] < 6; };
  for (Index c = 0; c < whole.cell_count(); ++c)
    if (!in_slit(whole.centroid(c))) mesh.nodes.push_back(whole.nodes[c]);
  mesh.region.assign(mesh.cell_count(), 0);
  mesh.complete();
  std::mt19937 random(5);
  std::uniform_int_distribution<Index> any_cell(0, mesh.cell_count() - 1);
  for (int n = 0; n < 1000; ++n) {
    const Vec<2> x = random_point<2>(random, mesh.lower, mesh.upper);
    const Location found = locate(mesh, x, any_cell(random));
    ASSERT_EQ(found.inside, !in_slit(x)) << x.transpose();
    if (found.inside) {
      ASSERT_GE(smallest_shape(mesh, found.cell, x), -1e-12);
    }
  }
}

}  // namespace
}  // namespace berm::mesh::this_file
