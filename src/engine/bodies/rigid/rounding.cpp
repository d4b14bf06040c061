// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/bodies/rigid/shape_test.cpp
#include "bodies/rigid/rounding.hpp"

namespace berm::bodies {
namespace {

Profile<2> with_arcs(const Polygon<2>& sharp, Real radius, Real ring_width = 0)
{
  const std::vector<Vec<2>>& corners = *sharp.corners;
  std::vector<Vec<2>> core = core_of(corners, radius);
  while (!leaves_sides(corners, core)) core = core_of(corners, radius /= 2);
  Profile<2> round{sharp, radius, inertia_over_mass<2>(sharp), ring_width};
  round.core.corners = std::make_shared<const std::vector<Vec<2>>>(std::move(core));
  return round;
}

Polygon<2> with_corners(Polygon<2> polygon, std::vector<Vec<2>> corners)
{
  polygon.corners = std::make_shared<const std::vector<Vec<2>>>(std::move(corners));
  return polygon;
}

RigidShape<2> with_arcs(const Box<2>& box, Real radius)
{
  const auto [x, y] = std::pair{box.half[0], box.half[1]};
  return with_arcs(with_corners({box.center, box.axes, {}}, {{-x, -y}, {x, -y}, {x, y}, {-x, y}}), radius);
}

RigidShape<2> with_arcs(const Profile<2>& profile, Real radius)
{
  if (profile.radius >= radius) return profile;
  return with_arcs(with_corners(profile.core, core_of(*profile.core.corners, -profile.radius)), radius, profile.ring_width);
}

Real cross(const Vec<2>& a, const Vec<2>& b)
{
  return a[0] * b[1] - a[1] * b[0];
}

Vec<2> outwards(const Vec<2>& along)
{
  return {along[1], -along[0]};
}

}  // namespace

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

bool leaves_sides(const std::vector<Vec<2>>& corners, const std::vector<Vec<2>>& core)
{
  const std::size_t n = corners.size();
  for (std::size_t k = 0; k < n; ++k)
    if (!((core[(k + 1) % n] - core[k]).dot(corners[(k + 1) % n] - corners[k]) > 0)) return false;
  return true;
}

RigidShape<2> rounded(const RigidShape<2>& shape, Real radius)
{
  return std::visit(
      [&](const auto& of_kind) -> RigidShape<2> {
        if constexpr (requires { with_arcs(of_kind, radius); })
          return with_arcs(of_kind, radius);
        else
          return of_kind;
      },
      shape);
}

std::vector<Fillet> fillets_of(const RigidShape<2>& shape, Real radius)
{
  const auto* profile = std::get_if<Profile<2>>(&shape);
  if (profile == nullptr) return {};
  const std::vector<Vec<2>>& corners = *profile->core.corners;
  const std::size_t n = corners.size();
  std::vector<Fillet> fillets;
  for (std::size_t k = 0; k < n; ++k) {
    const Vec<2> to = corners[k] - corners[(k + n - 1) % n], from = corners[(k + 1) % n] - corners[k];
    const Vec<2> before = to.normalized(), behind = from.normalized();
    if (!(cross(before, behind) < 0)) continue;
    // The arc and the sides beside it, of which it takes half at most, meet at this distance from the corner of the core for a radius of 1.
    const Real along = -cross(before, behind) / (1 + before.dot(behind)), room = std::min(to.norm(), from.norm()) / 2;
    const Real from_core = std::min(radius + profile->radius, room / along);
    if (!(from_core > profile->radius)) continue;
    const Vec<2> first = profile->core.axes * outwards(before), second = profile->core.axes * outwards(behind);
    const Vec<2> corner = profile->core.center + profile->core.axes * corners[k];
    fillets.push_back({corner + from_core / (1 + before.dot(behind)) * (first + second), first, second, from_core - profile->radius});
  }
  return fillets;
}

SurfacePoint<2> with_fillets(const std::vector<Fillet>& fillets, const SurfacePoint<2>& sharp, const Vec<2>& x)
{
  constexpr Real rounding = 1e-9;
  for (const Fillet& fillet : fillets) {
    if (!(sharp.distance < fillet.radius)) continue;
    const Vec<2> to_center = fillet.center - x;
    const Real turn = cross(fillet.before, fillet.behind);
    const bool beside_arc = cross(to_center, fillet.behind) * turn >= 0 && cross(fillet.before, to_center) * turn >= 0;
    // Not behind the body, where its surface has other normals.
    const Real least = fillet.before.dot(fillet.behind) - rounding;
    if (!beside_arc || sharp.normal.dot(fillet.before) < least || sharp.normal.dot(fillet.behind) < least) continue;
    const Real away = to_center.norm();
    if (away > 0) return {fillet.radius - away, to_center / away};
  }
  return sharp;
}

}  // namespace berm::bodies
