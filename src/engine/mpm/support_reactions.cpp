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
Vec<dim> force_of(const problem::Model<dim>& model, const BodyGrid<dim>& grid, Index support)
{
  const problem::Support& its = model.supports[support];
  const NodeField<boundary::Holders<dim>>& holders = model.holders[grid.fixed];
  const auto at = [&](Index k) {
    const Index node = its.nodes[k];
    Force<dim> force;
    if (!(grid.mass[node] > 0)) return force;
    for (int d = 0; d < dim; ++d)
      if (holders[node][d] == support) force.sum[d] = grid.support_force[node][d];
    return force;
  };
  return sum_of<Force<dim>>("reactions of supports", its.chunks, at).sum;
}

/// All threads and ranks have all contact points: one by one.
template <int dim>
void add_contact(const contact::ContactPoints<dim>& points, const NodeField<boundary::Holders<dim>>& holders, problem::State<dim>& state)
{
  for (const contact::ContactPoint<dim>& point : points.list)
    for (int n = 0; n < point.node_count; ++n)
      for (int d = 0; d < dim; ++d)
        if (const Index support = holders[point.nodes[n]][d]; support != none)
          state.support_impulses[support][d] -= point.weights[n] * point.impulse[d];
}

}  // namespace

template <int dim>
void react_at_supports(const problem::Model<dim>& model, problem::State<dim>& state, const Workspace<dim>& workspace)
{
  if (model.supports.empty()) return;
  for (Index s = 0; s < static_cast<Index>(model.supports.size()); ++s)
    for (const BodyGrid<dim>& grid : workspace.grids) state.support_impulses[s] += state.dt * force_of(model, grid, s);
  for (std::size_t k = 0; k < model.contacts.size(); ++k) {
    const problem::Contact& contact = model.contacts[k];
    if (contact.other_body != none) continue;  // supports take from one body what they give to the other
    add_contact<dim>(workspace.contact_points[k], model.holders[workspace.grids[contact.body].fixed], state);
  }
}

template void react_at_supports(const problem::Model<2>&, problem::State<2>&, const Workspace<2>&);
template void react_at_supports(const problem::Model<3>&, problem::State<3>&, const Workspace<3>&);

}  // namespace berm::mpm
