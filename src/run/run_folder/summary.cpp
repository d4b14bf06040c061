// SPDX-License-Identifier: BSD-3-Clause
#include "run_folder/summary.hpp"

#include "io/atomic_file.hpp"
#include "os/control_characters.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace berm::run_folder {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const RunTiming& t, const MpmCounts& counts)
{
  return {{"particle_steps_per_s", particle_steps_per_s(t, counts)},
          {"wall_s", t.wall_s},
          {"threads", t.threads},
          {"particles", counts.particles},
          {"cells", t.cells},
          {"steps", t.steps},
          {"seconds_per_step", t.wall_s / static_cast<Real>(t.steps)}};
}

Json json_of(const RunTiming& t, const FemCounts& counts)
{
  return {{"wall_s", t.wall_s}, {"threads", t.threads}, {"nodes", counts.nodes},
          {"cells", t.cells},   {"steps", t.steps},     {"iterations", counts.iterations}};
}

Json json_of(const TimeOfParts& parts)
{
  return {{"steps_s", parts.steps},
          {"rows_s", parts.rows},
          {"frames_s", parts.frames},
          {"checkpoints_s", parts.checkpoints},
          {"beside_s", parts.beside}};
}

/// Of both methods.
constexpr const char* check_names[] = {"finished",
                                       "energy_error",
                                       "friction_work_is_loss",
                                       "filter_over_work",
                                       "viscosity_over_work",
                                       "out_of_balance_after_geostatic",
                                       "beyond_force_limit",
                                       "momentum_error",
                                       "shaking_at_body",
                                       "energy_of_soil_that_came_to_rest",
                                       "mass_at_min_volume",
                                       "mass_at_max_volume",
                                       "mass_in_the_air",
                                       "cells_at_body_first_m",
                                       "cells_at_body_last_m",
                                       "cells_at_body_largest_m",
                                       "travel_on_coarse_cells",
                                       "largest_unbalance",
                                       "loose_increments",
                                       "largest_overstress",
                                       "strength_lag",
                                       "remeshings",
                                       "largest_change_by_remeshing",
                                       "mean_change_by_remeshing",
                                       "energy_lost_by_remeshing",
                                       "area_lost_by_remeshing",
                                       "folds_closed_by_remeshing",
                                       "soil_failed",
                                       "soil_at_rest",
                                       "soil_movement_m",
                                       "soil_movement_limit_m"};

}  // namespace

const char* word_of(QuantityKind kind)
{
  switch (kind) {
  case QuantityKind::answer:
    return "answer";
  case QuantityKind::ratio:
    return "ratio";
  case QuantityKind::quality:
    return "quality";
  case QuantityKind::prescribed:
    return "prescribed";
  }
  return "";
}

Real particle_steps_per_s(const RunTiming& timing, const MpmCounts& counts)
{
  return static_cast<Real>(counts.particles * timing.steps) / timing.wall_s;
}

const char* unit_of_timing(const std::string& name)
{
  if (name.ends_with("_s") && !name.ends_with("_per_s")) return "s";
  if (name == "seconds_per_step") return "s";
  return name == "particle_steps_per_s" ? "1/s" : "1";
}

std::vector<std::string> check_and_timing_names()
{
  RunTiming any;
  any.wall_s = 1, any.steps = 1;
  std::vector<std::string> names(std::begin(check_names), std::end(check_names));
  for (const Json& timing : {json_of(any, MpmCounts{}), json_of(any, FemCounts{}), json_of(any.parts)})
    for (const auto& [name, value] : timing.items()) names.push_back(name);
  names.insert(names.end(), {"ranks", "memory_bytes", "processors_s"});
  return names;
}

std::string Summary::json() const
{
  Json root;
  root["quantities"] = Json::object();
  for (const Quantity& q : quantities) {
    Json& entry = root["quantities"][q.name] = {{"value", q.value}, {"unit", q.unit}};
    if (!q.meaning.empty()) entry["meaning"] = q.meaning;
    entry["kind"] = word_of(q.kind);
    if (!q.of.empty()) entry["of"] = q.of;
  }
  if (const std::optional<Quantity>& m = force_measure)
    root["force_measure"] = {{"name", m->name}, {"value", m->value}, {"unit", m->unit}, {"meaning", m->meaning}};
  Json& t = root["timing"];
  t = std::visit([&](const auto& counts) { return json_of(timing, counts); }, timing.counts);
  t["processors_s"] = timing.processors_s;
  t.update(json_of(timing.parts));
  t["ranks"] = timing.memory.size();
  if (const Real most = std::ranges::max(timing.memory); !std::isnan(most)) t["memory_bytes"] = most;
  t["loops"] = Json::array();
  for (const Timing& loop : timing.loops) t["loops"].push_back({{"label", loop.label}, {"seconds", loop.seconds}, {"calls", loop.calls}});
  root["checks"] = Json::object();
  for (const auto& [name, check] : checks) std::visit([&, &key = name](auto value) { root["checks"][key] = value; }, check);
  root["text"] = Json::object();
  for (const auto& [name, words] : text) root["text"][name] = one_line(words);
  for (const auto& [name, list] : {std::pair{"warnings", &warnings}, {"invalid", &invalid}}) {
    root[name] = Json::array();
    for (const std::string& words : *list) root[name].push_back(one_line(words));
  }
  return root.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

void Summary::write(const std::filesystem::path& path) const
{
  io::write_atomically(path, json());
}

}  // namespace berm::run_folder
