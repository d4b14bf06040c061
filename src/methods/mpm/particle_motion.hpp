// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/mpm/move_test.cpp
#pragma once

#include "mpm/linear_field.hpp"

#include <algorithm>

namespace berm::mpm {

/// A point that round-off put beyond a face is moved onto it: negative shape functions become zero. True where it was no more than that.
template <int dim>
bool clamp_to_cell(const mesh::Mesh<dim>& mesh, Index cell, Vec<dim>& x)
{
  const mesh::Shape<dim> shape = mesh.shape(cell);
  const Real round_off = 1e-9 + shape.rounding_at(x);  // of a cell's height
  Real n[dim + 1], total = 0;
  for (int k = 0; k <= dim; ++k) {
    n[k] = shape.value(k, x);
    if (n[k] < -round_off) return false;
    total += n[k] = std::max(n[k], Real(0));
  }
  x.setZero();
  for (int k = 0; k <= dim; ++k) x += n[k] / total * mesh.position[mesh.nodes[cell][k]];
  return true;
}

/// What a pass over the particles takes to the totals, J.
struct WorkDone {
  Real internal = 0;
  Real viscous = 0;   ///< part of it that the bulk viscosity takes
  Real filtered = 0;  ///< kinetic energy that the filter takes out

  WorkDone& operator+=(const WorkDone& other)
  {
    internal += other.internal;
    viscous += other.viscous;
    filtered += other.filtered;
    return *this;
  }
};

/// Finds the new cell of a particle that has left its own, and notes the change. A call here would change what the compiler does to the loop around it, and
/// the last bits.
template <int dim>
[[gnu::always_inline]] inline void note_cell_change(const mesh::Mesh<dim>& mesh, Workspace<dim>& workspace, Index cell, Index index,
                                                    bodies::Block<dim>& block, int lane)
{
  Vec<dim> at;
  for (int d = 0; d < dim; ++d) at[d] = block.x[d][lane];
  const mesh::Location found = locate(mesh, at, cell);
  const bool in_mesh = found.inside || clamp_to_cell(mesh, found.cell, at);
  for (int d = 0; d < dim; ++d) block.x[d][lane] = at[d];
  if (!in_mesh || found.cell != cell) workspace.cell_changes[omp_get_thread_num()].push_back({cell, index, in_mesh ? found.cell : none});
}

/// Notes which particles of a part have left their cell: those whose smallest shape function is negative.
template <class P, class V, int dim>
[[gnu::always_inline]] inline void note_cell_changes(const P& part, const V& min_shape, const mesh::Mesh<dim>& mesh,
                                                     Workspace<dim>& workspace, Index cell, bodies::Block<dim>& p, bodies::Block<dim>& q)
{
  const typename Part<V>::Mask leaves = part.alive() & (min_shape < V{});
  if (any(leaves)) [[unlikely]]
    for (int l = 0; l < part.size; ++l)
      if (leaves[l]) note_cell_change(mesh, workspace, cell, part.index + l, l < lanes ? p : q, (part.first + l) % lanes);
}

// Numbers are handed to these parts of the pass by reference: by value the compiler fuses other multiplications with additions, and the last bits change.
// The strain is not cut out for the same reason; where the bits stay, its law is not inlined and the pass takes a quarter longer.

/// Moves a part of a cell's particles and gives their smallest shape function where they are then.
/// All is found by the place from the cell's corner 0; only what is stored is rounded to the resolution of the coordinates.
template <class V, int dim, class P>
[[gnu::always_inline]] inline V move_part(const P& part, bodies::Block<dim>& p, bodies::Block<dim>& q, const mesh::Shape<dim>& shape,
                                          const LinearField<dim>& gain, const LinearField<dim>& velocity, const Real& dt,
                                          const Real& unfiltered)
{
  const typename Part<V>::Mask alive = part.alive();
  V old_x[dim], from_corner[dim], at[dim];
  for (int d = 0; d < dim; ++d) old_x[d] = part.get(p.x[d], q.x[d]), from_corner[d] = old_x[d] - shape.origin[d];
  for (int d = 0; d < dim; ++d) {
    const V v = part.get(p.v[d], q.v[d]);
    const V new_v = alive ? unfiltered * v + gain.at(d, from_corner) : v;
    part.set(p.v[d], q.v[d], new_v);
    const V x = alive ? old_x[d] + dt * velocity.at(d, from_corner) : old_x[d];
    part.set(p.x[d], q.x[d], x);
    at[d] = x - shape.origin[d];
  }
  V min_shape = 1 - V{}, of_corner_0 = 1 - V{};
  for (int k = 0; k < dim; ++k) {
    V n = shape.gradients[k][0] * at[0];
    for (int d = 1; d < dim; ++d) n += shape.gradients[k][d] * at[d];
    of_corner_0 -= n;
    min_shape = smaller(min_shape, n);
  }
  return smaller(min_shape, of_corner_0);
}

}  // namespace berm::mpm
