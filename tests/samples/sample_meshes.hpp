// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mesh/box.hpp"

#include <random>

namespace berm {

template <int dim>
Vec<dim> random_point(std::mt19937& random, const Vec<dim>& lower, const Vec<dim>& upper)
{
  Vec<dim> x;
  for (int d = 0; d < dim; ++d) x[d] = std::uniform_real_distribution<Real>(lower[d], upper[d])(random);
  return x;
}

/// A box of 2.1 x 1.2 (x 0.9) m whose lower corner is at (-0.3, 0.2 (, 1)) m.
template <int dim>
mesh::BoxMesh sample_box(mesh::BoxPattern pattern = mesh::BoxPattern::diagonal)
{
  mesh::BoxMesh box{.lower = {-0.3, 0.2, 1}, .size = {2.1, 1.2, 0.9}, .cells = {7, 4, 3}, .pattern = pattern};
  box.lower.resize(dim);
  box.size.resize(dim);
  box.cells.resize(dim);
  return box;
}

/// The sample box with its inner nodes moved at random, so that no two cells are alike.
template <int dim>
mesh::Mesh<dim> shaken_box(unsigned seed = 1)
{
  mesh::Mesh<dim> mesh = make_box<dim>(sample_box<dim>());
  std::mt19937 random(seed);
  const Vec<dim> reach = Vec<dim>::Constant(0.05);  // a sixth of the cells' side: no cell turns over
  NodeField<char> fixed(mesh.node_count(), false);
  for (const auto& list : mesh.boundary_nodes)
    for (const Index i : list) fixed[i] = true;
  for (Index i = 0; i < mesh.node_count(); ++i)
    if (!fixed[i]) mesh.position[i] += random_point<dim>(random, -reach, reach);
  mesh.complete();
  return mesh;
}

}  // namespace berm
