// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/physics/seepage.cpp
#include "problem/heads.hpp"

#include "core/names.hpp"
#include "os/error.hpp"
#include "problem/absorbing.hpp"
#include "problem/supports.hpp"
#include "settings/drainage.hpp"
#include "settings/support_checks.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::problem {
namespace {

/// The parts of a boundary that its nodes have, along the normals into the soil; zero where no soil is.
template <int dim>
NodeField<Vec<dim>> areas_into_soil(const settings::Case& c, const mesh::Mesh<dim>& mesh, const std::string& name,
                                    const boundary::SupportSettings& support)
{
  boundary::TractionSettings unit;
  unit.boundary = support.boundary;
  unit.pressure = 1;
  auto areas = NodeField<Vec<dim>>::zeros(mesh.node_count());
  try {
    for (const boundary::LoadedPoint<dim>& point : loaded_points(mesh, name, unit, bodies_of_regions(mesh, c))) {
      const mesh::Shape<dim> shape = mesh.shape(point.cell);
      for (int k = 0; k <= dim; ++k) {
        constexpr Real round_off = 1e-9;
        if (const Real weight = shape.value(k, point.x); weight > round_off) areas[mesh.nodes[point.cell][k]] += weight * point.force;
      }
    }
  } catch (const KeyError&) {
    throw KeyError(fmt::format("support.{}.head: no body that fills regions has soil at the boundary \"{}\"", name, support.boundary));
  }
  return areas;
}

}  // namespace

template <int dim>
void add_heads(const settings::Case& c, Model<dim>& model)
{
  constexpr Real along = 0.1;  // of a unit normal, in directions that are not held
  const mesh::Mesh<dim>& mesh = model.mesh;
  for (const auto& [name, support] : c.support) {
    if (!support.head || *support.head == 0) continue;
    const std::uint8_t directions = fixed_directions(support);
    const NodeField<Vec<dim>> areas = areas_into_soil(c, mesh, name, support);
    for (const auto& [other_name, other] : c.support) {
      if (&other == &support) break;
      if (!other.head || *other.head == 0 || other.boundary == support.boundary || !act_together(c, support, other)) continue;
      const NodeField<Vec<dim>> beside = areas_into_soil(c, mesh, other_name, other);
      for (Index node = 0; node < mesh.node_count(); ++node)
        if (std::abs(areas[node].dot(beside[node])) > along * areas[node].norm() * beside[node].norm())
          throw KeyError(fmt::format("support.{}.head: its boundary and that of [support.{}], which has a head in the same stage, are in "
                                     "line, and the nodes where they meet would have both: make one boundary of them",
                                     name, other_name));
    }
    boundary::Head<dim> head{material::unit_weight_of_water * *support.head};
    for (Index node = 0; node < mesh.node_count(); ++node) {
      if (!(areas[node].norm() > 0)) continue;
      const Vec<dim> normal = areas[node].normalized();
      Real free = 0;
      for (int d = 0; d < dim; ++d)
        if ((directions >> d & 1) == 0) free += normal[d] * normal[d];
      if (std::sqrt(free) > along)
        throw KeyError(
            fmt::format("support.{}.head: the water outside presses along the normal of the boundary \"{}\", along which the support "
                        "does not hold the soil: add that direction to `fixed`",
                        name, support.boundary));
      head.normals.push_back(normal);
    }
    const auto acts = [&](const settings::StageSettings& stage) { return acts_in(support.stages, stage.name); };
    add_condition<dim>(
        {.name = name, .kind = std::move(head), .directions = directions, .acts = by_stage(c.stage, acts), .ramp = support.ramp},
        [&](Index node) { return areas[node].norm() > 0; }, model);
  }
}

template <int dim>
std::vector<Vec<dim>> areas_of_head(const settings::Case& c, const Model<dim>& model, const boundary::NodalCondition<dim>& head)
{
  const NodeField<Vec<dim>> all = areas_into_soil(c, model.mesh, head.name, c.support[index_of(c.support, head.name)].second);
  std::vector<Vec<dim>> areas;
  for (const Index node : head.nodes) areas.push_back(all[node]);
  return areas;
}

#define BERM_INSTANTIATE(dim)                                                                                                              \
  template void add_heads(const settings::Case&, Model<dim>&);                                                                             \
  template std::vector<Vec<dim>> areas_of_head(const settings::Case&, const Model<dim>&, const boundary::NodalCondition<dim>&);
BERM_INSTANTIATE(2)
BERM_INSTANTIATE(3)
#undef BERM_INSTANTIATE

}  // namespace berm::problem
