// SPDX-License-Identifier: BSD-3-Clause
#include "problem/sweeps.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::problem {
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

void rename(std::vector<std::string>& names, const std::string& sweep, const std::vector<StageSettings>& drags)
{
  const auto found = std::find(names.begin(), names.end(), sweep);
  if (found == names.end()) return;
  const auto at = names.erase(found);
  std::vector<std::string> of_drags;
  for (const StageSettings& drag : drags) of_drags.push_back(drag.name);
  names.insert(at, of_drags.begin(), of_drags.end());
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
    for (auto& [name, support] : c.support) rename(support.stages, stage.name, drags);
    for (auto& [name, traction] : c.traction) rename(traction.stages, stage.name, drags);
    all.insert(all.end(), drags.begin(), drags.end());
    origins.insert(origins.end(), drags.size(), k);
  }
  c.stage = std::move(all);
  return origins;
}

}  // namespace berm::problem
