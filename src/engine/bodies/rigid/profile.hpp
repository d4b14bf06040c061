// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/rigid/placement.hpp"
#include "bodies/rigid/polygon.hpp"

namespace berm::bodies {

/// A body that is its own mirror image about x = 0, by its right half: a cone with its shaft or a pile where x is a radius (in space: all around its axis), a
/// wedge in plane strain. Corners in order from the axis to the axis, either way round; or off the axis all around: a ring, such as a bucket's skirt.
struct ProfileSettings {
  static constexpr const char* word = "profile";

  std::vector<Real> x, y;                      ///< m
  Real corner_radius = 0;                      ///< m
  std::vector<Real> position = {}, axis = {};  ///< in space: m, where x = y = 0 lies, and the direction of y; empty: at 0, along y

  bool round_from_above() const { return true; }
};

/// Whether it does not touch its axis.
bool is_ring(const ProfileSettings& profile);

void describe(Describe& d, ProfileSettings& profile);
void check(Describe& d, const std::string& path, const ProfileSettings& profile, int dimension);

/// Both halves; of a ring the right one.
PolygonSettings whole_of(const ProfileSettings& profile);

std::vector<ShapeSize> sizes_of(const ProfileSettings& profile);
Outline outline_of(const ProfileSettings& profile);

/// A polygon whose convex corners are round: all that is nearer than the radius to a smaller polygon, the core. Re-entrant corners stay sharp; within the body
/// behind one the distance is that from the core.
template <int dim>
struct Profile {
  using Settings = ProfileSettings;
  static constexpr bool bounded = true, has_corners = true;

  Polygon<dim> core;
  Real radius;          ///< m, of the corners
  Vec<3> inertia;       ///< over mass, of the sharp polygon, m2
  Real ring_width = 0;  ///< m, outer diameter of a ring; else 0
};

/// In space: revolved about its axis.
template <>
struct Profile<3> {
  using Settings = ProfileSettings;
  static constexpr bool bounded = true, has_corners = true;

  Vec<3> center;    ///< of mass
  Matrix<3> axes;   ///< its axis is the second column
  Polygon<2> core;  ///< across the axis, as seen from the centre
  Real radius;      ///< m, of the corners
  Vec<3> inertia;   ///< over mass, m2
  Real width, reach;

  /// (radius from the axis, level along it) of a point.
  Vec<2> across_axis(const Vec<3>& local) const { return {std::hypot(local[0], local[2]), local[1]}; }
};

template <int dim>
Profile<dim> make_shape(const ProfileSettings& s);

template <int dim>
SurfacePoint<dim> surface_at(const Profile<dim>& profile, const Vec<dim>& x)
{
  if constexpr (dim == 2) {
    const SurfacePoint<dim> of_core = surface_at<dim>(profile.core, x);
    return {of_core.distance - profile.radius, of_core.normal};
  } else {
    const Vec<3> local = profile.axes.transpose() * (x - profile.center);
    const Vec<2> across = profile.across_axis(local);
    const SurfacePoint<2> of_core = surface_at<2>(profile.core, across);
    Vec<3> normal(of_core.normal[0], of_core.normal[1], 0);
    if (across[0] > 0) normal[0] = of_core.normal[0] * local[0] / across[0], normal[2] = of_core.normal[0] * local[2] / across[0];
    return {of_core.distance - profile.radius, profile.axes * normal};
  }
}
template <int dim>
requires(dim == 2) Vec<dim> center_of(const Profile<dim>& profile)
{
  return profile.core.center;
}
template <int dim>
Real lowest_level(const Profile<dim>& profile, const Vec<dim>& up);
template <int dim>
Real width_of(const Profile<dim>& profile)
{
  if constexpr (dim == 2)
    return profile.ring_width > 0 ? profile.ring_width : width_of<dim>(profile.core) + 2 * profile.radius;
  else
    return profile.width;
}
template <int dim>
Real reach_of(const Profile<dim>& profile)
{
  if constexpr (dim == 2)
    return reach_of<dim>(profile.core) + profile.radius;
  else
    return profile.reach;
}
template <int dim>
Vec<3> inertia_over_mass(const Profile<dim>& profile)
{
  return profile.inertia;
}
template <int dim>
requires(dim == 2) Profile<dim> moved(Profile<dim> profile, const Movement<dim>& m)
{
  profile.core = moved(profile.core, m);
  return profile;
}

/// The outline with its arcs, of so many points each.
std::vector<Vec<2>> rounded_corners(const std::vector<Vec<2>>& core, Real radius, int points_of_arc = 8);

template <int dim>
SurfaceMesh<dim> surface_mesh(const Profile<dim>& profile, const Vec<dim>& lower, const Vec<dim>& upper);

/// The arc at a corner is shared by its two sides.
template <class Visit>
void visit_sides(const Profile<2>& profile, const Vec<2>& x, const Visit& visit)
{
  const std::vector<Vec<2>>& corners = *profile.core.corners;
  const auto half_arc = [&](std::size_t corner) {
    const std::size_t n = corners.size();
    const Vec<2> before = corners[corner] - corners[(corner + n - 1) % n], behind = corners[(corner + 1) % n] - corners[corner];
    return std::max(Real(0), profile.radius * std::atan2(before[0] * behind[1] - before[1] * behind[0], before.dot(behind)) / 2);
  };
  visit_sides(profile.core, x, [&](int side, OnSide at) {
    const std::size_t k = static_cast<std::size_t>(side), n = corners.size();
    const Vec<2> along = (corners[(k + 1) % n] - corners[k]).normalized(), outwards = profile.core.axes * Vec<2>(along[1], -along[0]);
    at.away -= profile.radius;
    at.begin -= half_arc(k);
    at.end += half_arc((k + 1) % n);
    at.x += profile.radius * outwards[0];
    visit(side, at);
  });
}

}  // namespace berm::bodies
