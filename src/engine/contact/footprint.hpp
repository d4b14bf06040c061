// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/particles.hpp"
#include "bodies/rigid/rigid_body.hpp"
#include "contact/contact_point.hpp"

namespace berm::contact {

/// Computes the length of rigid surface that each particle at it covers, m, in the plane (found.footprints); in axisymmetry length times radius, m2 per radian.
///
/// A particle within its width w of a side covers w along it, clipped at the side's ends. Where two neighbours overlap, or
/// leave less than a width open, the border between them divides their distance in the ratio of their widths, so that
/// nothing is covered twice and no gap is left between neighbours.
/// `angle`: of the rigid body.
void find_footprints(const mesh::Mesh<2>& mesh, const bodies::Particles<2>& particles, const bodies::RigidShape<2>& shape, Real angle,
                     ContactPoints<2>& found);

/// The face of a rigid body that was turned by this angle: which of four directions of its own, right, left, up or down, the normal of its surface is nearest to. The soil below a
/// toe takes no adhesion from the shaft then.
int face_of(const Vec<2>& normal, Real angle);

/// Distributes the covered surface over the closed contact points, so that their areas add up to it:
///
///   A_q = sum_k A_k N_k(x_q) / sum_q' N_k(x_q'),   A_k = sum_p L_p N_k(x_p) / sum_k' N_k'(x_p),
///
/// with L_p the footprints, q' the closed points and k' those of p's nodes that one of them moves. Points that press or
/// are bonded are closed; while there is none, all count as closed. A footprint without such a node is out of contact. Where each face has its own points
/// (ContactPoints::faces), p, q and q' are those of one face. m2 (per metre run: m)
template <int dim>
void share_surface(ContactPoints<dim>& points);

/// What the water carries of the force along the normal at each point, whose particles have the excess pore pressure p and the total normal stress s on the surface:
///
///   sum_k N_k(x_q) min(1, P_k / S_k),   P_k = max(0, sum_q N_k(x_q) p_q),   S_k = sum_q N_k(x_q) s_q over touching points;   1 where S_k <= P_k > 0.
///
/// Stresses, not impulses: these come and go from point to point and from step to step.
template <int dim>
void find_water_fractions(ContactPoints<dim>& points, const mesh::Mesh<dim>& mesh);

}  // namespace berm::contact
