// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/problem/build_test.cpp
#include "problem/supports.hpp"

namespace berm::problem {

std::vector<char> stages_with(settings::SupportRole role, Index support, const settings::SupportSets& sets)
{
  std::vector<char> acts;
  for (const Index set : sets.of_stage) acts.push_back(sets.roles[set][support] == role);
  if (acts.empty()) acts.push_back(sets.roles[0][support] == role);
  return acts;
}

template <int dim>
void add_supports(const settings::Case& c, const settings::SupportSets& sets, Model<dim>& model)
{
  using boundary::Flux;
  for (Index s = 0; s < static_cast<Index>(c.support.size()); ++s) {
    const auto& [name, support] = c.support[s];
    const NodeField<char> at_boundary = nodes_at(model.mesh, fixed_boundary(model.mesh, name, support));
    boundary::NodalCondition<dim> row{.name = name,
                                      .kind = boundary::Hold{support.drained ? Flux::open : Flux::closed},
                                      .directions = fixed_directions(support),
                                      .acts = stages_with(settings::SupportRole::holds, s, sets)};
    if (c.output.support_reactions) {
      row.reaction = s;
      model.conditions.reported.push_back(name);
    }
    const auto keep = [&](Index node) { return at_boundary[node] != 0; };
    add_condition(row, keep, model);
    if (!support.absorbs) continue;
    row.kind = boundary::Absorb{};
    row.acts = stages_with(settings::SupportRole::absorbs, s, sets);
    add_condition(row, keep, model);
  }
}

template void add_supports(const settings::Case&, const settings::SupportSets&, Model<2>&);
template void add_supports(const settings::Case&, const settings::SupportSets&, Model<3>&);

}  // namespace berm::problem
