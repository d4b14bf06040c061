// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/bodies/rigid/shape_test.cpp
#include "bodies/rigid/profile.hpp"

#include <algorithm>

namespace berm::bodies {
namespace {

Real cross_of(const Vec<2>& a, const Vec<2>& b)
{
  return a[0] * b[1] - a[1] * b[0];
}

/// The polygon whose sides lie deeper by the radius, of corners counter-clockwise.
std::vector<Vec<2>> core_of(const std::vector<Vec<2>>& corners, Real radius)
{
  const std::size_t n = corners.size();
  std::vector<Vec<2>> core;
  for (std::size_t k = 0; k < n; ++k) {
    const Vec<2> before = (corners[k] - corners[(k + n - 1) % n]).normalized(), behind = (corners[(k + 1) % n] - corners[k]).normalized();
    const Vec<2> inwards = Vec<2>(-before[1] - behind[1], before[0] + behind[0]);
    core.emplace_back(corners[k] + radius / (1 + before.dot(behind)) * inwards);
  }
  return core;
}

/// Whether the corners' arcs leave something of each side.
bool leaves_sides(const std::vector<Vec<2>>& corners, const std::vector<Vec<2>>& core)
{
  const std::size_t n = corners.size();
  for (std::size_t k = 0; k < n; ++k)
    if (!((core[(k + 1) % n] - core[k]).dot(corners[(k + 1) % n] - corners[k]) > 0)) return false;
  return true;
}

}  // namespace

void describe(Describe& d, ProfileSettings& profile)
{
  d.value(
      "x", profile.x,
      {.meaning = "x of the corners of the right half, from the axis x = 0 to the axis, either way round", .unit = "m", .required = true});
  d.value("y", profile.y, {.meaning = "y of the corners", .unit = "m", .required = true});
  d.value("corner_radius", profile.corner_radius,
          {.meaning = "radius of its convex corners, the tip included; 0 = sharp, which particles half a width away from it feel as an arc",
           .unit = "m",
           .range = not_negative});
}

PolygonSettings whole_of(const ProfileSettings& profile)
{
  PolygonSettings whole{profile.x, profile.y};
  for (std::size_t k = profile.x.size(); k-- > 0;)
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
  d.check(x.empty() || (x.front() == 0 && x.back() == 0), path + ".x", "must begin and end at the axis x = 0");
  d.check(std::all_of(x.begin(), x.end(), [&](const Real& at) { return &at == &x.front() || &at == &x.back() || at > 0; }), path + ".x",
          "of the corners between the first and the last must be more than 0: the other half is the mirror image");
  const PolygonSettings whole = whole_of(profile);
  check(d, path, whole, dimension);
  if (profile.corner_radius == 0 || !is_simple(whole)) return;
  const Polygon<2> polygon = make_shape<2>(whole);
  const std::vector<Vec<2>> core = core_of(*polygon.corners, profile.corner_radius);
  PolygonSettings inner;
  for (const Vec<2>& corner : core) inner.x.push_back(corner[0]), inner.y.push_back(corner[1]);
  d.check(leaves_sides(*polygon.corners, core) && is_simple(inner), path + ".corner_radius", "is too large for the sides of the profile");
}

std::string name_of(const ProfileSettings&)
{
  return "profile";
}
std::vector<ShapeSize> sizes_of(const ProfileSettings& profile)
{
  const auto [low, high] = std::minmax_element(profile.y.begin(), profile.y.end());
  return {{"width", 2 * *std::max_element(profile.x.begin(), profile.x.end())}, {"height", *high - *low}};
}
Outline outline_of(const ProfileSettings& profile)
{
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

template <int dim>
Profile<dim> make_shape(const ProfileSettings& s)
{
  Polygon<dim> polygon = make_shape<dim>(whole_of(s));
  const Vec<3> inertia = inertia_over_mass<dim>(polygon);
  if (s.corner_radius > 0) polygon.corners = std::make_shared<const std::vector<Vec<2>>>(core_of(*polygon.corners, s.corner_radius));
  return {polygon, s.corner_radius, inertia};
}

template Profile<2> make_shape<2>(const ProfileSettings&);
template Profile<3> make_shape<3>(const ProfileSettings&);

}  // namespace berm::bodies
