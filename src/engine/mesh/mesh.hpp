// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/fields.hpp"
#include "core/tensor.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace berm::mesh {

/// The gradients of the linear shape functions of one simplex, 1/m: [k - 1][d] is dN_k/dx_d of corner k. That of corner 0 is minus their sum.
template <int dim>
using Gradients = std::array<std::array<Real, dim>, dim>;

/// The linear shape functions of one simplex: N_k(x) = gradients[k - 1] . (x - origin) of the corners k = 1 ... dim, and N_0
/// = 1 - their sum.
template <int dim>
struct Shape {
  Vec<dim> origin;  ///< corner 0, m
  Gradients<dim> gradients;

  Real value(int corner, const Vec<dim>& x) const
  {
    if (corner > 0) return gradient(corner).dot(x - origin);
    Real n = 1;
    for (int k = 1; k <= dim; ++k) n -= value(k, x);
    return n;
  }
  Vec<dim> gradient(int corner) const
  {
    if (corner > 0) return Eigen::Map<const Vec<dim>>(gradients[corner - 1].data());
    Vec<dim> g = Vec<dim>::Zero();
    for (int k = 1; k <= dim; ++k) g -= gradient(k);
    return g;
  }
  /// What rounding the coordinates of x and of the corners can do to the shape functions: their resolution over the smallest height.
  Real rounding_at(const Vec<dim>& x) const
  {
    return 2 * std::numeric_limits<Real>::epsilon() * x.cwiseAbs().maxCoeff() * std::sqrt(steepest_square());
  }
  /// Inverse square of the smallest height of the simplex, 1/m2: its heights are 1 / |grad N_k|.
  Real steepest_square() const
  {
    Real steepest = 0;
    for (int k = 0; k <= dim; ++k) steepest = std::max(steepest, gradient(k).squaredNorm());
    return steepest;
  }
};

/// What an area of the mesh stands for.
enum class Metric {
  cartesian,    ///< one metre across the plane; in space a volume stands for itself
  axisymmetric  ///< one radian about the axis x = 0, with x the radius
};

/// What areas at a point are multiplied with to make volumes: 1, or the radius, m (per radian).
template <int dim>
[[gnu::always_inline]] inline Real weight_at(Metric metric, const Vec<dim>& x)
{
  return metric == Metric::axisymmetric ? x[0] : Real(1);
}

/// The area of what has this volume at a point, m2 (in space its volume, m3).
template <int dim>
[[gnu::always_inline]] inline Real section_of(Metric metric, Real volume, const Vec<dim>& x)
{
  return metric == Metric::axisymmetric ? volume / x[0] : volume;
}

/// A corner of a cell at a node: entry = (dim + 1) * cell + corner.
using CornerEntry = Index;

/// The background mesh: triangles (dim = 2) or tetrahedra (dim = 3), fixed during a run. Lengths in metres.
/// Cells and nodes are numbered along a space-filling curve, so that neighbours in space are neighbours in memory.
template <int dim>
struct Mesh {
  static constexpr int corners = dim + 1;
  using Corners = std::array<Index, corners>;

  NodeField<Vec<dim>> position;
  CellField<Corners> nodes;  ///< positively oriented
  CellField<Index> region;   ///< of each cell, an index into region_names
  std::vector<std::string> region_names;
  std::vector<std::string> boundary_names;
  std::vector<std::vector<Index>> boundary_nodes;  ///< by boundary, ascending
  CellField<Index> patch;  ///< number of the patch of each cell, for those who make them (mesh/patches.hpp); empty: found there
  Metric metric = Metric::cartesian;
  std::vector<std::string> remarks;  ///< what was changed of the file that it was read from, for who runs it

  // What follows is derived by complete().
  NodeField<Index> first_entry;                                 ///< entries of node i: first_entry[i] ... first_entry[i + 1] - 1
  std::vector<CornerEntry> entries;                             ///< of all nodes, ascending for each
  std::vector<Index> cell_chunks;                               ///< where each chunk of cells begins (core/chunks.hpp); then the end
  std::vector<Index> node_chunks;                               ///< the same of nodes: a node is in the chunk of its first cell
  Vec<dim> lower = Vec<dim>::Zero(), upper = Vec<dim>::Zero();  ///< bounding box of the nodes

  Index node_count() const { return position.size(); }
  Index cell_count() const { return nodes.size(); }

  /// Index of a region or boundary by name, or none.
  Index find_region(const std::string& name) const;
  Index find_boundary(const std::string& name) const;

  /// Orients and renumbers the cells, renumbers the nodes and lists their entries.
  /// Needs position, nodes, region and boundary_nodes. Throws RunError for a cell without volume or a face with three cells.
  void complete();

  // Geometry of single cells is computed from their nodes: stored for all cells, it would be half of a large mesh.
  Vec<dim> centroid(Index cell) const;
  Shape<dim> shape(Index cell) const;
  Real section(Index cell) const;  ///< m2, its area; in space its volume, m3
  Real size(Index cell) const;     ///< m, side of the square that two such cells make; in space of the cube of six
  Real volume(Index cell) const;   ///< m2 (per metre run) or m3; in axisymmetry m3 per radian, section times radius of the centroid
  Real height(Index cell) const;   ///< the smallest one, m
  /// The cell across the face opposite that corner, or none at the boundary.
  Index neighbor(Index cell, int corner) const;
};

/// Result of the search for a point.
struct Location {
  Index cell;   ///< the cell that contains x, or the last one before the boundary was crossed
  bool inside;  ///< false: x lies outside the mesh, beyond a face of `cell` at the boundary
};

/// Walks from cell `start` to the cell that contains x: each step crosses the face with the most negative shape function
/// that leads to a cell. A cell contains x where no shape function is below -1e-12. O(cells crossed); where the walk stops
/// at a hole or a re-entrant boundary inside the mesh's bounding box, or does not end, all cells are searched. A position
/// that is not finite is outside.
template <int dim>
Location locate(const Mesh<dim>& mesh, const Vec<dim>& x, Index start);

}  // namespace berm::mesh
