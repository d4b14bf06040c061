// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mpm/grid.hpp"

namespace berm::mpm {

/// Shares of the corners of a cell in a quantity: calls give(k, sum) with the sums over particles of N_k times it. Its own
/// sum is q and that of it times x is qx, with x from corner 0.
template <int dim, class Give>
[[gnu::always_inline]] inline void share_among_corners(const mesh::Shape<dim>& shape, Real q, const Real* qx, const Give& give)
{
  Real of_corner_0 = q;
  for (int k = 1; k <= dim; ++k) {
    Real sum = shape.gradients[k - 1][0] * qx[0];
    for (int d = 1; d < dim; ++d) sum += shape.gradients[k - 1][d] * qx[d];
    give(k, sum);
    of_corner_0 -= sum;
  }
  give(0, of_corner_0);
}

/// For step 1, at the end of the step before: the moments of a cell with particles, and its contributions to its corners: mass sum m N_k and momentum sum m v N_k. Compiled once for all callers, so
/// that a run and its resumption have the same bits.
template <int dim>
[[gnu::noinline]] void sum_moments_of(const mesh::Mesh<dim>& mesh, const bodies::Particles<dim>& particles, Index cell,
                                      BodyGrid<dim>& grid);

/// That of all cells with particles.
template <int dim>
void sum_moments(const mesh::Mesh<dim>& mesh, const bodies::Particles<dim>& particles, BodyGrid<dim>& grid);

/// Step 1: nodes gather mass and velocity v = momentum / mass from their cells, always in the same order. A node whose mass
/// is round-off has mass 0.
template <int dim>
void gather_mass_and_momentum(const mesh::Mesh<dim>& mesh, BodyGrid<dim>& grid);

}  // namespace berm::mpm
