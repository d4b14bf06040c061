// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mesh/mesh.hpp"

namespace berm::mesh {

/// What a surface that cuts a cell leaves of it.
template <int dim>
struct CellPart {
  bool cut = false;                    ///< false: all of it is left, and the rest is not set
  Real section = 0;                    ///< m2; in space m3
  Real volume = 0;                     ///< as Mesh::volume
  Vec<dim> center = Vec<dim>::Zero();  ///< of the section, m; in the plane
};

/// The part of a cell where the field is positive that is linear in it and has these values at its corners; exact where the surface is a plane.
template <int dim>
CellPart<dim> positive_part(const Mesh<dim>& mesh, Index cell, const std::array<Real, dim + 1>& at_corners);

}  // namespace berm::mesh
