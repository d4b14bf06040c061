// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "boundary/motion.hpp"
#include "mesh/mesh.hpp"

namespace berm::boundary {

/// Fixes the nodes of one boundary of the mesh in some directions, in all stages or in some.
struct SupportSettings {
  std::string boundary;
  std::vector<std::string> fixed;        ///< "x", "y", "z"
  std::vector<std::string> stages = {};  ///< in which it acts; empty: all
  bool drained = false;                  ///< water crosses it
  bool absorbs = false;                  ///< it holds in geostatic stages, and takes up waves in others
  std::optional<MotionSettings> motion = {};
  std::optional<Real> head =
      {};         ///< m of water above the still sea, of the water outside of a drained one; empty: none, at no excess pressure
  Real ramp = 0;  ///< s, over which the head comes and goes
};

void describe(Describe& d, SupportSettings& support);

/// The boundary of the mesh that the support `name` fixes. Throws InputError where the mesh has none of that name.
template <int dim>
Index fixed_boundary(const mesh::Mesh<dim>& mesh, const std::string& name, const SupportSettings& support);

/// Bit d is set where direction d is fixed.
std::uint8_t fixed_directions(const SupportSettings& support);

/// The support that holds a node in each direction, or none.
template <int dim>
using Holders = std::array<Index, dim>;

/// A support holds the node in these directions, but for those that one before it holds.
template <int dim>
void add_holder(Holders<dim>& of_node, Index support, std::uint8_t directions)
{
  for (int d = 0; d < dim; ++d)
    if ((directions >> d & 1) != 0 && of_node[d] == none) of_node[d] = support;
}

/// A nodal vector without its components in the directions that are fixed there.
template <int dim>
Vec<dim> without_fixed(const NodeField<std::uint8_t>& fixed, Index node, Vec<dim> v)
{
  for (int d = 0; d < dim; ++d)
    if (fixed[node] >> d & 1) v[d] = 0;
  return v;
}

}  // namespace berm::boundary
