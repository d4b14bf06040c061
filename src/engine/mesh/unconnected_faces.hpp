// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mesh/mesh.hpp"

namespace berm::mesh {

/// Refuses parts of a mesh that lie at each other and share no faces there, as where CAD leaves surfaces whose common line has other nodes in each: they would not
/// hold together. Throws InputError with `file` and a place where another cell lies behind a face of one cell alone, by a hundredth of the cell's height. After
/// Mesh::complete().
template <int dim>
void refuse_unconnected_faces(const Mesh<dim>& mesh, const std::string& file);

}  // namespace berm::mesh
