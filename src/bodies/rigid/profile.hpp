// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/rigid/polygon.hpp"

namespace berm::bodies {

/// A body that is its own mirror image about x = 0, by its right half: a cone with its shaft or a pile where x is a radius, a wedge in plane strain, in space
/// an infinite prism. Corners in order from the axis to the axis, either way round.
struct ProfileSettings {
  static constexpr const char* word = "profile";

  std::vector<Real> x, y;  ///< m
  Real corner_radius = 0;  ///< m
};

void describe(Describe& d, ProfileSettings& profile);
void check(Describe& d, const std::string& path, const ProfileSettings& profile, int dimension);

/// Both halves.
PolygonSettings whole_of(const ProfileSettings& profile);

std::string name_of(const ProfileSettings& profile);
std::vector<ShapeSize> sizes_of(const ProfileSettings& profile);
Outline outline_of(const ProfileSettings& profile);

/// A polygon whose convex corners are round: all that is nearer than the radius to a smaller polygon, the core. Re-entrant corners stay sharp; within the body
/// behind one the distance is that from the core.
template <int dim>
struct Profile {
  using Settings = ProfileSettings;
  static constexpr bool bounded = true, has_corners = true;

  Polygon<dim> core;
  Real radius;     ///< m, of the corners
  Vec<3> inertia;  ///< over mass, of the sharp polygon, m2
};

template <int dim>
Profile<dim> make_shape(const ProfileSettings& s);

template <int dim>
SurfacePoint<dim> surface_at(const Profile<dim>& profile, const Vec<dim>& x)
{
  const SurfacePoint<dim> of_core = surface_at<dim>(profile.core, x);
  return {of_core.distance - profile.radius, of_core.normal};
}
template <int dim>
Vec<dim> center_of(const Profile<dim>& profile)
{
  return profile.core.center;
}
template <int dim>
Real lowest_level(const Profile<dim>& profile, const Vec<dim>& up)
{
  return lowest_level<dim>(profile.core, up) - profile.radius;
}
template <int dim>
Real width_of(const Profile<dim>& profile)
{
  return width_of<dim>(profile.core) + 2 * profile.radius;
}
template <int dim>
Real reach_of(const Profile<dim>& profile)
{
  return reach_of<dim>(profile.core) + profile.radius;
}
template <int dim>
Vec<3> inertia_over_mass(const Profile<dim>& profile)
{
  return profile.inertia;
}
template <int dim>
Profile<dim> moved(Profile<dim> profile, const Movement<dim>& m)
{
  profile.core = moved(profile.core, m);
  return profile;
}

/// The outline with its arcs, of so many points each.
std::vector<Vec<2>> rounded_corners(const std::vector<Vec<2>>& core, Real radius, int points_of_arc = 8);

template <int dim>
SurfaceMesh<dim> surface_mesh(const Profile<dim>& profile, const Vec<dim>& lower, const Vec<dim>& upper)
{
  std::vector<Vec<dim>> outline;
  for (const Vec<2>& corner : rounded_corners(*profile.core.corners, profile.radius))
    outline.push_back(profile.core.center + profile.core.axes.template leftCols<2>() * corner);
  return extruded(outline, lower, upper);
}

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
inline Real closes_after(const Profile<2>&)
{
  return infinity;
}

}  // namespace berm::bodies
