// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/sanity/sanity_test.cpp
#include "core/names.hpp"
#include "os/text_of_list.hpp"
#include "sanity/questions.hpp"
#include "sanity/sanity.hpp"
#include "settings/stage.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::sanity {
namespace {

/// A support that moves along an axis in a stage.
struct MotionInStage {
  std::size_t support, stage;
  int axis;
  boundary::MotionMeasures measures;
  bool across;  ///< the boundary, which is flat: pressure waves
  Real travel;  ///< m, of the boundary to either side, at most
};

/// Calls visit(motion) for each.
template <class Visit>
void for_each_motion(const Scene& s, const Visit& visit)
{
  constexpr Real flat = 1e-6;    // of the size of the mesh
  constexpr Real with_echo = 2;  // a boundary that absorbs moves by the wave that comes in and the one that comes back
  for (std::size_t k = 0; k < s.c.support.size(); ++k) {
    const boundary::SupportSettings& support = s.c.support[k].second;
    if (!support.motion) continue;
    std::array<Real, 3> before{};  // m, where earlier stages left it
    for (std::size_t stage = 0; stage < s.c.stage.size(); ++stage) {
      const std::vector<std::string>& named = support.motion->stages;
      if (std::find(named.begin(), named.end(), s.c.stage[stage].name) == named.end()) continue;
      const Real time = expected_time(s.stages[stage]);
      for (int d = 0; d < s.c.dimension(); ++d) {
        if (support.motion->velocity[static_cast<std::size_t>(d)].empty()) continue;
        const boundary::MotionMeasures measures = measures_of(*support.motion, d, time > 0 ? time : infinity);
        const bool across = s.supports[k].space[d].length() < flat * s.mesh[d].length();
        const Real travel = std::abs(before[static_cast<std::size_t>(d)]) + measures.excursion;
        before[static_cast<std::size_t>(d)] += measures.residual;
        visit(MotionInStage{k, stage, d, measures, across, (support.absorbs ? with_echo : 1) * travel});
      }
    }
  }
}

std::string key_of(const Scene& s, const MotionInStage& motion)
{
  const std::string table = "support." + s.c.support[motion.support].first + ".motion",
                    axis = table + "." + boundary::motion_axes[motion.axis];
  return s.places.has(axis) ? axis : s.places.has(table + ".table") ? table + ".table" : table;
}

Real resolved_along(const Scene& s, const MotionInStage& motion)
{
  return motion.across ? s.resolved.pressure : s.resolved.shear;
}

Real frequency_of(const boundary::MotionMeasures& measures)
{
  return 1 / (2 * measures.half_wave);
}

}  // namespace

void is_the_motion_resolved(const Scene& s, Findings& found)
{
  constexpr Real still = 0.1;  // of the largest speed
  for_each_motion(s, [&](const MotionInStage& motion) {
    const boundary::MotionMeasures& m = motion.measures;
    const char* axis = boundary::motion_axes[motion.axis];
    const Real resolved = resolved_along(s, motion);
    if (m.half_wave == 0)
      found.warn(key_of(s, motion), fmt::format("starts with a velocity jump along {}: the boundary is at rest before, and no mesh "
                                                "resolves the wave front of a jump; make the first velocity 0",
                                                axis));
    else if (frequency_of(m) > resolved)
      found.warn(key_of(s, motion),
                 fmt::format("moves along {} from one peak to the next in {}, a frequency of {:.3g} Hz, and the cells resolve {:.3g} Hz "
                             "({:g} cells to a {} wave where they are largest or the soil is softest): higher frequencies arrive late and "
                             "leave noise; take cells that are {:.2g} times as small, or filter the record below {:.3g} Hz",
                             axis, words_of(m.half_wave, "s"), frequency_of(m), resolved, ResolvedWaves::cells,
                             motion.across ? "pressure" : "shear", resolved / frequency_of(m), rounded_down(resolved)));
    const Real end = s.c.support[motion.support].second.motion->times.back();
    const std::vector<std::string>& named = s.c.support[motion.support].second.motion->stages;
    const bool goes_on =
        motion.stage + 1 < s.c.stage.size() && std::find(named.begin(), named.end(), s.c.stage[motion.stage + 1].name) != named.end();
    if (std::abs(m.last) > still * m.speed && !(expected_time(s.stages[motion.stage]) > end) && motion.stage + 1 < s.c.stage.size() &&
        !goes_on)
      found.warn(
          key_of(s, motion),
          fmt::format("has {} along {} where stage \"{}\" ends, and the boundary stops abruptly: make the stage as long as the motion",
                      words_of(m.last, "m/s"), axis, s.c.stage[motion.stage].name));
    if (std::abs(m.last) > still * m.speed && expected_time(s.stages[motion.stage]) > end)
      found.warn(
          key_of(s, motion),
          fmt::format("ends at {} along {}, and the boundary keeps that velocity to the end of stage \"{}\": make the last velocity 0",
                      words_of(m.last, "m/s"), axis, s.c.stage[motion.stage].name));
  });
}

