// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/rigid/rigid_body.hpp"
#include "fem/element.hpp"
#include "settings/case.hpp"

namespace berm::fem {

/// A side of an element at the boundary of the mesh, with the soil on the left from its first to its last node.
struct BoundarySide {
  Index from, to, middle;
  Index boundary = none;  ///< the first of the mesh's on which both ends lie; none: a hole
};

/// Quadratic elements that fill the bodies: 6-node triangles; in space 10-node tetrahedra. Nodes are numbered by first use, cells as in the mesh they are
/// made from.
template <int dim>
struct QuadraticElements {
  NodeField<Vec<dim>> position;                 ///< m
  CellField<AtElementNodes<dim, Index>> nodes;  ///< corners, in the plane counter-clockwise, then the mid-side nodes of element_edges
  CellField<Index> body;                        ///< of each cell, an index into Case::body
  CellField<Index> region;                      ///< of each cell, an index into Mesh::region_names
  std::vector<NodeField<std::uint8_t>> fixed;   ///< by set of supports, as boundary::NodeTable::held; bit d: fixed in direction d

  Index node_count() const { return position.size(); }
  Index cell_count() const { return nodes.size(); }
  AtElementNodes<dim, Vec<dim>> positions_of(Index cell) const
  {
    AtElementNodes<dim, Vec<dim>> x;
    for (int k = 0; k < element_nodes<dim>; ++k) x[k] = position[nodes[cell][k]];
    return x;
  }
};

/// In the plane, with what holds its water and its boundary.
struct QuadraticMesh : QuadraticElements<2> {
  std::vector<NodeField<std::uint8_t>> impermeable;      ///< likewise: held by a support that is not drained
  std::vector<NodeField<boundary::Holders<2>>> holders;  ///< as boundary::NodeTable::reactions; empty where no reactions are reported
  std::vector<BoundarySide> boundary_sides;
  std::vector<std::vector<BoundarySide>> loaded_sides;  ///< by traction: those at its boundary

  std::vector<std::vector<Index>> head_nodes;  ///< by boundary::Head of the model: the corners at its boundary
};

/// The body of each region of the mesh, or none. Throws KeyError where a body is a block or a disk, where a region is unknown, or where two bodies fill one.
template <int dim>
std::vector<Index> bodies_of_elements(const mesh::Mesh<dim>& mesh, const settings::Case& c);

/// Throws KeyError where an element is folded.
template <int dim>
void refuse_folds(const QuadraticElements<dim>& mesh);

/// Makes 6-node triangles of the cells in the regions of the bodies; other cells are left out, with the nodes that only they
/// have. Nodes are fixed as the supports say; a mid-side node where its side is at the boundary and both ends are nodes of
/// the support's boundary. A mid-side node at the boundary whose ends lie on the surface of a shape is moved onto it: the
/// sides along a circle are curved. Throws InputError where a body is a block or a disk, where a region or boundary is
/// unknown, where two bodies fill one region, or where an element is folded because its side is too long for the circle it
/// lies on.
QuadraticMesh make_quadratic(const mesh::Mesh<2>& mesh, const settings::Case& c, const std::vector<bodies::RigidShape<2>>& shapes);

/// Whether a side is neither at a wall nor at the base of a seabed: the surface of the soil, or a hole.
bool is_ground(const mesh::Mesh<2>& mesh, const BoundarySide& side);

/// The sides at the boundary of which all three nodes lie on the surface of a shape, to a millionth of the side.
std::vector<BoundarySide> contact_sides(const QuadraticMesh& mesh, const bodies::RigidShape<2>& shape);

}  // namespace berm::fem
