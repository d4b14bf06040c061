// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/bodies/rigid/proximity_test.cpp
#include "bodies/rigid/proximity.hpp"

#include <algorithm>

namespace berm::bodies {
namespace {

template <int dim>
bool is_sphere(const RigidShapeSettings& shape)
{
  return std::holds_alternative<SphereSettings>(shape) || (dim == 2 && std::holds_alternative<CircleSettings>(shape));
}

/// In space only circles and spheres have some.
template <int dim>
ContactCandidates<dim> candidates_of(const RigidShapeSettings& settings)
{
  const RigidShape<dim> shape = make_shape<dim>(settings);
  if (const auto* circle = std::get_if<Circle<dim>>(&shape)) return {{circle->center}, circle->radius};
  if (const auto* sphere = std::get_if<Sphere<dim>>(&shape)) return {{sphere->center}, sphere->radius};
  if constexpr (dim == 2) {
    if (const auto* profile = std::get_if<Profile<2>>(&shape)) return {*profile->core.corners, profile->radius};
    const Outline outline = std::visit([](const auto& s) { return Outline(outline_of(s)); }, settings);
    if (const auto* corners = std::get_if<CornersOutline>(&outline)) return {corners->corners, 0};
  }
  return {};
}

/// The nearest point of a body's surface, in the body's own place and orientation at the start, where it lies at the pose.
template <int dim>
SurfacePoint<dim> surface_at_pose(const RigidBody<dim>& body, const Pose<dim>& pose, const Matrix<dim>& turned, const Vec<dim>& x)
{
  const Vec<dim> center = center_of<dim>(body.shape);
  SurfacePoint<dim> point = surface_at<dim>(body.shape, Vec<dim>(center + turned.transpose() * (x - center - pose.displacement)));
  point.normal = turned * point.normal;
  return point;
}

/// Keeps the nearest points.
template <int dim>
void insert(ProximityPoints<dim>& found, const ProximityPoint<dim>& point)
{
  int at = std::min(found.count, max_proximity_points - 1);
  if (found.count == max_proximity_points && !(point.gap < found.points[at].gap)) return;
  if (found.count < max_proximity_points) ++found.count;
  for (; at > 0 && point.gap < found.points[at - 1].gap; --at) found.points[at] = found.points[at - 1];
  found.points[at] = point;
}

/// Adds where the contact_candidates of a body meet the surface of another; `second` is whether this is the second of the two.
template <int dim>
void add_points(const ContactCandidates<dim>& contact_candidates, const RigidBody<dim>& body, const Pose<dim>& pose,
                const RigidBody<dim>& surface, const Pose<dim>& surface_pose, bool second, Real reach, ProximityPoints<dim>& found)
{
  const Matrix<dim> turned = pose.orientation.matrix(), surface_turned = surface_pose.orientation.matrix();
  const Vec<dim> center = center_of<dim>(body.shape), moved = center + pose.displacement;
  for (const Vec<dim>& feeler : contact_candidates.points) {
    const Vec<dim> x = moved + turned * (feeler - center);
    const SurfacePoint<dim> at = surface_at_pose(surface, surface_pose, surface_turned, x);
    const Real gap = at.distance - contact_candidates.radius;
    if (gap > reach) continue;
    insert(found,
           {Vec<dim>(x - (second ? at.distance : contact_candidates.radius) * at.normal), second ? at.normal : Vec<dim>(-at.normal), gap});
  }
}

}  // namespace

template <int dim>
std::optional<Proximity<dim>> proximity_of(const RigidShapeSettings& first, const RigidShapeSettings& second)
{
  if constexpr (dim == 3) {
    const bool circle = std::holds_alternative<CircleSettings>(first), other = std::holds_alternative<CircleSettings>(second);
    const bool plane = std::holds_alternative<HalfPlaneSettings>(first) || std::holds_alternative<HalfPlaneSettings>(second);
    if (!is_sphere<3>(first) && !is_sphere<3>(second) && !(circle && other) && !((circle || other) && plane)) return {};
  }
  Proximity<dim> proximity{candidates_of<dim>(first), candidates_of<dim>(second)};
  // A ball's nearest point of the other surface is that of the whole ball. Of a sphere and a circle in space it is the sphere that has one.
  const bool first_is_ball = proximity.of_first.points.size() == 1 && (is_sphere<dim>(first) || !is_sphere<dim>(second));
  if (first_is_ball)
    proximity.of_second = {};
  else if (proximity.of_second.points.size() == 1)
    proximity.of_first = {};
  if (proximity.of_first.points.empty() && proximity.of_second.points.empty()) return {};
  return proximity;
}

template <int dim>
ProximityPoints<dim> proximity_points(const Proximity<dim>& proximity, const RigidBody<dim>& first, const Pose<dim>& first_pose,
                                      const RigidBody<dim>& second, const Pose<dim>& second_pose, Real reach)
{
  ProximityPoints<dim> found;
  add_points(proximity.of_first, first, first_pose, second, second_pose, true, reach, found);
  add_points(proximity.of_second, second, second_pose, first, first_pose, false, reach, found);
  return found;
}

#define BERM_INSTANTIATE(dim)                                                                                                              \
  template std::optional<Proximity<dim>> proximity_of(const RigidShapeSettings&, const RigidShapeSettings&);                               \
  template ProximityPoints<dim> proximity_points(const Proximity<dim>&, const RigidBody<dim>&, const Pose<dim>&, const RigidBody<dim>&,    \
                                                 const Pose<dim>&, Real);
BERM_INSTANTIATE(2)
BERM_INSTANTIATE(3)
#undef BERM_INSTANTIATE

}  // namespace berm::bodies
