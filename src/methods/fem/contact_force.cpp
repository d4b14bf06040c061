// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/fem/contact_points_test.cpp
#include "fem/contact_force.hpp"

namespace berm::fem {
namespace {

Vec<2> across(const Vec<2>& normal)
{
  return {-normal[1], normal[0]};
}

/// The contact at the start as the end of the increment sees it, whose law adds the movement along the normal to the gap.
FemContactState seen_from(const FemContactPoint& start, const FemContactPoint& end, FemContactState state, Real gap, const Vec<2>& movement)
{
  const Real pressure = state.traction.dot(start.normal), shear = state.traction.dot(across(start.normal));
  state.traction = pressure * end.normal + shear * across(end.normal);
  state.gap = gap - movement.dot(end.normal);
  return state;
}

/// Too far apart to touch, by at least this.
ContactForce apart(Real gap, FemContactState state, const Vec<2>& arm)
{
  state.gap = gap;
  state.traction.setZero();
  return {state, arm, Eigen::Matrix<Real, 5, 1>::Zero(), Eigen::Matrix<Real, 5, 5>::Zero()};
}

}  // namespace

ContactForce contact_force(const FemModel& model, std::size_t point, const FemState& begin, const Eigen::Matrix<Real, 5, 1>& moved)
{
  FemContactPoint at = model.contact[point];
  FemContactState before = begin.contact[point];
  Eigen::Matrix<Real, 2, 5> p = relative_movement(at);
  if (model.settings.large_deformation) {
    const bool bonded = model.interfaces[at.contact].tension > 0 && before.parted == 0;
    if (const Real gap = before.gap - (p * moved).norm(); gap > 0 && !bonded) return apart(gap, before, at.arm);
    const bodies::RigidBody<2>& rigid = model.rigid_of(at.contact);
    const Index first = model.rigid_unknown(at.contact);
    const Vec<3> body(begin.displacement[first], begin.displacement[first + 1], begin.displacement[first + 2]);
    const bodies::Pose<2> pose = pose_of(body + Vec<3>(moved.tail<3>()));
    const Vec<2> x = position_now(model, begin, at.node) + Vec<2>(moved.head<2>());
    const bodies::SurfacePoint<2> surface = surface_now(model, at.contact, pose, x);
    at.normal = surface.normal;
    at.arm = x - center_now(rigid, pose);
    p = relative_movement(at);
    before = seen_from(model.contact[point], at, before, surface.distance, p * moved);
  }
  const FemTraction now = update_traction(interface_at(model, point, begin), at.normal, before, p * moved);
  return {now.state, at.arm, at.area * p.transpose() * now.state.traction, at.area * p.transpose() * now.stiffness * p};
}

}  // namespace berm::fem
