// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/physics/support_reactions.cpp
#include "mpm/support_reactions.hpp"

namespace berm::mpm {
namespace {

template <int dim>
struct Force {
  Vec<dim> sum = Vec<dim>::Zero();

  Force& operator+=(const Force& other)
  {
    sum += other.sum;
    return *this;
  }
};

/// The force of a support on one body before contact, N.
template <int dim>
Vec<dim> force_of(const problem::Model<dim>& model, const BodyGrid<dim>& grid, const boundary::NodalCondition<dim>& support)
{
  const NodeField<boundary::Holders<dim>>& holders = grid.conditions(model).reactions;
  const auto at = [&](Index k) {
    const Index node = support.nodes[k];
    Force<dim> force;
    if (!(grid.mass[node] > 0)) return force;
    for (int d = 0; d < dim; ++d)
      if (holders[node][d] == support.reaction) force.sum[d] = grid.support_force[node][d];
    return force;
  };
  return sum_of<Force<dim>>("reactions of supports", support.chunks, at).sum;
}

/// All threads and ranks have all contact points: one by one.
template <int dim>
void add_contact(const contact::ContactPoints<dim>& points, const NodeField<boundary::Holders<dim>>& holders, problem::State<dim>& state)
{
  for (const contact::ContactPoint<dim>& point : points.list)
    for (int n = 0; n < point.node_count; ++n)
      for (int d = 0; d < dim; ++d)
        if (const Index support = holders[point.nodes[n]][d]; support != none)
          state.ledger.support_impulses[support][d] -= point.weights[n] * point.impulse[d];
}

}  // namespace

template <int dim>
void react_at_supports(const problem::Model<dim>& model, problem::State<dim>& state, const Workspace<dim>& workspace)
{
  if (model.conditions.reported.empty()) return;
  for (const boundary::NodalCondition<dim>& row : model.conditions.rows) {
    if (row.reaction == none || !row.acts[static_cast<std::size_t>(state.stage.index)]) continue;
    for (const BodyGrid<dim>& grid : workspace.grids) state.ledger.support_impulses[row.reaction] += state.dt * force_of(model, grid, row);
  }
  for (std::size_t k = 0; k < model.contacts.size(); ++k) {
    const problem::Contact& contact = model.contacts[k];
    if (contact.other_body != none) continue;  // supports take from one body what they give to the other
    add_contact<dim>(workspace.contact_points[k], workspace.grids[contact.body].conditions(model).reactions, state);
  }
}

template void react_at_supports(const problem::Model<2>&, problem::State<2>&, const Workspace<2>&);
template void react_at_supports(const problem::Model<3>&, problem::State<3>&, const Workspace<3>&);

}  // namespace berm::mpm
