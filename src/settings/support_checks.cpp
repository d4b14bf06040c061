// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/input/read_case_wrong_supports_test.cpp
#include "settings/support_checks.hpp"

#include "core/names.hpp"
#include "settings/drainage.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::settings {
namespace {

void check_stages_of(Describe& d, const Case& c, const std::string& key, const boundary::SupportSettings& support)
{
  std::vector<std::string> names;
  for (const StageSettings& stage : c.stage) names.push_back(stage.name);
  for (const std::string& name : support.motion->stages) {
    d.check(among(name, names), key, fmt::format("there is no stage \"{}\"", name), names);
    const auto stage = std::find_if(c.stage.begin(), c.stage.end(), [&](const StageSettings& s) { return s.name == name; });
    if (stage == c.stage.end()) continue;
    d.check(stage->kind != StageKind::geostatic, key,
            fmt::format("\"{}\" is a geostatic stage, in which the soil comes to rest: name the stages after it", name));
    d.check(stage->kind != StageKind::sweep, key,
            fmt::format("\"{}\" is a sweep, several drags, and the motion would start again with each: write the drags as separate stages",
                        name));
    d.check(acts_in(support.stages, name), key, fmt::format("the support does not act in \"{}\": add it to its stages", name));
  }
}

}  // namespace

bool act_together(const Case& c, const boundary::SupportSettings& a, const boundary::SupportSettings& b)
{
  return std::any_of(c.stage.begin(), c.stage.end(),
                     [&](const StageSettings& s) { return acts_in(a.stages, s.name) && acts_in(b.stages, s.name); });
}

void check_heads(Describe& d, const Case& c)
{
  for (const auto& [name, support] : c.support) {
    const std::string path = "support." + name;
    d.check(support.head || support.ramp == 0, path + ".ramp", "is for a head, and there is none");
    if (!support.head) continue;
    const std::string key = path + ".head";
    d.check(has_flowing_water(c), key, "no soil has water that flows: give it water.drainage = \"consolidation\", or leave this out");
    d.check(index_of(c.watch, name) == none, path,
            fmt::format("a [watch.{}] has this name, and columns of the history begin with it: give the support another", name));
    d.check(support.drained, key, "is of water that crosses the boundary: it needs drained = true");
    for (const auto& [other_name, other] : c.support)
      d.check(
          other.drained || other.boundary != support.boundary || !act_together(c, support, other), key,
          fmt::format("[support.{}] holds the same boundary in the same stage and lets no water through: give it drained = true, or other "
                      "stages",
                      other_name));
    for (std::size_t k = 0; k < c.stage.size(); ++k) {
      const bool acts = acts_in(support.stages, c.stage[k].name);
      d.check(!acts || !c.stage[k].until.consolidation || *support.head == 0, fmt::format("stage[{}].until.consolidation", k),
              fmt::format("the head of [support.{}] leaves a permanent excess pressure, so a degree of consolidation is never reached: end "
                          "the stage at a time",
                          name));
    }
  }
}

std::string fault_of_motion(const Case& c, const boundary::SupportSettings& support)
{
  const boundary::MotionSettings& motion = *support.motion;
  if (const std::string fault = fault_of_table(motion); !fault.empty()) return fault;
  for (std::size_t k = 0; k < motion.velocity.size(); ++k) {
    const std::string axis = boundary::motion_axes[k];
    if (motion.velocity[k].empty()) continue;
    if (static_cast<int>(k) >= c.dimension()) return axis + ": is not a direction in the plane: x and y are";
    if (!among(axis, support.fixed))
      return fmt::format("{0}: the support leaves the soil free along {0}, so it cannot move it: add \"{0}\" to `fixed`, or leave this out",
                         axis);
  }
  return "";
}

void check_motions(Describe& d, const Case& c)
{
  for (const auto& [name, support] : c.support) {
    if (!support.motion) continue;
    const boundary::MotionSettings& motion = *support.motion;
    const std::string path = "support." + name + ".motion";
    d.check(c.method == Method::mpm, path,
            "is for method = \"mpm\": finite elements have no inertia, and go from one equilibrium to the next; drive a rigid body, or "
            "load the "
            "soil by a traction");
    d.check(!c.mpm.active_distance, path, "cannot be combined with mpm.active_distance: motion of supports does not reach inactive soil");
    d.check(!c.safety, path, "cannot be combined with a trial of the factor of safety, in which the soil must come to rest");
    const auto free_of = [&, &name = name](bool taken, const char* table) {
      d.check(!taken, "support." + name,
              fmt::format("a [{}.{}] has this name, and columns of the history begin with it: give the support another", table, name));
    };
    free_of(index_of(c.body, name) != none, "body");
    free_of(index_of(c.watch, name) != none, "watch");
    free_of(index_of(c.rigid, name) != none, "rigid");
    check_stages_of(d, c, path + ".stages", support);
    const bool inline_rows = !motion.times.empty() || std::any_of(motion.velocity.begin(), motion.velocity.end(),
                                                                  [](const std::vector<Real>& column) { return !column.empty(); });
    d.check(motion.table.empty() || !inline_rows, path + ".times", "cannot be combined with table, which is a file of all of it");
    d.check(!motion.table.empty() || inline_rows, path, "needs a table, or times and velocities");
    if (!motion.table.empty() || !inline_rows) continue;
    const std::string fault = fault_of_motion(c, support);
    const std::size_t colon = fault.find(": ");
    d.check(fault.empty(), path + "." + fault.substr(0, colon), fault.empty() ? "" : fault.substr(colon + 2));
  }
}

}  // namespace berm::settings
