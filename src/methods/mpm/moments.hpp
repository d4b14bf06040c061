// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mpm/grid.hpp"

namespace berm::mpm {

/// The sum of what the cells of a node give it, in a fixed order.
template <int dim>
[[gnu::always_inline]] inline Components<dim> gathered(const mesh::Mesh<dim>& mesh, const BodyGrid<dim>& grid, Index node)
{
  Components<dim> sum{};
  for (Index e = mesh.first_entry[node]; e < mesh.first_entry[node + 1]; ++e) sum += components<dim>(grid.at(mesh.entries[e]).sum);
  return sum;
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
