// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/problem/earthworks_test.cpp
#include "settings/earthwork_checks.hpp"

#include "core/names.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::settings {
namespace {

void check_earthwork(Describe& d, const Case& c, const std::string& path, const bodies::EarthworkSettings& work)
{
  std::vector<std::string> stages;
  for (const StageSettings& stage : c.stage) stages.push_back(stage.name);
  const auto stage = std::find(stages.begin(), stages.end(), work.stage);
  d.check(stage != stages.end(), path + ".stage", fmt::format("there is no stage \"{}\"", work.stage), stages);
  bodies::check(d, path, work.area, c.dimension());
  d.check(
      c.method == Method::mpm, path,
      "finite elements have no stages with fills or excavations: take method = \"mpm\", or make the fill a region of the mesh, or a layer");
  d.check(work.z_range.empty() || c.dimension() == 3, path + ".z_range", "is for space");
  d.check(work.z_range.empty() || (work.z_range.size() == 2 && work.z_range[0] < work.z_range[1]), path + ".z_range",
          "needs 2 numbers, the smaller one first");
  d.check(work.duration == 0 || work.lifts > 1, path + ".duration", "spreads lifts over time, and there is one: give it lifts");
  if (stage != stages.end()) {
    const Until& until = c.stage[static_cast<std::size_t>(stage - stages.begin())].until;
    d.check(!until.time || work.duration <= *until.time, path + ".duration",
            fmt::format("is longer than stage \"{}\", {:.4g} s", work.stage, until.time.value_or(0)));
  }
}

}  // namespace

void check_earthworks(Describe& d, const Case& c)
{
  std::vector<std::string> names;
  const auto check_name_of = [&](const std::string& path, const std::string& name) {
    d.check(!name.empty() && name.find_first_of(",\".") == std::string::npos, path + ".name",
            "must be a word without comma, dot or quotes");
    d.check(!among(name, names), path + ".name", fmt::format("another fill or excavation has the name \"{}\"", name));
    names.push_back(name);
    const bool taken = index_of(c.body, name) != none || index_of(c.rigid, name) != none || index_of(c.contact, name) != none ||
                       index_of(c.support, name) != none || index_of(c.traction, name) != none || index_of(c.watch, name) != none;
    d.check(!taken, path + ".name", "something else of the case has this name, and columns of the history begin with it");
  };
  for (const auto& [name, body] : c.body) {
    const std::string path = "body." + name;
    for (std::size_t k = 0; k < body.excavation.size(); ++k) {
      check_earthwork(d, c, fmt::format("{}.excavation[{}]", path, k), body.excavation[k]);
      check_name_of(fmt::format("{}.excavation[{}]", path, k), body.excavation[k].name);
    }
    for (std::size_t k = 0; k < body.fill.size(); ++k) {
      const std::string item = fmt::format("{}.fill[{}]", path, k);
      check_earthwork(d, c, item, body.fill[k]);
      check_name_of(item, body.fill[k].name);
      const bool upright = c.gravity.size() < 2 ||
                           (c.gravity[1] <= 0 &&
                            std::all_of(c.gravity.begin(), c.gravity.end(), [&](const Real& g) { return &g == &c.gravity[1] || g == 0; }));
      d.check(!body.fill[k].k0 || upright, item + ".k0", "the stress of a fill at rest is for gravity along -y");
    }
    d.check(!c.mpm.active_distance || (body.fill.empty() && body.excavation.empty()), "mpm.active_distance",
            fmt::format("cannot be combined with the fills and excavations of [body.{}]: inactive soil would not carry their load", name));
  }
}

}  // namespace berm::settings
