// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/particles.hpp"
#include "bodies/rigid/rigid_body.hpp"
#include "contact/contact_point.hpp"

namespace berm::contact {

/// Finds the part of a rigid surface that each particle at it covers, in the plane (found.footprints).
///
/// A particle within its width w of a side covers w along it, as a square would, cut at the side's ends. Where the squares of two neighbours overlap,
/// and where they leave less than a width open, the border between them divides their distance in the ratio of their widths, so that nothing is
/// covered twice and no hole is left between neighbours. m
void find_footprints(const mesh::Mesh<2>& mesh, const bodies::Particles<2>& particles, const bodies::RigidShape<2>& shape,
                     ContactPoints<2>& found);

/// Shares the covered surface among the contact points that press, so that their areas add up to it:
///
///   A_q = sum_k A_k N_k(x_q) / sum_q' N_k(x_q'),   A_k = sum_p L_p N_k(x_p) / sum_k' N_k'(x_p),
///
/// with L_p the footprints, q' the points that press and k' those of p's nodes that one of them moves. All points count as pressing while none
/// carries an impulse. A footprint with no such node is out of contact. m2 (per metre run: m)
template <int dim>
void share_surface(ContactPoints<dim>& points);

}  // namespace berm::contact
