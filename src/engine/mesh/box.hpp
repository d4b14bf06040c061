// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/describe.hpp"
#include "mesh/mesh.hpp"

namespace berm::mesh {

/// Split of the squares of a structured mesh into triangles: along one diagonal, or along both with a node in the centre.
enum class BoxPattern { diagonal, criss_cross };

/// A structured mesh of a box: one region "box"; boundaries "left" (x smallest), "right", "bottom" (y smallest), "top" and, in 3D, "back"
/// (z smallest), "front".
struct BoxMesh {
  std::vector<Real> lower;  ///< m, dim entries; empty: the origin
  std::vector<Real> size;   ///< m, dim entries
  std::vector<Real> cells;  ///< squares or cubes along each side, dim whole numbers
  BoxPattern pattern = BoxPattern::diagonal;
};

void describe(Describe& d, BoxMesh& box);

/// Splits every square into 2 or 4 triangles (by pattern), or every cube into Kuhn's 6 tetrahedra, one for each order in
/// which a path from its lower to its upper corner can take the axes. Throws InputError where the entries do not match dim
/// or are not whole and positive.
template <int dim>
Mesh<dim> make_box(const BoxMesh& box);

}  // namespace berm::mesh
