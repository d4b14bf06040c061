// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

#include <algorithm>

namespace berm::contact {

/// The interface at a contact point in one step.
struct Interface {
  Real friction;             ///< coefficient mu
  Real adhesion_impulse;     ///< N s: adhesion (Pa) times area times dt
  Real allowed_approach;     ///< m/s: max(0, gap) / T
  bool tied = false;         ///< one velocity field: neither slip nor separation
  Real tension_impulse = 0;  ///< N s: the most tension that a bonded point carries (Pa) times area times dt; 0 where it has none
  Real water_fraction = 0;   ///< excess pore pressure over total normal stress, 0 to 1: what the water carries of an impulse that presses
  Real suction_impulse =
      0;  ///< N s: the suction in the pores (Pa) times area times dt, which presses soil and surface together; at least 0

  /// The most that a point transmits along the surface, N s: friction acts on the effective normal stress.
  Real limit(Real normal_impulse) const
  {
    const Real effective = normal_impulse - water_fraction * std::max(Real(0), normal_impulse) + suction_impulse;
    return friction * std::max(Real(0), effective) + adhesion_impulse;
  }
};

/// Effective mass of a contact point, kg: impulse over the velocity change that it makes.
struct EffectiveMass {
  Real normal = 0, along = 0;  ///< along the normal, and along the surface
};

/// The impulse of a contact point of effective mass m (1/m = sum of N^2 / M over what it moves) that carries `before`
/// already, with the relative velocity `relative` under that:
///
///   j_n = max(0, before_n + m_n (-relative . n - allowed_approach)),   j_t = before_t - m_t relative_t, cut to |j_t| <= mu max(0, (1 - water_fraction) j_n + suction_impulse) + adhesion_impulse.
///
/// A bonded point (tension_impulse J > 0) resists separation, too: where j_n above is 0, j_n = max(-J, min(0, before_n - m_n relative . n)),
/// with the same limit of j_t.
///
/// n is the unit normal towards the body that gets the impulse; N s (per metre run). Zero where j_n is zero. With `before` =
/// 0 and no bond this is one correction of the paper (equations 8-13); with the impulses of the last sweep it is one step of a projected
/// Gauss-Seidel iteration. Tied points lose all relative velocity.
template <int dim>
Vec<dim> contact_impulse(const Vec<dim>& relative, const Vec<dim>& n, const EffectiveMass& m, const Interface& interface,
                         const Vec<dim>& before)
{
  const Real speed = relative.dot(n), before_n = before.dot(n);
  if (interface.tied) return before - m.normal * speed * n - m.along * (relative - speed * n);
  Real normal_impulse = before_n - m.normal * (speed + interface.allowed_approach);
  if (!(normal_impulse > 0)) {
    if (!(interface.tension_impulse > 0)) return Vec<dim>::Zero();
    normal_impulse = std::max(-interface.tension_impulse, std::min(Real(0), before_n - m.normal * speed));
  }
  const Vec<dim> sticking = before - before_n * n - m.along * (relative - speed * n);
  const Real needed = sticking.norm(), limit = interface.limit(normal_impulse);
  return normal_impulse * n + (needed <= limit ? Real(1) : limit / needed) * sticking;
}

/// Status of a contact point under its impulse.
enum class ContactStatus : std::uint8_t { open, slipping, sticking };

/// Points at the limit of friction slip; 1e-9 of it is round-off. Bonded points are never open.
template <int dim>
ContactStatus status_of(const Vec<dim>& impulse, const Vec<dim>& n, const Interface& interface)
{
  const Real normal_impulse = impulse.dot(n);
  if (!(normal_impulse > 0 || interface.tension_impulse > 0)) return ContactStatus::open;
  return (impulse - normal_impulse * n).norm() < (1 - 1e-9) * interface.limit(normal_impulse) ? ContactStatus::sticking
                                                                                              : ContactStatus::slipping;
}

/// The impulse of a bilateral constraint at a closed contact point that carries `before` already: the gap closes exactly at
/// the allowed speed, and sticking points do not move along the surface. Not limited by friction, because it is no force
/// (step 8).
template <int dim>
Vec<dim> bilateral_impulse(const Vec<dim>& relative, const Vec<dim>& n, const EffectiveMass& m, const Interface& interface,
                           ContactStatus status, const Vec<dim>& before)
{
  const Real speed = relative.dot(n);
  const Vec<dim> normal = m.normal * (speed + interface.allowed_approach) * n;
  return before - (status == ContactStatus::sticking ? Vec<dim>(normal + m.along * (relative - speed * n)) : normal);
}

}  // namespace berm::contact