void does_the_soil_stay_at_what_moves(const Scene& s, Findings& found)
{
  constexpr Real little = 0.1, much = 0.5, touches = 1e-6;  // of a cell, and of the size of the mesh
  constexpr Real to_particles = 0.125;                      // of a cell: those of the outermost row are hardly farther from its face
  std::vector<std::pair<std::size_t, int>> asked;
  for_each_motion(s, [&](const MotionInStage& motion) {
    const bool again = std::find(asked.begin(), asked.end(), std::pair(motion.support, motion.axis)) != asked.end();
    const Span& mesh = s.mesh[motion.axis];
    Real room = infinity;
    for (const BodyScene& body : s.bodies)
      room = std::min({room, body.space[motion.axis].from - mesh.from, mesh.to - body.space[motion.axis].to});
    const bool at_end = room < touches * mesh.length();
    const Real cell = s.supports[motion.support].cell, part = motion.travel / cell;
    const char* axis = boundary::motion_axes[motion.axis];
    const std::string moves = fmt::format("moves the soil along {} by {} to either side, {:.2g} of a cell at the boundary ({})", axis,
                                          words_of(motion.travel, "m"), part, words_of(cell, "m"));
    std::string words;
    if (motion.across)
      words = moves +
              ", and the mesh stays where it is: the soil leaves the nodes that move it; take the drift out of the record, or larger "
              "cells there";
    else if (at_end)
      words = moves +
              fmt::format(", and the mesh, which stays where it is, ends along {} where the soil does: soil leaves it; take the drift out "
                          "of the record, larger cells, or a mesh that is longer than the soil",
                          axis);
    else if (motion.travel > room)
      words = fmt::format("moves the soil along {} by {} to either side, and the mesh ends {} beside it: make it longer", axis,
                          words_of(motion.travel, "m"), words_of(room, "m"));
    const bool refused = motion.across ? part > much : at_end ? part > to_particles : motion.travel > room;
    if (words.empty() || (!refused && (again || !(part > little)))) return;
    asked.emplace_back(motion.support, motion.axis);
    refused ? found.refuse(key_of(s, motion), words) : found.warn(key_of(s, motion), words);
  });
}

void do_boundaries_that_absorb_bear_what_comes(const Scene& s, Findings& found)
{
  constexpr Real pressure = 1e3;  // Pa
  const auto comes_later = [&](const boundary::TractionSettings& traction) {
    bool at_rest = false, later = false;
    for (const settings::StageSettings& stage : s.c.stage)
      (stage.kind == settings::StageKind::geostatic ? at_rest : later) |= acts_in(traction.stages, stage.name);
    return later && !at_rest;
  };
  std::vector<std::string> loads;
  for (const auto& [name, traction] : s.c.traction)
    if (comes_later(traction)) loads.push_back("traction." + name);
  for (const auto& [name, body] : s.c.body)
    for (const bodies::FillSettings& fill : body.fill) loads.push_back(fmt::format("fill \"{}\"", fill.name));
  if (loads.empty() || s.bodies.empty()) return;
  Real wave_speed = infinity, density = infinity;
  for (std::size_t b = 0; b < s.bodies.size(); ++b) {
    wave_speed = std::min(wave_speed, s.bodies[b].wave_speed);
    density = std::min(density, inertia_density(s.material_of(static_cast<Index>(b))));
  }
  for (std::size_t k = 0; k < s.c.support.size(); ++k) {
    const auto& [name, support] = s.c.support[k];
    const char* up = boundary::motion_axes[s.up];
    const bool along_up = std::find(support.fixed.begin(), support.fixed.end(), up) != support.fixed.end();
    constexpr Real flat = 1e-6;  // of the size of the mesh
    if (!support.absorbs || !along_up || !(s.supports[k].space[s.up].length() < flat * s.mesh[s.up].length())) continue;
    found.warn("support." + name + ".absorbs",
               fmt::format("absorbs along {}, and {} {} after the soil has come to rest: dashpots yield under a permanent load, and the "
                           "soil settles at {} for each kPa of it; use a support that holds in \"{}\", or end the run before that matters",
                           up, text_of_list(loads, ", "), loads.size() > 1 ? "come" : "comes",
                           words_of(pressure / (density * wave_speed), "m/s"), up));
  }
}

std::vector<std::string> motion_words(const Scene& s)
{
  std::vector<std::string> lines;
  for_each_motion(s, [&](const MotionInStage& motion) {
    const boundary::MotionMeasures& m = motion.measures;
    const auto& [name, support] = s.c.support[motion.support];
    lines.push_back(fmt::format("motion       \"{}\" in stage \"{}\": {} up to {} along {}, {} to either side, {} at the end; {:.3g} Hz, "
                                "the cells resolve {:.3g} Hz",
                                name, s.c.stage[motion.stage].name, support.absorbs ? "a wave comes in with" : "moves with",
                                words_of(m.speed, "m/s"), boundary::motion_axes[motion.axis], words_of(m.excursion, "m"),
                                words_of(m.residual, "m"), frequency_of(m), resolved_along(s, motion)));
  });
  return lines;
}

}  // namespace berm::sanity
