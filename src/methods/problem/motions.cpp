// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/input/read_case_wrong_supports_test.cpp
#include "problem/motions.hpp"

#include "core/names.hpp"
#include "os/error.hpp"
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

}  // namespace

template <int dim>
void add_motions(const settings::Case& c, Model<dim>& model)
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
                     : "is along the radius, and the boundary touches the axis: a base that moves laterally is not axisymmetric; move it "
                       "along y, or take geometry = \"plane_strain\" or \"space\""));
      }
    }
    const auto acts = [&](const settings::StageSettings& stage) {
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

template void add_motions(const settings::Case&, Model<2>&);
template void add_motions(const settings::Case&, Model<3>&);

}  // namespace berm::problem
