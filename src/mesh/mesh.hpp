// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/fields.hpp"
#include "core/tensor.hpp"

#include <array>
#include <string>
#include <vector>

namespace berm {

/// The linear shape functions of one simplex: N_k(x) = a[k] + sum_d b[d][k] x_d for its corner k. b[d][k] is dN_k/dx_d, 1/m.
template <int dim>
struct Shape {
  std::array<Real, dim + 1> a;
  std::array<std::array<Real, dim + 1>, dim> b;

  Real value(int corner, const Vec<dim>& x) const
  {
    Real n = a[corner];
    for (int d = 0; d < dim; ++d) n += b[d][corner] * x[d];
    return n;
  }
  Vec<dim> gradient(int corner) const
  {
    Vec<dim> g;
    for (int d = 0; d < dim; ++d) g[d] = b[d][corner];
    return g;
  }
};

/// One place where a node is a corner of a cell: entry = (dim + 1) * cell + corner.
using CornerEntry = Index;

/// The background mesh: triangles (dim = 2) or tetrahedra (dim = 3), fixed during a run. Lengths in metres.
/// Cells and nodes are numbered along a space-filling curve, so that neighbours in space are neighbours in memory.
template <int dim>
struct Mesh {
  static constexpr int corners = dim + 1;
  using Corners = std::array<Index, corners>;

  NodeField<Vec<dim>> position;
  CellField<Corners> nodes;     ///< positively oriented
  CellField<Corners> neighbor;  ///< neighbor[c][k] lies across the face opposite corner k; none at the boundary
  CellField<Index> region;      ///< of each cell, an index into region_names
  std::vector<std::string> region_names;
  std::vector<std::string> boundary_names;
  std::vector<std::vector<Index>> boundary_nodes;  ///< by boundary, ascending

  // What follows is derived by complete().
  CellField<Shape<dim>> shape;
  CellField<Real> volume;                                       ///< m2 (per metre run) or m3
  CellField<Real> height;                                       ///< the smallest height of the cell, m
  NodeField<Index> first_entry;                                 ///< entries of node i: first_entry[i] ... first_entry[i + 1] - 1
  std::vector<CornerEntry> entries;                             ///< of all nodes, ascending for each
  Vec<dim> lower = Vec<dim>::Zero(), upper = Vec<dim>::Zero();  ///< the box around all nodes

  Index node_count() const { return position.size(); }
  Index cell_count() const { return nodes.size(); }

  /// Index of a region or boundary by name, or none.
  Index find_region(const std::string& name) const;
  Index find_boundary(const std::string& name) const;

  /// Orients and renumbers the cells, renumbers the nodes, finds neighbours and derives shape functions, heights and entries.
  /// Needs position, nodes, region and boundary_nodes. Throws RunError for a cell without volume or a face with three cells.
  void complete();

  Vec<dim> centroid(Index cell) const;
};

/// Where a walk through the mesh ended.
struct Location {
  Index cell;   ///< the cell that holds x, or the last one before the boundary was crossed
  bool inside;  ///< false: x lies outside the mesh, beyond a face of `cell` at the boundary
};

/// Walks from cell `start` to the cell that holds x: each step crosses the face with the most negative shape function that leads to a cell. A point is
/// held where no shape function is below -1e-12. O(cells crossed); where a hole or a bay of the mesh ends the walk inside the box around the mesh,
/// or the walk does not end, all cells are looked at. A position that is not finite is outside.
template <int dim>
Location locate(const Mesh<dim>& mesh, const Vec<dim>& x, Index start);

}  // namespace berm
