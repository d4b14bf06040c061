// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/mpm/velocities_filter_test.cpp
#pragma once

#include "mpm/linear_field.hpp"

namespace berm::mpm {

/// What the filter takes from the particles of a patch. They get it back, so that it moves no momentum between patches: momentum over mass, m/s. There are as many
/// patches as nodes, about, and twice as many cells: velocities of cells that cancel at the nodes would stay where each cell kept its own momentum.
template <int dim>
struct FilteredMomentum {
  Components<dim> momentum{};  ///< kg m/s
  Real mass = 0;               ///< kg

  [[gnu::always_inline]] void add(const mesh::Mesh<dim>& mesh, const BodyGrid<dim>& grid, Index cell, Real fraction)
  {
    const Moments<dim>& t = grid.moments[cell];
    const auto& corners = grid.corners[cell];
    const AtCorners<dim> smooth = at_corners(mesh.nodes[cell], grid.smooth_velocity);
    Components<dim> lost{};
    for (int k = 0; k <= dim; ++k) {
      lost += components<dim>(t.momentum[k]) - corners[k].mass * smooth[k];
      mass += corners[k].mass;
    }
    momentum += fraction * lost;
  }
};

}  // namespace berm::mpm
