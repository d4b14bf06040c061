// SPDX-License-Identifier: BSD-3-Clause
#include "fem/fem_problem.hpp"

#include <gtest/gtest.h>

namespace berm::fem::this_file {
namespace {

/// A triangle that leans, and its neighbour.
QuadraticMesh two_triangles()
{
  QuadraticMesh mesh;
  const Vec<2> corners[4] = {{1, 2}, {1.4, 2.1}, {1.1, 2.5}, {1.6, 2.7}};
  const int of[2][3] = {{0, 1, 2}, {1, 3, 2}};
  mesh.nodes.assign(2);
  std::vector<Vec<2>> places;
  for (Index cell = 0; cell < 2; ++cell)
    for (int k = 0; k < 6; ++k) {
      const Vec<2> a = corners[of[cell][k % 3]], b = corners[of[cell][(k + 1) % 3]];
      places.push_back(k < 3 ? a : Vec<2>((a + b) / 2));
      mesh.nodes[cell][k] = static_cast<Index>(places.size()) - 1;
    }
  mesh.position.assign(static_cast<Index>(places.size()), Vec<2>(0, 0));
  for (Index i = 0; i < mesh.node_count(); ++i) mesh.position[i] = places[i];
  mesh.body.assign(2, 0);
  return mesh;
}

Real at_nodes(const QuadraticMesh& mesh, const FemWatch& watch, Real (*field)(const Vec<2>&))
{
  Real sum = 0;
  for (int k = 0; k < 6; ++k) sum += watch.of_nodes[k] * field(mesh.position[mesh.nodes[watch.cell][k]]);
  return sum;
}

Real at_points(const QuadraticMesh& mesh, const FemWatch& watch, Real (*field)(const Vec<2>&))
{
  const AtSixNodes<Vec<2>> nodes = mesh.positions_of(watch.cell);
  Real sum = 0;
  for (int q = 0; q < triangle_points; ++q) {
    Vec<2> x = Vec<2>::Zero();
    for (int k = 0; k < 6; ++k) x += shape_at(nodes, q).value[k] * nodes[k];
    sum += watch.of_points[q] * field(x);
  }
  return sum;
}

Real linear(const Vec<2>& x)
{
  return 3 - 5 * x[0] + 7 * x[1];
}
Real quadratic(const Vec<2>& x)
{
  return linear(x) + x[0] * x[1] - 2 * x[1] * x[1];
}

}  // namespace

// Round-off: numbers of 15 from sums of six.
TEST(FemWatch, reads_a_quadratic_displacement_and_a_linear_stress_at_its_point)
{
  const QuadraticMesh mesh = two_triangles();
  for (const Vec<2>& x : {Vec<2>(1.15, 2.2), Vec<2>(1.4, 2.1), Vec<2>(1.25, 2.3), Vec<2>(1.45, 2.5)}) {
    const FemWatch watch = make_watch(mesh, "tip", x, 0);
    EXPECT_NEAR(at_nodes(mesh, watch, quadratic), quadratic(x), 1e-13);
    EXPECT_NEAR(at_points(mesh, watch, linear), linear(x), 1e-13);
  }
  EXPECT_EQ(make_watch(mesh, "tip", {1.15, 2.2}, 0).cell, 0);
  EXPECT_EQ(make_watch(mesh, "tip", {1.45, 2.5}, 0).cell, 1);
}

TEST(FemWatch, of_a_point_beside_the_body_is_at_its_rim)
{
  const QuadraticMesh mesh = two_triangles();
  const FemWatch watch = make_watch(mesh, "tip", {0.9, 1.8}, 0);
  EXPECT_NEAR(at_nodes(mesh, watch, linear), linear({1, 2}), 1e-13);
}

}  // namespace berm::fem::this_file
