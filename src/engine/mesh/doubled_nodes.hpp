// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mesh/mesh.hpp"

#include <optional>

namespace berm::mesh {

/// Nodes of cells that lie at one place, as CAD leaves them where surfaces share none: parts of the mesh that do not hold together. With a tolerance (m) nodes no
/// farther apart become one, the first of them. Throws InputError, with `file` and one place, where nodes are left that are closer than a thousandth of the
/// shortest edge, and where the tolerance would join nodes of one cell. Before Mesh::complete().
template <int dim>
void join_doubled_nodes(Mesh<dim>& mesh, const std::optional<Real>& tolerance, const std::string& file);

}  // namespace berm::mesh
