// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "problem/model.hpp"

namespace berm::problem {

/// Adds a condition at the nodes for which keep(node) is true.
template <int dim, class Keep>
void add_condition(boundary::NodalCondition<dim> row, const Keep& keep, Model<dim>& model)
{
  select("list nodes of a condition", model.mesh.node_chunks, keep, row.nodes, row.chunks);
  model.conditions.rows.push_back(std::move(row));
}

/// By stage: whether acts(stage); true once where the case has no stages.
template <class Acts>
std::vector<char> by_stage(const std::vector<settings::StageSettings>& stages, const Acts& acts)
{
  std::vector<char> found;
  for (const settings::StageSettings& stage : stages) found.push_back(acts(stage) ? 1 : 0);
  if (found.empty()) found.push_back(1);
  return found;
}

/// What holds an axis or a plane of symmetry across it.
template <int dim>
boundary::NodalCondition<dim> held_across(int axis, const Model<dim>& model)
{
  return {.name = "",
          .kind = boundary::Hold{boundary::Flux::symmetric},
          .directions = static_cast<std::uint8_t>(1 << axis),
          .acts = by_stage(model.stages, [](const settings::StageSettings&) { return true; })};
}

/// 1 at the nodes of a boundary.
template <int dim>
NodeField<char> nodes_at(const mesh::Mesh<dim>& mesh, Index boundary)
{
  auto at_boundary = NodeField<char>::zeros(mesh.node_count());
  for (const Index node : mesh.boundary_nodes[boundary]) at_boundary[node] = 1;
  return at_boundary;
}

/// By stage: whether a support has this role.
std::vector<char> stages_with(settings::SupportRole role, Index support, const settings::SupportSets& sets);

/// The supports of the case, of a model that has its mesh: what they hold, and where they absorb.
template <int dim>
void add_supports(const settings::Case& c, const settings::SupportSets& sets, Model<dim>& model);

}  // namespace berm::problem
