// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "boundary/traction.hpp"
#include "fem/quadratic_mesh.hpp"

namespace berm::fem {

/// Consistent force of a traction at a node.
struct NodalLoad {
  Index node;
  Vec<2> force;  ///< N/m, integral of N_i times the traction over the sides
  Real area;     ///< m, integral of N_i over the loaded part of the sides
};

/// Consistent nodal forces of the traction `name` on sides with three nodes, which may be curved; three Gauss points a side
/// are exact on straight ones, around an axis where they count with the radius, too. Throws InputError where nothing is loaded.
std::vector<NodalLoad> side_loads(const QuadraticMesh& mesh, const std::vector<BoundarySide>& sides, const std::string& name,
                                  const boundary::TractionSettings& traction, mesh::Metric metric = mesh::Metric::cartesian);

}  // namespace berm::fem
