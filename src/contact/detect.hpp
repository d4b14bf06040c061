// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/particles.hpp"
#include "bodies/rigid.hpp"
#include "contact/contact_settings.hpp"

namespace berm {

/// One node of a deformable body that may touch a rigid body in this step.
template <int dim>
struct ContactNode {
  Index node;
  Vec<dim> normal;  ///< unit vector out of the rigid body, at the node
  Real gap;         ///< m between the rigid surface and the rim of the nearest particle; at most 0 where they touch
  Real distance;    ///< m between the rigid surface and the nearest particle's centre
  bool touching;    ///< the gap is less than half a particle's width
};

/// The nodes of one contact, found anew in each step, and what finding them needs. Memory is kept from step to step.
template <int dim>
struct ContactNodes {
  std::vector<ContactNode<dim>> list;  ///< in the order of the cells that found them
  Real nearest_particle = infinity;    ///< m, distance of the nearest particle from the surface, negative inside

  std::vector<Index> near_cells;                    ///< cells that the surface can reach until it has moved `reach`
  Vec<dim> near_at = Vec<dim>::Constant(infinity);  ///< displacement of the rigid body when near_cells was made
  Real reach = 0;
  struct CellContact {
    Real gap = infinity, distance = infinity, half_width = 0;
    Vec<dim> normal = Vec<dim>::Zero();  ///< at the particle with the least gap
    bool cut = false;                    ///< the rigid body reaches into the cell
  };
  std::vector<CellContact> cells;  ///< of near_cells
  NodeField<Index> place;          ///< of a node in list, or none
};

/// Finds the nodes that may be in contact. With Detection::gap: the nodes of cells with particles near the surface, and for each the least gap of
/// the particles in its cells; a particle is as wide as a square (cube) of its volume. With Detection::overlap: each node of a cell that the rigid
/// body reaches into, with gap 0. Nodes without mass are left out.
template <int dim>
void detect(const Mesh<dim>& mesh, const Particles<dim>& particles, const Rigid<dim>& rigid, const RigidState<dim>& state,
            Detection detection, const NodeField<Real>& mass, ContactNodes<dim>& found);

}  // namespace berm
