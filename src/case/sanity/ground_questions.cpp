// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/sanity/sanity_test.cpp
#include "sanity/questions.hpp"
#include "sanity/sanity.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::sanity {
namespace {

/// A straight part of the ground that goes up or down.
struct Face {
  Real angle, rise, run;  ///< rad, m, m; all positive
  Real foot;              ///< y of its lower end, m
};

/// Neighbouring parts of the line whose angles differ by little are one face.
std::vector<Face> faces_of(const mesh::GroundLine& line)
{
  constexpr Real same = 3 * degree;
  std::vector<Face> faces;
  Real last = 0;
  for (std::size_t k = 1; k < line.corners.size(); ++k) {
    const Vec<2>&a = line.corners[k - 1], &b = line.corners[k];
    const Real angle = std::atan2(b[1] - a[1], b[0] - a[0]), rise = std::abs(b[1] - a[1]), run = b[0] - a[0], foot = std::min(a[1], b[1]);
    if (!faces.empty() && std::abs(angle - last) < same) {
      Face& face = faces.back();
      face = {0, face.rise + rise, face.run + run, std::min(face.foot, foot)};
    } else {
      faces.push_back({0, rise, run, foot});
    }
    faces.back().angle = std::atan2(faces.back().rise, faces.back().run);
    last = angle;
  }
  return faces;
}

/// The key that says the angle of a face: that of the slope where the face is as steep as it.
std::string key_of(const Scene& s, const Face& face)
{
  constexpr Real same = 0.1 * degree;
  const auto* bed = std::get_if<mesh::SeabedMesh>(&s.c.mesh);
  if (bed == nullptr) return "mesh";
  const bool slope = (!bed->trench && !bed->step) || std::abs(face.angle - std::abs(bed->slope)) < same;
  return slope ? "mesh.slope" : bed->trench ? "mesh.trench.side_slope" : "mesh.step.face_slope";
}

/// The largest height at which a face of homogeneous soil stands, m: that of a plane of sliding through its foot (Culmann 1866),
///
///   H = 4 c sin(beta) cos(phi) / (gamma (1 - cos(beta - phi))),
///
/// 4 c / gamma of a vertical cut in clay; in clay at most 5.52 c / gamma, where the ground below the foot fails with it (Taylor 1937).
Real standing_height(const material::Strength& soil, Real unit_weight, Real angle)
{
  if (angle <= soil.friction_angle) return infinity;
  const Real plane =
      4 * soil.cohesion * std::sin(angle) * std::cos(soil.friction_angle) / (unit_weight * (1 - std::cos(angle - soil.friction_angle)));
  return soil.friction_angle > 0 ? plane : std::min(plane, 5.52 * soil.cohesion / unit_weight);
}

/// Depth at which soil below an endless slope slides along it, m; infinity where it does not above the base: tau = gamma z sin cos > c + gamma z cos^2 tan(phi).
Real sliding_depth(const Scene& s, Index body, Real unit_weight, Real angle)
{
  constexpr int parts = 20;
  for (int k = 1; k <= parts; ++k) {
    const Real depth = s.depth_of(body) * k / parts;
    const std::optional<material::Strength> soil = strength_at_rest(s.material_at(body, depth));
    if (!soil) return infinity;
    const Real cosine = std::cos(angle), weight = unit_weight * depth;
    if (weight * std::sin(angle) * cosine > (soil->cohesion + weight * cosine * cosine * std::tan(soil->friction_angle)) * 1.001)
      return depth;
  }
  return infinity;
}

/// Whether it has something to say.
bool ask_slope(const Scene& s, Findings& found, Index body, const Face& face, Real unit_weight)
{
  const Real depth = sliding_depth(s, body, unit_weight, face.angle);
  if (!(depth < infinity)) return false;
  const material::Strength soil = *strength_at_rest(s.material_at(body, depth));
  const std::string key = key_of(s, face), angle = fmt::format("{:.3g} deg", face.angle / degree);
  if (soil.cohesion == 0)
    found.refuse(key, fmt::format("the ground slopes by {}, more than the friction angle of [body.{}], {:.3g} deg: soil without cohesion "
                                  "slides down it under its own weight; make it flatter, or the soil stronger",
                                  angle, s.c.body[body].first, soil.friction_angle / degree));
  else
    found.warn(key, fmt::format("the ground slopes by {}, and [body.{}] slides down it at a depth of {}: its weight causes a shear stress "
                                "of {:.3g} Pa there, and its cohesion is {:.3g} Pa; make it flatter or shallower, or the soil stronger",
                                angle, s.c.body[body].first, words_of(depth, "m"),
                                unit_weight * depth * std::sin(face.angle) * std::cos(face.angle), soil.cohesion));
  return true;
}

/// Whether it has something to say.
bool ask_face(const Scene& s, Findings& found, Index body, const Face& face, Real unit_weight, const std::string& key)
{
  const std::optional<material::Strength> soil = strength_at_rest(s.material_at(body, face.rise / 2));
  if (!soil) return false;
  const Real stands = standing_height(*soil, unit_weight, face.angle);
  if (face.rise <= stands * 1.001) return false;
  const std::string angle = fmt::format("{:.3g} deg", face.angle / degree);
  if (soil->cohesion == 0)
    found.warn(key, fmt::format("a face of {} is steeper than the friction angle of [body.{}], {:.3g} deg: soil without cohesion flows "
                                "down until the slope is at that angle; make it flatter",
                                angle, s.c.body[body].first, soil->friction_angle / degree));
  else
    found.warn(
        key, fmt::format(
                 "a face of {} that is {} high does not stand: [body.{}] with a cohesion of {:.3g} Pa in its middle stands up to a height "
                 "of {} (plane of sliding through the toe; 4 su / unit weight for a vertical cut in clay); make it flatter or lower",
                 angle, words_of(face.rise, "m"), s.c.body[body].first, soil->cohesion, words_of(stands, "m")));
  return true;
}

}  // namespace

