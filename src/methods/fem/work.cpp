// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/fem/assembly_test.cpp
#include "fem/assembly.hpp"
#include "fem/moved_cell.hpp"

namespace berm::fem {

void Assembly::count_work(FemState& state, const std::vector<Real>& change, const FemLoads& loads) const
{
  problem::Totals<2>& totals = state.state.ledger.totals;
  const Vec<2> gravity = (state.gravity + loads.gravity) / 2;
  const Real initial_imbalance_factor = (state.initial_imbalance_factor + loads.initial_imbalance_factor) / 2;
  for (const CellWork& cell : cells_) totals.internal += cell.work;
  for (Index cell = 0; cell < cells_.size(); ++cell) {
    const std::optional<MovedCell> moved = moved_cell(state, change, cell);
    for (int q = 0; q < triangle_points; ++q) {
      const ShapeAtPoint& shape = moved ? moved->middle[q] : model_.shape[cell][q];
      const Real density = model_.density[cell][q];
      for (int k = 0; k < 6; ++k)
        for (int d = 0; d < 2; ++d)
          totals.external += shape.area * shape.value[k] * density * gravity[d] * change[2 * model_.mesh.nodes[cell][k] + d];
    }
  }
  for (std::size_t t = 0; t < loads.tractions.size(); ++t)
    for (const NodalLoad& load : model_.loads[t])
      for (int d = 0; d < 2; ++d)
        totals.external += (state.tractions[t] + loads.tractions[t]) / 2 * load.force[d] * change[2 * load.node + d];
  for (std::size_t k = 0; k < change.size(); ++k) totals.external += initial_imbalance_factor * initial_imbalance_[k] * change[k];
  for (Index contact = 0; contact < model_.contact_count(); ++contact) {
    const bodies::RigidState<2>& rigid = state.state.rigid_bodies[model_.model.contacts[contact].rigid];
    const Index first = model_.rigid_unknown(contact);
    const Vec<2> moved(change[first], change[first + 1]), force = -(rigid.reaction + reaction(contact)) / 2;
    totals.external += force.dot(moved) - (rigid.torque + torque(contact)) / 2 * change[first + 2];
  }
  for (std::size_t k = 0; k < contact_.size(); ++k) {
    const FemContactPoint& point = model_.contact[k];
    const Index first = model_.rigid_unknown(point.contact);
    const Vec<2> moved(change[first], change[first + 1]);
    const Vec<2> relative =
        Vec<2>(change[2 * point.node], change[2 * point.node + 1]) - moved - change[first + 2] * Vec<2>(-point.arm[1], point.arm[0]);
    totals.friction -= point.area * (state.contact[k].traction + contact_[k].traction).dot(relative) / 2;
  }
}

Real Assembly::energy_error(FemState& begin, const std::vector<Real>& change, const FemLoads& loads) const
{
  constexpr Real little_energy = 1e-12;  // of a strain whose work has no error that matters
  const Real size = std::pow(model_.width, model_.model.mesh.metric == mesh::Metric::axisymmetric ? 4 : 3);
  problem::Totals<2>& totals = begin.state.ledger.totals;
  const problem::Totals<2> before = totals;
  count_work(begin, change, loads);
  const Real internal = totals.internal - before.internal, friction = totals.friction - before.friction,
             external = totals.external - before.external;
  totals = before;
  return std::abs(internal + friction - external) /
         (std::abs(internal) + std::abs(external) + model_.settings.remeshing_travel * model_.width * contact_force_ +
          little_energy * model_.contact_stiffness() * size);
}

Real Assembly::work_of_imbalance(const FemState& begin, const std::vector<Real>& change, const FemLoads& loads) const
{
  Real work = 0;
  for (std::size_t k = 0; k < change.size(); ++k) work += initial_imbalance_[k] * change[k];
  return (begin.initial_imbalance_factor + loads.initial_imbalance_factor) / 2 * work;
}

}  // namespace berm::fem
