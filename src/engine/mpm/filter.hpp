// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/mpm/velocities_filter_test.cpp
#pragma once

#include "mpm/patch_cells.hpp"

namespace berm::mpm {

/// The part of the difference between the velocities of a cell's particles and the smooth one that the filter takes out in a step of dt (s).
template <int dim>
[[gnu::always_inline]] inline Real filter_part(Real dt, Index cell, const BodyGrid<dim>& grid)
{
  return std::min(Real(1), dt * grid.filter_speed / grid.height[cell]);
}

/// What the particles of a patch get back, m/s: the filter moves no momentum between patches. There are as many patches as nodes, about, and twice as many cells:
/// velocities of cells that cancel at the nodes would stay where each cell kept its own momentum.
template <int dim>
[[gnu::always_inline]] inline Vec<dim> filter_shift_of(const PatchCells& patch, const mesh::Mesh<dim>& mesh, Real dt,
                                                       const BodyGrid<dim>& grid)
{
  Vec<dim> momentum = Vec<dim>::Zero();
  Real mass = 0;
  for (const Index member : patch) {
    const Moments<dim>& t = grid.moments[member];
    Vec<dim> lost;  // momentum, N s
    for (int d = 0; d < dim; ++d) {
      lost[d] = t.mv[d];
      for (int k = 0; k <= dim; ++k) lost[d] -= grid.corners[member][k].mass * grid.smooth_velocity[mesh.nodes[member][k]][d];
    }
    momentum += filter_part(dt, member, grid) * lost;
    mass += t.m;
  }
  return momentum / mass;
}

}  // namespace berm::mpm
