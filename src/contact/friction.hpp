// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/numbers.hpp"

namespace berm {

/// How fast two surfaces may still approach each other, and what the interface can carry along it.
struct Interface {
  Real friction;          ///< coefficient mu
  Real adhesion_speed;    ///< m/s: velocity change that the adhesion alone can make in this step
  Real allowed_approach;  ///< m/s: max(0, gap) / T
};

/// The change of velocity that keeps a point with velocity `relative` to a rigid surface from approaching it faster than allowed, and that
/// friction then makes along the surface:
///
///   v_n' = -relative . n - allowed_approach;  where v_n' > 0:  dv = v_n' n - t min(|v_t|, mu v_n' + adhesion_speed),  t = v_t / |v_t|.
///
/// n is the unit normal out of the rigid body; m/s throughout. Zero where v_n' <= 0. Paper, equations 8-13.
template <int dim>
Vec<dim> contact_correction(const Vec<dim>& relative, const Vec<dim>& n, const Interface& interface)
{
  const Real normal_speed = relative.dot(n);
  const Real push = -normal_speed - interface.allowed_approach;
  if (!(push > 0)) return Vec<dim>::Zero();
  const Vec<dim> tangential = relative - normal_speed * n;
  const Real sliding = tangential.norm();
  const Real limit = interface.friction * push + interface.adhesion_speed;
  const Real stopped = sliding <= limit ? 1 : limit / sliding;
  return push * n - stopped * tangential;
}

}  // namespace berm
