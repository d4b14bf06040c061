// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/rigid/rotation.hpp"

namespace berm::contact {

/// Whether a side whose normal has this component along an axis counts as parallel to the axis, as a shaft: within 6 degrees.
inline bool is_shaft(Real normal_along_axis)
{
  return std::abs(normal_along_axis) < 0.1;
}

/// What the contacts of a rigid body have added up to since the start: the difference of two moments is what they did between them.
template <int dim>
struct ContactSums {
  Vec<dim> impulse = Vec<dim>::Zero();                              ///< given to the soil (step 4), N s/m or N s
  bodies::Angular<dim> torque_impulse = bodies::no_angular<dim>();  ///< the same, about the centre at that time, N s or N m s
  Vec<dim> second_impulse = Vec<dim>::Zero();                       ///< the same for the correction of step 8, which is no force
  Real impulse_sum = 0;                                             ///< sum of the magnitudes of all nodal impulses, N s/m or N s
  /// The same, each times the distance of the node's nearest particle from the surface; over impulse_sum: the contact gap.
  Real impulse_times_gap = 0;
  Real shaft_impulse = 0;  ///< around an axis: the part along it, given to the soil by sides parallel to it, N s
  /// Of all points the part of the normal impulse that the soil's skeleton carries, N s/m or N s; where friction acts in soil with water.
  Real effective_impulse = 0;
};

}  // namespace berm::contact
