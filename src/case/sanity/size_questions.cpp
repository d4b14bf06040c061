// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/sanity/sanity_test.cpp
// Whether sizes and forces go together: what a slip of a unit, or a key that was left as it was, makes of a case.
#include "sanity/questions.hpp"
#include "sanity/sanity.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::sanity {
namespace {

using settings::StageKind;

/// m2 (plane strain: m), that a body covers from above.
Real area_of(const Scene& s, Index rigid)
{
  const Spans& space = s.rigids[rigid].space;
  const Real width = s.rigids[rigid].width;
  if (s.c.force_dimension() == 2) return width;
  return s.c.geometry == settings::Geometry::space ? space[0].length() * space[2].length() : width * width;
}

/// A force that a stage names, by size.
struct Force {
  std::string key;
  Real size;
  bool presses;  ///< on the bed, as a weight does
};

std::vector<Force> forces_of(const settings::StageSettings& stage)
{
  std::vector<Force> forces;
  const auto add = [&](const char* key, const std::optional<Real>& force, bool presses) {
    if (force && *force != 0) forces.push_back({key, std::abs(*force), presses});
  };
  const bool push = stage.kind == StageKind::push;
  if (drives(stage.kind)) add("force", stage.force, push);
  add("until.force", stage.until.force, push);
  add("vertical_force", stage.vertical_force, true);
  add("drive.x.force", stage.drive.x.force, false);
  add("drive.y.force", stage.drive.y.force, false);
  add("drive.z.force", stage.drive.z.force, false);
  for (std::size_t k = 0; k < settings::load_columns.size(); ++k)
    if (settings::load_columns[k].quantity == settings::LoadQuantity::force && settings::load_columns[k].along <= settings::LoadAlong::z)
      add("load_history", max_load(stage, k), false);
  return forces;
}

}  // namespace

void are_forces_those_of_soil(const Scene& s, Findings& found)
{
  constexpr Real tiny = 0.01, huge = 300, huge_for_clay = 30;
  for (std::size_t k = 0; k < s.ways.size(); ++k) {
    const Index rigid = s.ways[k].rigid, body = rigid == none ? none : s.touched_by(rigid);
    if (body == none || !s.rigids[rigid].bounded || !(s.gravity > 0) || !yields(s.material_of(body))) continue;
    const Real width = s.rigids[rigid].width, area = area_of(s, rigid), weight = unit_weight_of(s, body) * width * area;
    const std::optional<material::Strength> deep = strength_at_rest(s.material_at(body, s.depth_of(body)));
    const Real most = huge * weight + huge_for_clay * (deep && deep->friction_angle == 0 ? deep->cohesion * area : 0);
    const char* unit = s.c.force_dimension() == 2 ? "N/m" : "N";
    for (const Force& force : forces_of(s.c.stage[k])) {
      const std::string key = stage_key(k, force.key), of_soil = fmt::format("the weight of the soil that \"{}\" can displace is {:.3g} {}",
                                                                             s.c.rigid[rigid].first, weight, unit);
      if (force.presses && force.size < tiny * weight)
        found.warn(
            key,
            fmt::format("is {:.3g} {}, almost nothing: {}, and the weight of a body on a seabed is between a tenth of that and ten times "
                        "that: is the unit right? A plain number is in {}: write \"{:.3g} k{}\" where that is meant",
                        force.size, unit, of_soil, unit, force.size, unit));
      else if (force.size > most)
        found.warn(key, fmt::format("is {:.3g} {}, more than soil can carry: {}, and it fails under a hundred times that: is "
                                    "the unit right (\"k{}\", not \"M{}\")?",
                                    force.size, unit, of_soil, unit, unit));
    }
  }
}

void is_the_body_smaller_than_the_mesh(const Scene& s, Findings& found)
{
  if (!std::holds_alternative<mesh::SeabedMesh>(s.c.mesh)) return;
  std::vector<char> asked(s.rigids.size(), 0);
  for (const Way& way : s.ways) {
    const Index rigid = way.rigid, body = rigid == none ? none : s.touched_by(rigid);
    if (body == none || std::exchange(asked[rigid], 1) != 0 || !s.rigids[rigid].bounded) continue;
    const auto& [name, settings] = s.c.rigid[rigid];
    const Real width = s.rigids[rigid].width, length = s.mesh[s.along].length(), depth = s.depth_of(body);
    if (!bodies::pipe_section(settings.shape) || (width < length && width < depth)) continue;
    found.warn("rigid." + name, fmt::format("is {} wide, and the bed is {} long and {} deep: there is no room for the failure mechanism "
                                            "around it; make it smaller (is its unit right?), "
                                            "or the mesh 10 times as long and 3 times as deep as it is wide",
                                            words_of(width, "m"), words_of(length, "m"), words_of(depth, "m")));
  }
}

void does_a_pushed_pipe_begin_at_the_surface(const Scene& s, Findings& found)
{
  constexpr Real rounding = 0.02, half = 0.5;  // of its width
  // Who places it in the soil on purpose takes a round part of its width.
  const auto is_round = [](Real part) { return std::abs(10 * part - std::round(10 * part)) < 1e-6; };
  if (s.c.small_strain() || !s.ground.line.level()) return;
  std::vector<char> asked(s.rigids.size(), 0);
  for (std::size_t k = 0; k < s.ways.size(); ++k) {
    const Index rigid = s.ways[k].rigid;
    if (rigid == none || std::exchange(asked[rigid], 1) != 0 || !s.rigids[rigid].bounded) continue;
    const auto& [name, settings] = s.c.rigid[rigid];
    const settings::StageSettings& stage = s.c.stage[k];
    const Real w = s.ways[k].begin_embedment, width = s.rigids[rigid].width;
    const bool down = stage.kind == StageKind::push && stage.velocity.value_or(1) > 0 && stage.force.value_or(1) > 0;
    if (!down || !bodies::pipe_section(settings.shape) || !(w > rounding * width && w < half * width) || is_round(w / width)) continue;
    const Span& y = s.rigids[rigid].space[s.up];
    found.warn(fmt::format("rigid.{}.center", name),
               fmt::format("puts the lowest point {} ({:.2g} D) below the seabed, in a cavity without soil, and \"{}\" pushes it down "
                           "from there: if it is to be pushed in from the surface, put the centre at {} (has the diameter changed since?)",
                           words_of(w, "m"), w / width, stage.name, place_words((y.from + y.to) / 2 + s.up_sign * w)));
  }
}

}  // namespace berm::sanity
