// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/bodies/rigid/shape_test.cpp
#include "bodies/rigid/profile.hpp"

#include "bodies/rigid/rounding.hpp"

#include <algorithm>

namespace berm::bodies {
namespace {

Real cross_of(const Vec<2>& a, const Vec<2>& b)
{
  return a[0] * b[1] - a[1] * b[0];
}

}  // namespace

void describe(Describe& d, ProfileSettings& profile)
{
  d.value("x", profile.x,
          {.meaning = "x of the corners of the right half, from the axis x = 0 to the axis, in either direction",
           .unit = "m",
           .required = true});
  d.value("y", profile.y, {.meaning = "y of the corners", .unit = "m", .required = true});
  d.value("corner_radius", profile.corner_radius,
          {.meaning = "radius of its convex corners, the tip included; 0 = sharp, which acts on particles half a width away like an arc",
           .unit = "m",
           .range = not_negative});
  d.value("position", profile.position,
          {.meaning = "in space: where the point x = y = 0 of the profile lies; absent = at the origin", .unit = "m"});
  d.value("axis", profile.axis, {.meaning = "in space: direction of the profile's y, its axis, of any length; absent = along y"});
}

bool is_ring(const ProfileSettings& profile)
{
  return std::all_of(profile.x.begin(), profile.x.end(), [](Real x) { return x > 0; });
}

PolygonSettings whole_of(const ProfileSettings& profile)
{
  PolygonSettings whole{profile.x, profile.y};
  for (std::size_t k = is_ring(profile) ? 0 : profile.x.size(); k-- > 0;)
    if (profile.x[k] != 0 && k < profile.y.size()) {
      whole.x.push_back(-profile.x[k]);
      whole.y.push_back(profile.y[k]);
    }
  return whole;
}

void check(Describe& d, const std::string& path, const ProfileSettings& profile, int dimension)
{
  const std::vector<Real>& x = profile.x;
  d.check(x.size() >= 3, path + ".x", fmt::format("needs three corners or more, and has {}", x.size()));
  const bool ring = is_ring(profile);
  d.check(x.empty() || ring || (x.front() == 0 && x.back() == 0), path + ".x",
          "must begin and end at the axis x = 0, or lie off it all around");
  d.check(ring || std::all_of(x.begin(), x.end(), [&](const Real& at) { return &at == &x.front() || &at == &x.back() || at > 0; }),
          path + ".x", "of the corners between the first and the last must be more than 0: the other half is the mirror image");
  d.check(dimension == 3 || profile.position.empty(), path + ".position", "is for space; in the plane x and y say where the profile is");
  d.check(dimension == 3 || profile.axis.empty(), path + ".axis", "is for space; in the plane the axis is x = 0");
  if (dimension == 3) {
    check_entries(d, path + ".position", profile.position, 3, true);
    check_entries(d, path + ".axis", profile.axis, 3, true);
    d.check(profile.axis.empty() || !to_vec<3>(profile.axis).isZero(0), path + ".axis", "must not be zero");
  }
  const PolygonSettings whole = whole_of(profile);
  check(d, path, whole, dimension);
  if (profile.corner_radius == 0 || !is_simple(whole)) return;
  const Polygon<2> polygon = make_shape<2>(whole);
  const std::vector<Vec<2>> core = core_of(*polygon.corners, profile.corner_radius);
  PolygonSettings inner;
  for (const Vec<2>& corner : core) inner.x.push_back(corner[0]), inner.y.push_back(corner[1]);
  d.check(leaves_sides(*polygon.corners, core) && is_simple(inner), path + ".corner_radius", "is too large for the sides of the profile");
}

std::vector<ShapeSize> sizes_of(const ProfileSettings& profile)
{
  const auto [low, high] = std::minmax_element(profile.y.begin(), profile.y.end());
  return {{"width", 2 * *std::max_element(profile.x.begin(), profile.x.end())}, {"height", *high - *low}};
}
Outline outline_of(const ProfileSettings& profile)
{
  if (!profile.position.empty() || !profile.axis.empty())
    return hull_of(seen_along_z(surface_mesh<3>(make_shape<3>(profile), Vec<3>(Vec<3>::Zero()), Vec<3>(Vec<3>::Zero())).points));
  return outline_of(whole_of(profile));
}

std::vector<Vec<2>> rounded_corners(const std::vector<Vec<2>>& core, Real radius, int points_of_arc)
{
  if (radius == 0) return core;
  const std::size_t n = core.size();
  std::vector<Vec<2>> outline;
  for (std::size_t k = 0; k < n; ++k) {
    const Vec<2> before = (core[k] - core[(k + n - 1) % n]).normalized(), behind = (core[(k + 1) % n] - core[k]).normalized();
    const Real turn = std::atan2(cross_of(before, behind), before.dot(behind));
    if (turn <= 0) {
      outline.emplace_back(core[k] + radius / (1 + before.dot(behind)) * Vec<2>(before[1] + behind[1], -before[0] - behind[0]));
      continue;
    }
    const Real first = std::atan2(-before[0], before[1]);  // of the normal out of the side before
    for (int p = 0; p < points_of_arc; ++p) {
      const Real angle = first + turn * p / (points_of_arc - 1);
      outline.emplace_back(core[k] + radius * Vec<2>(std::cos(angle), std::sin(angle)));
    }
  }
  return outline;
}

namespace {

Profile<2> in_plane(const ProfileSettings& s)
{
  Polygon<2> polygon = make_shape<2>(whole_of(s));
  const Vec<3> inertia = inertia_over_mass<2>(polygon);
  if (s.corner_radius > 0) polygon.corners = std::make_shared<const std::vector<Vec<2>>>(core_of(*polygon.corners, s.corner_radius));
  return {polygon, s.corner_radius, inertia, is_ring(s) ? 2 * *std::max_element(s.x.begin(), s.x.end()) : 0};
}

/// The right half of a closed outline about x = 0, in its order.
std::vector<Vec<2>> right_half(const std::vector<Vec<2>>& outline)
{
  std::vector<Vec<2>> half;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const Vec<2>&a = outline[k], &b = outline[(k + 1) % outline.size()];
    if (a[0] >= 0) half.push_back(a);
    if (a[0] * b[0] < 0) half.emplace_back(0, a[1] + a[0] / (a[0] - b[0]) * (b[1] - a[1]));
  }
  return half;
}

/// The outline across the axis with its arcs, x the radius.
std::vector<Vec<2>> half_outline_of(const Polygon<2>& core, Real radius, int points_of_arc)
{
  std::vector<Vec<2>> outline = rounded_corners(*core.corners, radius, points_of_arc);
  for (Vec<2>& corner : outline) {
    corner += core.center;
    if (std::abs(corner[0]) < 1e-12 * reach_of<2>(core)) corner[0] = 0;
  }
  return right_half(outline);
}

Profile<3> around_axis(const ProfileSettings& s)
{
  const Profile<2> flat = in_plane(s);
  constexpr int fine = 1000;  // the chords miss 1e-7 of what a corner's arc holds
  const Revolution solid = revolved(half_outline_of(flat.core, s.corner_radius, fine));
  Profile<3> profile{to_vec<3>(s.position),
                     s.axis.empty() ? Matrix<3>(Matrix<3>::Identity()) : frame_along(to_vec<3>(s.axis)),
                     flat.core,
                     s.corner_radius,
                     solid.inertia,
                     2 * *std::max_element(s.x.begin(), s.x.end()),
                     0};
  profile.center += solid.level * profile.axes.col(1);
  profile.core.center[1] -= solid.level;
  if (!is_ring(s)) profile.core.center[0] = 0;
  for (const Vec<2>& corner : *profile.core.corners) profile.reach = std::max(profile.reach, (profile.core.center + corner).norm());
  profile.reach += s.corner_radius;
  return profile;
}

}  // namespace

