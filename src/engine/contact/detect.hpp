// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/particles.hpp"
#include "bodies/rigid/rigid_body.hpp"
#include "contact/contact_point.hpp"
#include "contact/contact_settings.hpp"

namespace berm::contact {

/// Half the width of a particle, m: of a square (cube) of its section (mesh::section_of).
template <int dim>
Real half_width(Real section)
{
  return 0.5 * (dim == 2 ? std::sqrt(section) : std::cbrt(section));
}

/// Distance of the rim of a particle from its centre over half its width, where rims wear. The strain is the deviatoric one summed over all steps, 0 as it was placed. What is left in the end keeps
/// particles out of the body, and in a mesh that ends at its surface.
inline Real rim_fraction(Real strain)
{
  constexpr Real wearing_strain = 0.1, left = 0.05;
  return left + (1 - left) * std::exp(-strain / wearing_strain);
}

/// Detects contact of a body with a rigid one.
///
/// Detection::gap: the nodes of cells with particles near the surface, each with the smallest gap of the particles in its
/// cells. Detection::distance: those of them whose gap is closed. Detection::overlap: each node of a cell that the rigid
/// body intersects, with gap 0. Detection::particle: the particles whose rims, as whole ones, are nearer than their width, each with the gap of its rim. Nodes without mass
/// are left out. Where cells are divided among ranks, each of them finds all points; it gets the masses of nodes near the surface for that. `listed` is the pose of the rigid body when the cells near it were last listed.
template <int dim>
void detect(const mesh::Mesh<dim>& mesh, const bodies::Particles<dim>& particles, const bodies::RigidBody<dim>& rigid,
            const bodies::Pose<dim>& pose, bodies::Pose<dim>& listed, Detection detection, ParticleRim rim, NodeField<Real>& mass,
            ContactPoints<dim>& found);

/// One of two deformable bodies: its particles and its nodal masses.
template <int dim>
struct BodyView {
  const bodies::Particles<dim>& particles;
  const NodeField<Real>& mass;
  const std::vector<Index>& nodes;  ///< that may have mass, ascending
};

/// Detects contact between two deformable bodies at the nodes where both have mass. The two share one normal, out of
/// `other`: the direction along which their particles in the node's cells are farthest apart; the gap is that between the
/// rims of these particles along it. Detection::overlap sets the gap to 0, Detection::distance leaves out nodes whose gap is
/// open.
template <int dim>
void detect(const mesh::Mesh<dim>& mesh, const BodyView<dim>& body, const BodyView<dim>& other, Detection detection,
            ContactPoints<dim>& found);

}  // namespace berm::contact