void does_the_ground_stand(const Scene& s, Findings& found)
{
  if (s.ground.line.level() || s.gravity == 0) return;
  constexpr Real endless = 3;  // depths of soil
  for (Index b = 0; b < static_cast<Index>(s.bodies.size()); ++b) {
    if (!yields(s.material_of(b)) || !s.c.body[b].second.has_k0() || s.c.body[b].second.regions.empty()) continue;
    const Real unit_weight = unit_weight_of(s, b);
    bool slope_slides = false, face_falls = false;  // the first of each that fails is enough
    for (const Face& face : faces_of(s.ground.line)) {
      if (face.rise < 1e-3 * s.depth_of(b)) continue;
      const bool slope = face.run > endless * s.depth_of(b);
      if (slope && !slope_slides) slope_slides = ask_slope(s, found, b, face, unit_weight);
      if (!slope && !face_falls) face_falls = ask_face(s, found, b, face, unit_weight, key_of(s, face));
    }
    if (slope_slides || face_falls) return;
  }
}

void do_excavations_stand(const Scene& s, Findings& found)
{
  constexpr Real flat = 2 * degree;
  if (s.gravity == 0 || s.up != 1 || s.up_sign < 0) return;
  for (Index b = 0; b < static_cast<Index>(s.bodies.size()); ++b) {
    if (!yields(s.material_of(b))) continue;
    const Real beside = 1e-4 * s.mesh[s.along].length();
    const std::vector<bodies::ExcavationSettings>& works = s.c.body[b].second.excavation;
    for (std::size_t k = 0; k < works.size(); ++k) {
      const std::vector<Real>&x = works[k].area.x, &y = works[k].area.y;
      const Real middle = works[k].z_range.empty() ? 0 : (works[k].z_range[0] + works[k].z_range[1]) / 2;
      const bodies::Polygon<2> area = bodies::make_shape<2>(works[k].area);
      for (std::size_t corner = 0; corner < x.size(); ++corner) {
        Vec<2> low(x[corner], y[corner]), high(x[(corner + 1) % x.size()], y[(corner + 1) % x.size()]);
        if (low[1] > high[1]) std::swap(low, high);
        const Real top = s.ground.line.level() ? s.c.surface : s.ground.line.height(low[0]);
        if (high[1] > top && high[1] > low[1]) high = low + (high - low) * std::max(Real(0), top - low[1]) / (high[1] - low[1]);
        const Real angle = std::atan2(high[1] - low[1], std::abs(high[0] - low[0]));
        if (!(high[1] > low[1]) || angle < flat) continue;
        const Vec<2> at = (low + high) / 2, out = Vec<2>(high[1] - low[1], low[0] - high[0]).normalized() * beside;
        const Vec<2> one = at + out, other = at - out, side = surface_at(area, one).distance > 0 ? one : other;
        if (surface_at(area, side).distance <= 0 || side[0] < s.mesh[0].from || side[0] > s.mesh[0].to) continue;
        // Soil stays above an overhanging side only where the other side of it is dug.
        if (!s.soil_at(b, {side[0], side[1], middle})) continue;
        if (ask_face(s, found, b, {angle, high[1] - low[1], std::abs(high[0] - low[0]), low[1]}, unit_weight_of(s, b),
                     fmt::format("body.{}.excavation[{}]", s.c.body[b].first, k)))
          break;
      }
    }
  }
}

void does_the_body_fit_the_ground(const Scene& s, Findings& found)
{
  constexpr Real small = 0.02;  // of the width
  if (s.ground.line.level()) return;
  std::vector<char> asked(s.rigids.size(), 0);
  for (const Way& way : s.ways) {
    if (way.rigid == none || std::exchange(asked[way.rigid], 1) != 0) continue;
    const auto& [name, settings] = s.c.rigid[way.rigid];
    if (!bodies::pipe_section(settings.shape)) continue;
    const Span &x = s.rigids[way.rigid].space[s.along], &y = s.rigids[way.rigid].space[s.up];
    const Real radius = s.rigids[way.rigid].width / 2;
    Vec<2> center((x.from + x.to) / 2, (y.from + y.to) / 2);
    const Real below = s.ground.line.height(center[0]), w = below - y.from, overlap = radius - s.ground.line.distance(center);
    if (w > small * 2 * radius || overlap <= small * 2 * radius) continue;  // one that lies deeper is meant to
    Real low = center[1], high = std::max(center[1], s.ground.line.heights(center[0] - radius, center[0] + radius).second) + 2 * radius;
    for (int k = 0; k < 60; ++k) {
      center[1] = (low + high) / 2;
      (s.ground.line.distance(center) < radius ? low : high) = center[1];
    }
    found.warn(
        fmt::format("rigid.{}.center", name),
        fmt::format(
            "its lowest point is {} {} the ground below its axis, and ground beside it reaches {} into it, where soil is left out: it "
            "touches the ground with its centre at y = {:.4g} m",
            words_of(std::abs(w) < 1e-9 * radius ? 0 : std::abs(w), "m"), w < 0 ? "above" : "below", words_of(overlap, "m"), high));
  }
}

}  // namespace berm::sanity
