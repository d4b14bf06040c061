// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/rigid/rigid_settings.hpp"
#include "bodies/rigid/rotation.hpp"

namespace berm::bodies {

/// A rigid body: shape at the start, mass, and how it may move.
template <int dim>
struct RigidBody {
  std::string name;
  RigidShape<dim> shape;
  Real mass = 0;  ///< kg/m or kg
  Motion motion = Motion::driven;
  Rotation rotation = Rotation::fixed;
  Angular<dim> inertia = no_angular<dim>();    ///< about its centre, kg m; in space about its axes, kg m2; may be infinite
  Matrix<dim> axes = Matrix<dim>::Identity();  ///< columns: the directions of these axes at the start
};

/// Variables of a rigid body.
template <int dim>
struct RigidState {
  Vec<dim> displacement = Vec<dim>::Zero();           ///< since the start, m
  Orientation<dim> orientation;                       ///< since the start, about the centre
  Vec<dim> velocity = Vec<dim>::Zero();               ///< of the centre during the step, m/s
  Angular<dim> angular_velocity = no_angular<dim>();  ///< rad/s, during the step
  Vec<dim> reaction = Vec<dim>::Zero();               ///< force of the soil on it in the last step, N/m or N
  Vec<dim> smooth_reaction = Vec<dim>::Zero();        ///< the same, averaged over about a hundred steps
  Angular<dim> torque = no_angular<dim>();            ///< of the soil on it about its centre in the last step, N m/m or N m
  Vec<dim> impulse = Vec<dim>::Zero();                ///< given by its contacts to the soil since the start (step 4), N s/m or N s
  Angular<dim> torque_impulse = no_angular<dim>();    ///< the same, about the centre at that time, N s or N m s
  Vec<dim> second_impulse = Vec<dim>::Zero();         ///< the same for the correction of step 8, which is no force
  Real impulse_sum = 0;                               ///< sum of the magnitudes of all nodal impulses since the start, N s/m or N s
  Real impulse_times_gap =
      0;  ///< the same, each times the distance of the node's nearest particle from the surface; over impulse_sum: the contact gap
  Real shaft_impulse = 0;  ///< around an axis: the part along it, given to the soil by sides parallel to it, N s
  Real effective_impulse =
      0;  ///< of all points the part of the normal impulse that the soil's skeleton carries, since the start, N s/m or N s; where friction acts in soil with water
  Real max_overlap = 0;  ///< m, maximum depth of a particle in the body since the last row of the history
  Vec<dim> near_cells_displacement =
      Vec<dim>::Constant(infinity);         ///< displacement when the cells near it were last listed (contact/detect.hpp), m
  Orientation<dim> near_cells_orientation;  ///< and its orientation then
};

/// Its present centre (of a half-plane: its point).
template <int dim>
Vec<dim> center_now(const RigidBody<dim>& rigid, const RigidState<dim>& state);

/// Its shape at its present position and rotation.
template <int dim>
RigidShape<dim> placed(const RigidBody<dim>& rigid, const RigidState<dim>& state);

/// Its angular momentum at an angular velocity, N s or N m s. In space: 0 about axes that it cannot rotate about.
inline Real times_inertia(const RigidBody<2>& rigid, const RigidState<2>&, Real angular_velocity)
{
  return rigid.inertia * angular_velocity;
}
Vec<3> times_inertia(const RigidBody<3>& rigid, const RigidState<3>& state, const Vec<3>& angular_velocity);

/// The inverse of its moments of inertia at an orientation, 1/(kg m2); 0 about axes that it cannot rotate about.
Matrix<3> inverse_inertia(const RigidBody<3>& rigid, const Orientation<3>& orientation);

/// Its kinetic energy, J/m or J.
template <int dim>
Real kinetic_energy(const RigidBody<dim>& rigid, const RigidState<dim>& state);

/// Velocity of its point that is now at x: velocity + angular velocity x (x - centre).
template <int dim>
Vec<dim> velocity_at(const RigidBody<dim>& rigid, const RigidState<dim>& state, const Vec<dim>& x)
{
  const Vec<dim> from = x - center_now(rigid, state);
  Vec<dim> v = state.velocity;
  if constexpr (dim == 2) {
    v[0] -= state.angular_velocity * from[1];
    v[1] += state.angular_velocity * from[0];
  } else {
    v += cross(state.angular_velocity, from);
  }
  return v;
}

}  // namespace berm::bodies
