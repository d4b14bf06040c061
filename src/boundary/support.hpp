// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/describe.hpp"
#include "mesh/mesh.hpp"

namespace berm::boundary {

/// Holds the nodes of one boundary of the mesh in some directions, in all stages or in some.
struct SupportSettings {
  std::string boundary;
  std::vector<std::string> fixed;        ///< "x", "y", "z"
  std::vector<std::string> stages = {};  ///< in which it holds; empty: all
};

void describe(Describe& d, SupportSettings& support);

/// The boundary of the mesh that the support `name` holds. Throws InputError where the mesh has none of that name.
template <int dim>
Index held_boundary(const mesh::Mesh<dim>& mesh, const std::string& name, const SupportSettings& support);

/// Bit d is set where direction d is held.
std::uint8_t held_directions(const SupportSettings& support);

/// A vector at a node without its components in the directions that are held there.
template <int dim>
Vec<dim> without_held(const NodeField<std::uint8_t>& fixed, Index node, Vec<dim> v)
{
  for (int d = 0; d < dim; ++d)
    if (fixed[node] >> d & 1) v[d] = 0;
  return v;
}

}  // namespace berm::boundary