template <int dim>
Profile<dim> make_shape(const ProfileSettings& s)
{
  if constexpr (dim == 2)
    return in_plane(s);
  else
    return around_axis(s);
}

template <int dim>
Real lowest_level(const Profile<dim>& profile, const Vec<dim>& up)
{
  if constexpr (dim == 2) {
    return lowest_level<dim>(profile.core, up) - profile.radius;
  } else {
    const Real along = profile.axes.col(1).dot(up), across = std::sqrt(std::max(Real(0), 1 - along * along));
    Real lowest = infinity;
    for (const Vec<2>& corner : *profile.core.corners) {
      const Vec<2> at = profile.core.center + corner;
      lowest = std::min(lowest, along * at[1] - across * std::abs(at[0]));
    }
    return up.dot(profile.center) + lowest - profile.radius;
  }
}

template <int dim>
SurfaceMesh<dim> surface_mesh(const Profile<dim>& profile, const Vec<dim>& lower, const Vec<dim>& upper)
{
  if constexpr (dim == 2) {
    std::vector<Vec<dim>> outline;
    for (const Vec<2>& corner : rounded_corners(*profile.core.corners, profile.radius))
      outline.push_back(profile.core.center + profile.core.axes.template leftCols<2>() * corner);
    return extruded(outline, lower, upper);
  } else {
    return revolved_surface(half_outline_of(profile.core, profile.radius, 8),
                            [&](const Vec<3>& x) { return Vec<3>(profile.center + profile.axes * x); });
  }
}

#define BERM_INSTANTIATE(dim)                                                                                                              \
  template Profile<dim> make_shape<dim>(const ProfileSettings&);                                                                           \
  template Real lowest_level<dim>(const Profile<dim>&, const Vec<dim>&);                                                                   \
  template SurfaceMesh<dim> surface_mesh<dim>(const Profile<dim>&, const Vec<dim>&, const Vec<dim>&);
BERM_INSTANTIATE(2)
BERM_INSTANTIATE(3)
#undef BERM_INSTANTIATE

}  // namespace berm::bodies
