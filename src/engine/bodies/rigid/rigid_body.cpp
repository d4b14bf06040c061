// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/bodies/rigid/shape_test.cpp
#include "bodies/rigid/rigid_body.hpp"

namespace berm::bodies {

template <int dim>
Vec<dim> center_now(const RigidBody<dim>& rigid, const Pose<dim>& pose)
{
  return center_of<dim>(rigid.shape) + pose.displacement;
}

template <int dim>
RigidShape<dim> placed(const RigidBody<dim>& rigid, const Pose<dim>& pose)
{
  Movement<dim> movement{pose.displacement, pose.orientation.matrix(), 0};
  if constexpr (dim == 2) movement.angle = pose.orientation.angle;
  return std::visit([&](const auto& shape) { return RigidShape<dim>(moved<dim>(shape, movement)); }, rigid.shape);
}

Vec<3> times_inertia(const RigidBody<3>& rigid, const Pose<3>& pose, const Vec<3>& angular_velocity)
{
  const Matrix<3> axes = pose.orientation.matrix() * rigid.axes;
  Vec<3> local = axes.transpose() * angular_velocity;
  for (int d = 0; d < 3; ++d) local[d] = std::isfinite(rigid.inertia[d]) ? rigid.inertia[d] * local[d] : 0;
  return axes * local;
}

Matrix<3> inverse_inertia(const RigidBody<3>& rigid, const Orientation<3>& orientation)
{
  const Matrix<3> axes = orientation.matrix() * rigid.axes;
  return axes * rigid.inertia.cwiseInverse().asDiagonal() * axes.transpose();
}

template <int dim>
Real kinetic_energy(const RigidBody<dim>& rigid, const RigidState<dim>& state)
{
  return 0.5 *
         (rigid.mass * state.velocity.squaredNorm() + dot(times_inertia(rigid, state, state.angular_velocity), state.angular_velocity));
}

#define BERM_INSTANTIATE(dim)                                                                                                              \
  template Vec<dim> center_now<dim>(const RigidBody<dim>&, const Pose<dim>&);                                                              \
  template RigidShape<dim> placed<dim>(const RigidBody<dim>&, const Pose<dim>&);                                                           \
  template Real kinetic_energy<dim>(const RigidBody<dim>&, const RigidState<dim>&);
BERM_INSTANTIATE(2)
BERM_INSTANTIATE(3)
#undef BERM_INSTANTIATE

}  // namespace berm::bodies
