// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/input/read_case_wrong_supports_test.cpp
#include "problem/motions.hpp"

#include "os/error.hpp"
#include "problem/names.hpp"
#include "problem/supports.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::problem {
namespace {

/// Whether two supports move the same boundary along an axis in some stage.
bool collide(const boundary::SupportSettings& a, const boundary::SupportSettings& b)
{
  if (a.boundary != b.boundary || !a.motion || !b.motion) return false;
  bool axis = false;
  for (std::size_t k = 0; k < a.motion->velocity.size(); ++k)
    axis = axis || (!a.motion->velocity[k].empty() && !b.motion->velocity[k].empty());
  return axis && std::any_of(a.motion->stages.begin(), a.motion->stages.end(), [&](const auto& s) { return among(s, b.motion->stages); });
}

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

template <int dim>
void add_motions(const Case& c, Model<dim>& model)
{
  const mesh::Mesh<dim>& mesh = model.mesh;
  for (std::size_t s = 0; s < c.support.size(); ++s) {
    const auto& [name, support] = c.support[s];
    if (!support.motion) continue;
    for (std::size_t other = 0; other < s; ++other)
      if (collide(c.support[other].second, support))
        throw KeyError(fmt::format(
            "support.{}.motion: [support.{}] moves the same boundary in the same direction in the same stage: leave one of them out", name,
            c.support[other].first));
    std::uint8_t directions = 0;
    for (int d = 0; d < dim; ++d)
      if (!support.motion->velocity[static_cast<std::size_t>(d)].empty()) directions |= static_cast<std::uint8_t>(1 << d);
    const Index boundary = fixed_boundary(mesh, name, support);
    for (const Index node : mesh.boundary_nodes[boundary]) {
      const bool on_axis = mesh.metric == mesh::Metric::axisymmetric && mesh.position[node][0] == 0;
      for (int d = 0; d < dim; ++d) {
        const bool on_plane = model.mirrored[d] && mesh.position[node][d] <= mesh.lower[d];
        if ((directions >> d & 1) == 0 || !(on_plane || (on_axis && d == 0))) continue;
        throw KeyError(fmt::format(
            "support.{}.motion.{}: {}", name, boundary::motion_axes[d],
            on_plane ? fmt::format("moves across the plane of symmetry: leave it out, or \"{}\" out of symmetry", boundary::motion_axes[d])
                     : "is along the radius, and the boundary touches the axis: a base that moves sideways is not axisymmetric; move it "
                       "along y, or take geometry = \"plane_strain\" or \"space\""));
      }
    }
    const auto acts = [&](const StageSettings& stage) {
      return among(stage.name, support.motion->stages) && acts_in(support.stages, stage.name);
    };
    const NodeField<char> at_boundary = nodes_at(mesh, boundary);
    add_condition<dim>(
        {.name = name,
         .kind = boundary::Motion{*support.motion, support.absorbs},
         .directions = directions,
         .acts = by_stage(c.stage, acts)},
        [&](Index node) { return at_boundary[node] != 0; }, model);
  }
}

template void add_motions(const Case&, Model<2>&);
template void add_motions(const Case&, Model<3>&);

}  // namespace berm::problem
