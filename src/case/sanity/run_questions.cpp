// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/sanity/sanity_test.cpp
#include "sanity/questions.hpp"

#include "problem/stages.hpp"
#include "run_folder/progress.hpp"
#include "sanity/sanity.hpp"

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
                                    run_folder::words_of_duration(seconds), steps, s.cost.time_step, s.cost.particles));
  if (steps < few)
    found.warn("stage", fmt::format("the whole run is {:.2g} steps of {:.3g} s: nothing is resolved in time; is the soil too soft, are "
                                    "cells too large, or are the stages too short?",
                                    steps, s.cost.time_step));
}

void does_it_fit_on_the_disk(const Scene& s, Findings& found)
{
  constexpr Real much = 20e9, part = 0.95;
  const Real bytes = disk_of(s);
  const char* key = s.c.output.frame_time ? "output.frame_time" : s.c.output.frame_travel ? "output.frame_travel" : "output";
  const std::string words = fmt::format("frames and history take about {} of the disk", words_of_bytes(bytes));
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
             fmt::format("makes {:.3g} rows of history in {}; curves want about a thousand: leave it out, or take {}", rows,
                         words_of(time, "s"), words_of(rounded_up(time / 1000), "s")));
}

void is_every_key_used(const Scene& s, Findings& found)
{
  const auto unused = [&](const std::string& key, const char* why) {
    if (s.places.has(key)) found.warn(key, fmt::format("is not used: {}; leave it out", why));
  };
  if (s.is_mpm()) {
    unused("fem", "method is \"mpm\"");
  } else {
    unused("mpm", "method is \"fem\"");
    unused("output.history_time", "finite elements write a row for each increment");
  }
  for (std::size_t k = 0; k < s.c.stage.size(); ++k)
    if (s.ways[k].rigid == none) unused(stage_key(k, "ramp"), "the stage drives nothing");
  if (s.gravity == 0) unused("gravity_ramp", "there is no gravity");
}

}  // namespace berm::sanity
