// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mpm/grid.hpp"

namespace berm::mpm {

/// What the particles at a rigid surface remember, for the points of this step: whether they are bonded, and their adhesion. A bond whose gap is
/// more than half a particle's width ends for good, unless tension is unlimited.
template <int dim>
void recall(const problem::Model<dim>& model, problem::State<dim>& state, const problem::Contact& contact,
            contact::ContactPoints<dim>& points);

/// Ends a step: points that pressed are bonded from now on, unless they have parted before; and the slip of particles that touch
/// and do not stick grows by their distance along the surface.
template <int dim>
void remember(const problem::Model<dim>& model, problem::State<dim>& state, const Workspace<dim>& workspace);

/// The most tension that a point carries in a step, N s.
template <int dim>
Real most_tension(const problem::Contact& contact, const contact::ContactPoint<dim>& point, Real dt)
{
  if (!point.bonded) return 0;
  return contact.tension < infinity ? contact.tension * point.area * dt : infinity;
}

/// The surface of a contact at the end of a step.
struct SurfaceInContact {
  Real area = 0;        ///< m2 (per metre run: m), of closed points
  Real in_tension = 0;  ///< the part of it that is pulled at
  Real adhesion = 0;    ///< Pa, mean over it
};
template <int dim>
SurfaceInContact surface_in_contact(const problem::Contact& contact, const contact::ContactPoints<dim>& points);

}  // namespace berm::mpm
