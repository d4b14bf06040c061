// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

namespace berm::contact {

/// What a contact point can carry in one step.
struct Interface {
  Real friction;          ///< coefficient mu
  Real adhesion_impulse;  ///< N s: adhesion (Pa) times area times dt
  Real allowed_approach;  ///< m/s: max(0, gap) / T
  bool welded = false;    ///< one velocity field: whatever touches moves as one
};

/// What a contact point sets in motion, kg: impulse over the change of velocity that it makes.
struct EffectiveMass {
  Real normal = 0, along = 0;  ///< along the normal, and along the surface
};

/// The impulse that a contact point of effective mass m (1/m = sum of N^2 / m over what it moves) has to carry, when it carries `before` already
/// and its relative velocity with that is `relative`:
///
///   j_n = max(0, before_n + m_n (-relative . n - allowed_approach)),   j_t = before_t - m_t relative_t, cut to |j_t| <= mu j_n + adhesion_impulse.
///
/// n is the unit normal towards the body that gets the impulse; N s (per metre run). Zero where j_n is zero. With `before` = 0 this is one correction
/// of the paper (equations 8-13); with the impulses of the last sweep it is one step of a projected Gauss-Seidel iteration. Welded points take all
/// of the relative velocity away, in any direction.
template <int dim>
Vec<dim> contact_impulse(const Vec<dim>& relative, const Vec<dim>& n, const EffectiveMass& m, const Interface& interface,
                         const Vec<dim>& before)
{
  const Real speed = relative.dot(n), before_n = before.dot(n);
  if (interface.welded) return before - m.normal * speed * n - m.along * (relative - speed * n);
  const Real normal_impulse = before_n - m.normal * (speed + interface.allowed_approach);
  if (!(normal_impulse > 0)) return Vec<dim>::Zero();
  const Vec<dim> sticking = before - before_n * n - m.along * (relative - speed * n);
  const Real needed = sticking.norm(), limit = interface.friction * normal_impulse + interface.adhesion_impulse;
  return normal_impulse * n + (needed <= limit ? Real(1) : limit / needed) * sticking;
}

/// What a contact point does under the impulse that it carries.
enum class Grip : std::uint8_t { open, slides, sticks };

/// Points at the limit of friction slide; 1e-9 of it is round-off.
template <int dim>
Grip grip_of(const Vec<dim>& impulse, const Vec<dim>& n, const Interface& interface)
{
  const Real normal_impulse = impulse.dot(n);
  if (!(normal_impulse > 0)) return Grip::open;
  const Real limit = interface.friction * normal_impulse + interface.adhesion_impulse;
  return (impulse - normal_impulse * n).norm() < (1 - 1e-9) * limit ? Grip::sticks : Grip::slides;
}

/// The impulse that keeps together what is pressed together, when the point carries `before` already: the gap closes at the speed that it allows,
/// neither faster nor slower, and points that stick do not move along the surface. No limits: this is no force (step 8).
template <int dim>
Vec<dim> holding_impulse(const Vec<dim>& relative, const Vec<dim>& n, const EffectiveMass& m, const Interface& interface, Grip grip,
                         const Vec<dim>& before)
{
  const Real speed = relative.dot(n);
  const Vec<dim> normal = m.normal * (speed + interface.allowed_approach) * n;
  return before - (grip == Grip::sticks ? Vec<dim>(normal + m.along * (relative - speed * n)) : normal);
}

}  // namespace berm::contact
