// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/sanity/sanity_test.cpp
#include "sanity/questions.hpp"

#include "io/duration_text.hpp"
#include "material/clay.hpp"
#include "sanity/sanity.hpp"
#include "settings/stage.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::sanity {

void does_it_take_days(const Scene& s, Findings& found)
{
  constexpr Real day = 24 * 3600, few = 20;
  const Real time = expected_time(s.stages);
  if (!s.is_mpm() || !(s.cost.time_step > 0) || time <= 0) return;
  const Real steps = time / s.cost.time_step, seconds = steps * s.cost.particles / s.cost.particle_steps_per_s;
  if (seconds > day)
    found.warn("stage", fmt::format("the run takes about {}: {:.2g} steps of {:.3g} s with {:.0f} particles; drive faster, travel less, or "
                                    "take larger cells, fewer particles or softer soil",
                                    io::duration_text(seconds), steps, s.cost.time_step, s.cost.particles));
  if (steps < few)
    found.warn("stage",
               fmt::format("the whole run is {:.2g} steps of {:.3g} s: too few to resolve anything in time; is the soil too soft, are "
                           "cells too large, or are the stages too short?",
                           steps, s.cost.time_step));
}

void does_it_fit_on_the_disk(const Scene& s, Findings& found)
{
  constexpr Real much = 20e9, part = 0.95;
  const Real bytes = disk_of(s);
  const char* key = s.c.output.frame_time ? "output.frame_time" : s.c.output.frame_travel ? "output.frame_travel" : "output";
  const std::string words = fmt::format("frames and history take about {} of disk space", words_of_bytes(bytes));
  if (bytes > part * s.cost.free_bytes)
    found.refuse(key, fmt::format("{}, and {} are free; write fewer frames, or choose another disk with -o", words,
                                  words_of_bytes(s.cost.free_bytes)));
  else if (bytes > much)
    found.warn(key, fmt::format("{}; write fewer frames", words));
}

void is_the_history_fine_enough(const Scene& s, Findings& found)
{
  const Real time = expected_time(s.c.stage);
  if (!s.is_mpm() || !s.c.output.history_time || time <= 0) return;
  constexpr Real few = 20, many = 1e6;
  const Real rows = time / *s.c.output.history_time;
  if (rows >= few && rows <= many) return;
  found.warn("output.history_time",
             fmt::format("makes {:.3g} rows of history in {}; a curve needs about a thousand: leave it out, or take {}", rows,
                         words_of(time, "s"), words_of(rounded_up(time / 1000), "s")));
}

namespace {

/// A key that may have no effect, and why.
struct Unused {
  std::string key;
  bool idle;  ///< it has none here, and is not what it is when left out
  std::string why;
};

/// Whether a clay has a number above what it is when left out, or the input says that it has not.
bool is_given(const Scene& s, const std::string& material, const char* key, bool above)
{
  return above || s.places.is_given(fmt::format("material.{}.{}", material, key));
}

void add_material_keys(const Scene& s, std::vector<Unused>& keys)
{
  for (const auto& [name, material] : s.c.material) {
    const auto* clay = material.get_if<material::Clay>();
    if (clay == nullptr) continue;
    const auto add = [&, &own = name](const char* key, bool idle, const char* why) {
      keys.push_back({fmt::format("material.{}.{}", own, key), idle, why});
    };
    const bool softens = is_given(s, name, "sensitivity", clay->sensitivity > 1);
    const bool is_rate_dependent = is_given(s, name, "rate_parameter", clay->rate_parameter > 0);
    constexpr const char* no_softening = "without a sensitivity above 1 the clay does not soften; give it (sensitivity = 1 says so)";
    constexpr const char* no_rate =
        "without a rate_parameter the strength of the clay does not depend on the rate; give it (rate_parameter = 0 says so)";
    add("ductility", !softens && clay->ductility > 0, no_softening);
    add("softening_length", !softens && clay->softening_length, no_softening);
    add("reference_rate", !is_rate_dependent && clay->reference_rate > 0, no_rate);
    add("rate_scale", !is_rate_dependent && clay->rate_scale != 1, no_rate);
    add("rate_smoothing", !is_rate_dependent && clay->rate_smoothing, no_rate);
  }
}

void add_stage_keys(const Scene& s, std::vector<Unused>& keys)
{
  const bool softens = std::any_of(s.c.material.begin(), s.c.material.end(), [&](const auto& named) {
    const auto* clay = named.second.template get_if<material::Clay>();
    return clay != nullptr && is_given(s, named.first, "sensitivity", clay->sensitivity > 1);
  });
  const settings::StageSettings as_left_out;
  for (std::size_t k = 0; k < s.c.stage.size(); ++k) {
    const settings::StageSettings& stage = s.c.stage[k];
    keys.push_back({stage_key(k, "ramp"), s.ways[k].rigid == none, "the stage drives nothing"});
    keys.push_back({stage_key(k, "strength_recovery"), stage.strength_recovery > 0 && !softens,
                    "no clay softens: that needs a sensitivity above 1; give it"});
    keys.push_back({stage_key(k, "equilibrium"),
                    stage.kind != settings::StageKind::geostatic && stage.equilibrium != as_left_out.equilibrium,
                    "it is for a geostatic stage, at whose end equilibrium is checked"});
  }
}

void add_body_keys(const Scene& s, std::vector<Unused>& keys)
{
  for (const auto& [name, body] : s.c.body)
    keys.push_back({fmt::format("body.{}.particles_per_cell", name), body.particles_per_cell > 0 && (body.block || body.disk),
                    "spacing gives the particles of a block or a disk"});
  for (Index r = 0; r < static_cast<Index>(s.c.rigid.size()); ++r) {
    const auto& [name, rigid] = s.c.rigid[r];
    const bool turns = rigid.rotation == bodies::Rotation::free ||
                       std::any_of(s.ways.begin(), s.ways.end(), [&](const Way& way) { return way.rigid == r && way.turns; });
    keys.push_back({fmt::format("rigid.{}.moment_of_inertia", name), rigid.moment_of_inertia && !turns,
                    "the body cannot rotate; give it rotation = \"free\" or a stage that rotates it"});
  }
  const contact::ContactSettings as_left_out;
  for (const auto& [name, contact] : s.c.contact)
    keys.push_back({fmt::format("contact.{}.gap_closing_steps", name),
                    contact.gap_closing_steps != as_left_out.gap_closing_steps &&
                        (contact.detection == contact::Detection::overlap || contact.detection == contact::Detection::distance),
                    "detection \"overlap\" and \"distance\" use no gap"});
}

}  // namespace

void is_every_key_used(const Scene& s, Findings& found)
{
  const bool for_both = s.c.fem.large_deformation;  // the methods that a case may compare
  std::vector<Unused> keys = {{"fem", s.is_mpm() && !for_both, "method is \"mpm\""},
                              {"mpm", !s.is_mpm() && !for_both, "method is \"fem\""},
                              {"output.history_time", !s.is_mpm() && !for_both, "finite elements write a row for each increment"},
                              {"gravity_ramp", s.gravity == 0, "there is no gravity"}};
  add_stage_keys(s, keys);
  add_material_keys(s, keys);
  add_body_keys(s, keys);
  for (const Unused& one : keys)
    if (one.idle && s.places.is_given(one.key)) {
      const bool says_what_else = one.why.find("; give") != std::string::npos;
      found.warn(one.key, fmt::format("is not used: {}{}", one.why, says_what_else ? ", or leave this out" : "; leave it out"));
    }
}

}  // namespace berm::sanity
