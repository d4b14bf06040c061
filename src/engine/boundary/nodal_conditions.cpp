// SPDX-License-Identifier: BSD-3-Clause
#include "boundary/nodal_conditions.hpp"

#include <algorithm>

namespace berm::boundary {
namespace {

template <int dim>
bool moves_nodes(const NodalCondition<dim>& row)
{
  return std::visit(
      [](const auto& kind) {
        if constexpr (requires { kind.incoming; })
          return !kind.incoming;
        else
          return PrescribesVelocity<decltype(kind)>;
      },
      row.kind);
}

/// The directions in which no water crosses each node.
template <int dim>
NodeField<std::uint8_t> closed_directions(Index nodes, std::size_t stage, const std::vector<NodalCondition<dim>>& rows)
{
  auto closed = NodeField<std::uint8_t>::zeros(nodes);
  for (const Flux flux : {Flux::symmetric, Flux::open, Flux::closed})
    for (const NodalCondition<dim>& row : rows)
      if (const Hold* hold = std::get_if<Hold>(&row.kind); hold != nullptr && hold->flux == flux && row.acts[stage])
        for (const Index node : row.nodes)
          closed[node] = static_cast<std::uint8_t>(flux == Flux::open ? closed[node] & ~row.directions : closed[node] | row.directions);
  return closed;
}

template <int dim>
NodeTable<dim> table_of(Index nodes, bool water_flows, std::size_t stage, const NodalConditions<dim>& conditions)
{
  const std::vector<NodalCondition<dim>>& rows = conditions.rows;
  Holders<dim> no_row;
  no_row.fill(none);
  NodeTable<dim> table;
  table.held = NodeField<std::uint8_t>::zeros(nodes);
  if (water_flows) table.closed = closed_directions(nodes, stage, rows);
  if (!conditions.reported.empty()) table.reactions.assign(nodes, no_row);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (!rows[k].acts[stage]) continue;
    const bool holds = std::holds_alternative<Hold>(rows[k].kind), moves = moves_nodes(rows[k]);
    if (moves && table.moved.empty()) table.moved.assign(nodes, no_row);
    for (const Index node : rows[k].nodes) {
      if (holds) table.held[node] |= rows[k].directions;
      if (moves) add_holder<dim>(table.moved[node], static_cast<Index>(k), rows[k].directions);
    }
  }
  for (Index reaction = 0; reaction < static_cast<Index>(conditions.reported.size()); ++reaction)
    for (const NodalCondition<dim>& row : rows)
      if (row.reaction == reaction && row.acts[stage])
        for (const Index node : row.nodes) add_holder<dim>(table.reactions[node], reaction, row.directions);
  return table;
}

}  // namespace

template <int dim>
void make_tables(Index nodes, std::size_t stages, bool water_flows, NodalConditions<dim>& conditions)
{
  const std::vector<NodalCondition<dim>>& rows = conditions.rows;
  const auto acts_alike = [&](std::size_t a, std::size_t b) {
    return std::all_of(rows.begin(), rows.end(), [&](const NodalCondition<dim>& row) {
      return std::holds_alternative<Head<dim>>(row.kind) || row.acts[a] == row.acts[b];
    });
  };
  conditions.tables.clear();
  conditions.table_of_stage.clear();
  for (std::size_t stage = 0; stage < stages; ++stage) {
    std::size_t same = 0;
    while (same < stage && !acts_alike(same, stage)) ++same;
    conditions.table_of_stage.push_back(same < stage ? conditions.table_of_stage[same] : static_cast<Index>(conditions.tables.size()));
    if (same == stage) conditions.tables.push_back(table_of(nodes, water_flows, stage, conditions));
  }
}

template void make_tables(Index, std::size_t, bool, NodalConditions<2>&);
template void make_tables(Index, std::size_t, bool, NodalConditions<3>&);

}  // namespace berm::boundary
