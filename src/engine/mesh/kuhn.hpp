// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/mesh/box_test.cpp
#pragma once

#include "mesh/mesh.hpp"

#include <algorithm>
#include <numeric>

namespace berm::mesh {

/// Adds Kuhn's simplices of one brick of a grid, dim! of them: one for each order in which a path from its lower corner, the grid point `at`, to its upper one
/// can take the axes. point(at) gives the node at a grid point.
template <int dim, class PointAt>
void add_kuhn_cells(Mesh<dim>& mesh, const std::array<Index, dim>& at, const PointAt& point)
{
  std::array<int, dim> axes;
  std::iota(axes.begin(), axes.end(), 0);
  do {
    std::array<Index, dim> walker = at;
    typename Mesh<dim>::Corners corner;
    corner[0] = point(walker);
    for (int k = 0; k < dim; ++k) {
      ++walker[axes[k]];
      corner[k + 1] = point(walker);
    }
    mesh.nodes.push_back(corner);
  } while (std::next_permutation(axes.begin(), axes.end()));
}

}  // namespace berm::mesh
