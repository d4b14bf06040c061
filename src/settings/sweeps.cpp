// SPDX-License-Identifier: BSD-3-Clause
#include "settings/sweeps.hpp"

#include "os/error.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::settings {
namespace {

std::vector<StageSettings> drags_of(const StageSettings& sweep)
{
  std::vector<StageSettings> drags;
  StageSettings drag = sweep;
  drag.kind = StageKind::drag;
  drag.amplitude.reset();
  drag.sweeps = 0;
  drag.pause = 0;
  drag.strength_recovery = 0;
  for (int k = 1; k <= sweep.sweeps; ++k) {
    drag.name = fmt::format("{}_{}", sweep.name, k);
    drag.velocity = k % 2 == 1 ? *sweep.velocity : -*sweep.velocity;
    drag.until = {};
    drag.until.displacement = sweep.amplitude;
    drags.push_back(drag);
    drag.zero_displacements = false;  // but for the first
    if (sweep.pause == 0 || k == sweep.sweeps) continue;
    drag.name += "_pause";
    drag.velocity = 0;
    drag.until = {};
    drag.until.time = sweep.pause;
    drag.strength_recovery = sweep.strength_recovery;
    drags.push_back(drag);
    drag.strength_recovery = 0;
  }
  return drags;
}

/// Of a list of stages: those stand for that one.
void rename(std::vector<std::string>& names, const std::string& stage, const std::vector<std::string>& stand_for_it)
{
  const auto found = std::find(names.begin(), names.end(), stage);
  if (found == names.end()) return;
  names.insert(names.erase(found), stand_for_it.begin(), stand_for_it.end());
}

void rename_in_loads(Case& c, const std::string& stage, const std::vector<std::string>& stand_for_it)
{
  for (auto& [name, support] : c.support) {
    rename(support.stages, stage, stand_for_it);
    if (support.motion) rename(support.motion->stages, stage, stand_for_it);
  }
  for (auto& [name, traction] : c.traction) rename(traction.stages, stage, stand_for_it);
}

/// The first of the stages that the stage of this number repeats.
std::size_t first_of_repeat(const Case& c, std::size_t last)
{
  const StageSettings& stage = c.stage[last];
  if (stage.repeat_from.empty()) return last;
  for (std::size_t k = 0; k <= last; ++k)
    if (c.stage[k].name == stage.repeat_from) return k;
  throw KeyError(fmt::format("stage[{}].repeat_from: \"{}\" is not a stage before it", last, stage.repeat_from));
}

}  // namespace

std::vector<std::size_t> expand_sweeps(Case& c)
{
  std::vector<StageSettings> all;
  std::vector<std::size_t> origins;
  for (std::size_t k = 0; k < c.stage.size(); ++k) {
    const StageSettings& stage = c.stage[k];
    if (stage.kind != StageKind::sweep) {
      all.push_back(stage);
      origins.push_back(k);
      continue;
    }
    const std::vector<StageSettings> drags = drags_of(stage);
    for (const StageSettings& drag : drags) {
      if (drag.name.size() > max_stage_name)
        throw KeyError(fmt::format("stage[{}].name: its drags would be called {}, of more than {} bytes", k, drag.name, max_stage_name));
      for (const StageSettings& other : c.stage)
        if (other.name == drag.name)
          throw KeyError(fmt::format("stage[{}].name: the drags of \"{}\" are called {}, as another stage is: give one another name", k,
                                     stage.name, drag.name));
    }
    std::vector<std::string> names;
    for (const StageSettings& drag : drags) names.push_back(drag.name);
    rename_in_loads(c, stage.name, names);
    all.insert(all.end(), drags.begin(), drags.end());
    origins.insert(origins.end(), drags.size(), k);
  }
  c.stage = std::move(all);
  return origins;
}

std::vector<std::size_t> expand_repeats(Case& c)
{
  std::vector<StageSettings> all;
  std::vector<std::size_t> origins;
  std::size_t free_from = 0;  // not yet in a repetition
  for (std::size_t last = 0; last < c.stage.size(); ++last) {
    const StageSettings& stage = c.stage[last];
    all.push_back(stage);
    origins.push_back(last);
    if (stage.repeat == 1) {
      if (!stage.repeat_from.empty()) throw KeyError(fmt::format("stage[{}].repeat_from: repeats nothing without `repeat`", last));
      continue;
    }
    const std::size_t first = first_of_repeat(c, last);
    if (first < free_from) throw KeyError(fmt::format("stage[{}].repeat_from: \"{}\" is repeated already", last, c.stage[first].name));
    free_from = last + 1;
    all.back().repeat = 1;
    all.back().repeat_from.clear();
    for (std::size_t k = first; k <= last; ++k)
      if (c.stage[k].kind == StageKind::sweep)
        throw KeyError(
            fmt::format("stage[{}].repeat: \"{}\" is a sweep, which has its number of drags: give it more", last, c.stage[k].name));
    const std::vector<StageSettings> once(all.end() - static_cast<std::ptrdiff_t>(last + 1 - first), all.end());
    for (int time = 2; time <= stage.repeat; ++time)
      for (std::size_t k = first; k <= last; ++k) {
        all.push_back(once[k - first]);
        all.back().name = fmt::format("{}_{}", once[k - first].name, time);
        origins.push_back(k);
        if (all.back().name.size() > max_stage_name)
          throw KeyError(
              fmt::format("stage[{}].name: its repetition would be called {}, of more than {} bytes", k, all.back().name, max_stage_name));
        for (const StageSettings& other : c.stage)
          if (other.name == all.back().name)
            throw KeyError(fmt::format("stage[{}].name: its repetition would be called {}, as another stage is: give one another name", k,
                                       all.back().name));
      }
    for (const StageSettings& repeated : once) {
      std::vector<std::string> names = {repeated.name};
      for (int time = 2; time <= stage.repeat; ++time) names.push_back(fmt::format("{}_{}", repeated.name, time));
      rename_in_loads(c, repeated.name, names);
    }
  }
  c.stage = std::move(all);
  return origins;
}

}  // namespace berm::settings
