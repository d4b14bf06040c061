// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/mesh.hpp"

#include <algorithm>

namespace berm::mesh {
namespace {

constexpr Real inside_tolerance = -1e-12;  // a point with no shape function below this is in the cell

// The same where no cell has the point, and round-off alone can be why.
template <int dim>
Real tolerance_of_round_off(const Shape<dim>& shape, const Vec<dim>& x)
{
  return -1e-9 - shape.rounding_at(x);
}

template <int dim>
Real smallest_shape(const Shape<dim>& shape, const Vec<dim>& x)
{
  Real smallest = shape.value(0, x);
  for (int k = 1; k <= dim; ++k) smallest = std::min(smallest, shape.value(k, x));
  return smallest;
}

// The cell whose smallest shape function at x is largest, by a search of all cells.
template <int dim>
Location scan(const Mesh<dim>& mesh, const Vec<dim>& x, Index last)
{
  Index best = none;
  Real largest = -infinity;
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    const Shape<dim> shape = mesh.shape(c);
    const Real smallest = smallest_shape(shape, x);
    if (smallest >= inside_tolerance) return {c, true};
    if (smallest > largest && smallest > tolerance_of_round_off(shape, x)) largest = smallest, best = c;
  }
  return best == none ? Location{last, false} : Location{best, true};
}

}  // namespace

template <int dim>
Location locate(const Mesh<dim>& mesh, const Vec<dim>& x, Index start)
{
  if (!x.allFinite()) return {start, false};
  const bool in_box = (x.array() >= mesh.lower.array()).all() && (x.array() <= mesh.upper.array()).all();
  Index cell = start, previous = none;
  for (Index step = 0; step < mesh.cell_count(); ++step) {
    // The face to cross is the one with the most negative shape function among those that lead to another cell.
    const Shape<dim> shape = mesh.shape(cell);
    Real smallest = inside_tolerance, max_negative = inside_tolerance;
    Index next = none;
    for (int k = 0; k <= dim; ++k) {
      const Real n = shape.value(k, x);
      smallest = std::min(smallest, n);
      if (!(n < max_negative)) continue;
      const Index beyond = mesh.neighbor(cell, k);
      if (beyond != none) max_negative = n, next = beyond;
    }
    if (smallest >= inside_tolerance) return {cell, true};
    // Outside a convex mesh is outside its bounding box, or so near the boundary that round-off decides. Beyond a boundary
    // face but inside the box the mesh may continue behind a hole or a re-entrant boundary, which no walk reaches.
    if (next == none) return in_box ? scan(mesh, x, cell) : Location{cell, false};
    if (next == previous && smallest > tolerance_of_round_off(shape, x)) return {cell, true};
    previous = cell;
    cell = next;
  }
  return in_box ? scan(mesh, x, cell) : Location{cell, false};
}

template Location locate<2>(const Mesh<2>&, const Vec<2>&, Index);
template Location locate<3>(const Mesh<3>&, const Vec<3>&, Index);

}  // namespace berm::mesh
