// SPDX-License-Identifier: BSD-3-Clause
#include "output/summary.hpp"

#include "output/whole_file.hpp"

#include <nlohmann/json.hpp>

namespace berm {

std::string Summary::json() const
{
  using Json = nlohmann::ordered_json;
  Json root;
  root["quantities"] = Json::object();
  for (const Quantity& q : quantities) root["quantities"][q.name] = {{"value", q.value}, {"unit", q.unit}};
  Json& t = root["timing"];
  t = {{"particle_steps_per_s", timing.particle_steps_per_s},
       {"wall_s", timing.wall_s},
       {"threads", timing.threads},
       {"particles", timing.particles},
       {"cells", timing.cells},
       {"steps", timing.steps},
       {"seconds_per_step", timing.wall_s / static_cast<Real>(timing.steps)},
       {"loops", Json::array()}};
  for (const Timing& loop : timing.loops) t["loops"].push_back({{"label", loop.label}, {"seconds", loop.seconds}, {"calls", loop.calls}});
  root["checks"] = Json::object();
  for (const auto& [name, check] : checks) std::visit([&](auto value) { root["checks"][name] = value; }, check);
  root["text"] = Json::object();
  for (const auto& [name, words] : text) root["text"][name] = words;
  return root.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

void Summary::write(const std::filesystem::path& path) const
{
  write_whole(path, json());
}

}  // namespace berm
