// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/rigid/dynamics.hpp"
#include "bodies/rigid/proximity.hpp"
#include "settings/rigid_contact_checks.hpp"

#include <array>

namespace berm::problem {

template <int dim>
struct Model;
template <int dim>
struct State;

/// Two rigid bodies, with their names looked up.
template <int dim>
struct RigidPair {
  Index first, second;
  bodies::Proximity<dim> proximity;
};

/// A contact of two rigid bodies.
template <int dim>
struct RigidContact : RigidPair<dim> {
  std::string name;
  Real friction;     ///< tan of the friction angle
  Real restitution;  ///< normal speed after an impact over that before it
};

/// Adds the contacts of rigid bodies to a model that has its bodies, and the pairs that pass through each other. Throws KeyError where berm cannot tell how two
/// bodies meet, and where bodies that may move overlap at the start.
template <int dim>
void add_rigid_contacts(const settings::Case& c, Model<dim>& model);

/// The velocities of the bodies of each contact at a moment: of the first, of the second.
template <int dim>
struct RigidVelocities {
  std::array<std::array<Vec<dim>, 2>, settings::max_rigid_contacts> velocity;
  std::array<std::array<bodies::Angular<dim>, 2>, settings::max_rigid_contacts> angular;
};
template <int dim>
RigidVelocities<dim> velocities_at_contacts(const Model<dim>& model, const State<dim>& state);

/// Gives rigid bodies that would meet within the coming step the impulses that keep them apart. At each point, with u the velocity of the first body there less that
/// of the second and n out of the second:
///
///   n.u >= -gap/dt,  and after an impact  n.u = -restitution times its value before;   |tangential impulse| <= friction times the normal one, and against what is
///   left of the slip (Moreau 1988; Newton's law of impact).
///
/// The impulses act on both bodies, opposite and at one point, so that momentum and angular momentum are kept to round-off. What velocities prescribe does not give
/// way. Work: what is lost is friction; what a body gains that is not free, or in a freedom that a velocity prescribes, is external work. `last`: the velocities of the step before. Throws RunError where neither
/// body gives way.
template <int dim>
void push_apart(const Model<dim>& model, State<dim>& state, const RigidVelocities<dim>& last, Real dt);

/// Throws RunError where two bodies without a contact overlap, of which one at least may move.
template <int dim>
void refuse_overlap(const Model<dim>& model, const State<dim>& state);

}  // namespace berm::problem
