// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/critical_length.hpp"

#include "samples/sample_meshes.hpp"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

namespace berm::mesh::this_file {
namespace {

using MatrixX = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
using VectorX = Eigen::Matrix<Real, Eigen::Dynamic, 1>;

template <int dim>
Mesh<dim> simplex(const std::vector<Vec<dim>>& corners)
{
  Mesh<dim> mesh;
  for (const Vec<dim>& x : corners) mesh.position.push_back(x);
  typename Mesh<dim>::Corners nodes;
  for (int k = 0; k <= dim; ++k) nodes[k] = k;
  mesh.nodes.push_back(nodes);
  mesh.region.push_back(0);
  mesh.region_names.emplace_back("soil");
  mesh.complete();
  return mesh;
}

/// 2 over the highest frequency, from all of the stiffness and masses, each entry by itself.
template <int dim>
Real length_of_whole_matrix(const Mesh<dim>& mesh, const Patches& patches, Real shear)
{
  const bool around_axis = mesh.metric == Metric::axisymmetric;
  const int normals = around_axis ? 3 : dim;
  const Index unknowns = dim * mesh.node_count();
  const Real bulk = 1 - 2 * shear * (1 - 1. / normals);
  MatrixX stiffness = MatrixX::Zero(unknowns, unknowns);
  VectorX mass = VectorX::Zero(unknowns);
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
    const Shape<dim> shape = mesh.shape(cell);
    const Real volume = mesh.volume(cell), radius = mesh.centroid(cell)[0];
    // Rows: the normal strains, then the shear strains times the root of 2.
    const int rows = normals + dim * (dim - 1) / 2;
    MatrixX strain = MatrixX::Zero(rows, unknowns);
    for (int k = 0; k <= dim; ++k) {
      const Index first = dim * mesh.nodes[cell][k];
      int row = normals;
      for (int a = 0; a < dim; ++a) {
        strain(a, first + a) = shape.gradient(k)[a];
        for (int b = a + 1; b < dim; ++b, ++row) {
          strain(row, first + a) = shape.gradient(k)[b] / std::sqrt(2);
          strain(row, first + b) = shape.gradient(k)[a] / std::sqrt(2);
        }
      }
      if (around_axis) strain(2, first) = 1 / (3 * radius);
      const Real section = volume / (around_axis ? radius : 1);
      Real share = section / (dim + 1);
      if (around_axis) {  // the middles of the sides integrate N r
        share = 0;
        for (int a = 0; a < 3; ++a)
          for (int b = a + 1; b < 3; ++b) {
            const Vec<dim> middle = (mesh.position[mesh.nodes[cell][a]] + mesh.position[mesh.nodes[cell][b]]) / 2;
            share += section / 3 * shape.value(k, middle) * middle[0];
          }
      }
      for (int d = 0; d < dim; ++d) mass[first + d] += share;
    }
    MatrixX deviator = strain;
    const MatrixX trace = strain.topRows(normals).colwise().sum();
    for (int a = 0; a < normals; ++a) deviator.row(a) -= trace / normals;
    stiffness += 2 * shear * volume * deviator.transpose() * deviator;
    Real of_patch = 0;
    MatrixX change = MatrixX::Zero(1, unknowns);
    for_each_in_patch(patches, cell, [&](Index member) {
      const Shape<dim> other = mesh.shape(member);
      of_patch += mesh.volume(member);
      for (int k = 0; k <= dim; ++k) {
        const Index first = dim * mesh.nodes[member][k];
        for (int a = 0; a < dim; ++a) change(0, first + a) += mesh.volume(member) * other.gradient(k)[a];
        if (around_axis) change(0, first) += mesh.volume(member) / (3 * mesh.centroid(member)[0]);
      }
    });
    stiffness += bulk * volume / (of_patch * of_patch) * change.transpose() * change;
  }
  const VectorX inverse_root = mass.cwiseSqrt().cwiseInverse();
  const MatrixX scaled = inverse_root.asDiagonal() * stiffness * inverse_root.asDiagonal();
  return 2 / std::sqrt(Eigen::SelfAdjointEigenSolver<MatrixX>(scaled).eigenvalues().maxCoeff());
}

// Of one cell with all sides alike the frequencies are known: omega^2 = 9 (1 - shear) / h^2 of swelling and 9 shear / h^2 of shearing in the plane, and
// (16 - 64/3 shear) / h^2 and 32/3 shear / h^2 in space.
TEST(CriticalLength, of_a_single_regular_cell_is_exact)
{
  const Mesh<2> triangle = simplex<2>({{0, 0}, {2, 0}, {1, std::sqrt(3)}});
  const Mesh<3> tetrahedron = simplex<3>({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}});
  for (const Real shear : {0., 0.1, 1. / 3, 0.5, 0.7}) {
    EXPECT_NEAR(critical_length(triangle, make_patches(triangle), shear),
                triangle.height(0) * 2 / 3 / std::sqrt(std::max(1 - shear, shear)), 1e-12);
    EXPECT_NEAR(critical_length(tetrahedron, make_patches(tetrahedron), shear),
                tetrahedron.height(0) * 2 / std::sqrt(std::max(16 - 64 * shear / 3, 32 * shear / 3)), 1e-12);
  }
}

template <int dim>
void expect_that_of_whole_matrix(const Mesh<dim>& mesh, const Patches& patches)
{
  for (const Real shear : {0.05, 0.3, 0.5}) {
    const Real length = critical_length(mesh, patches, shear), exact = length_of_whole_matrix(mesh, patches, shear);
    EXPECT_LE(length, exact * (1 + 1e-9)) << shear;
    EXPECT_GE(length, exact * 0.99) << shear;
  }
}

/// Few cells, since all of their matrix is made; no two are alike.
template <int dim>
Mesh<dim> small_box(Metric metric = Metric::cartesian)
{
  BoxMesh box = sample_box<dim>();
  box.cells.assign(dim, 2);
  Mesh<dim> mesh = make_box<dim>(box);
  std::mt19937 random(1);
  const Vec<dim> reach = Vec<dim>::Constant(0.05);
  for (Vec<dim>& x : mesh.position)
    x += random_point<dim>(random, -reach, reach) - (metric == Metric::axisymmetric ? 2 * mesh.lower[0] : 0) * Vec<dim>::UnitX();
  mesh.metric = metric;
  mesh.complete();
  return mesh;
}

TEST(CriticalLength, is_within_a_percent_of_that_of_the_whole_matrix_and_not_above_it)
{
  expect_that_of_whole_matrix(small_box<2>(), make_patches(small_box<2>()));
  expect_that_of_whole_matrix(small_box<2>(), make_patches(small_box<2>(), 1));
  expect_that_of_whole_matrix(small_box<3>(), make_patches(small_box<3>()));
  const Mesh<2> ring = small_box<2>(Metric::axisymmetric);
  expect_that_of_whole_matrix(ring, make_patches(ring));
}

// A flat cell has help from those around it, so the mesh is stable for longer than the cell would be alone.
TEST(CriticalLength, is_longer_than_that_of_its_smallest_cell_alone)
{
  const Mesh<3> mesh = small_box<3>();
  Real alone = infinity;
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
    std::vector<Vec<3>> corners;
    for (const Index node : mesh.nodes[cell]) corners.push_back(mesh.position[node]);
    const Mesh<3> single = simplex<3>(corners);
    alone = std::min(alone, critical_length(single, make_patches(single), 0.3));
  }
  EXPECT_GT(critical_length(mesh, make_patches(mesh), 0.3), 1.2 * alone);
}

}  // namespace
}  // namespace berm::mesh::this_file
