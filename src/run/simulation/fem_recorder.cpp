// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/run_fem_test.cpp
#include "simulation/fem_recorder.hpp"

#include "contact/contact_sums.hpp"
#include "problem/stages.hpp"

#include <algorithm>

namespace berm::simulation {
namespace {

/// The sum of the effective normal forces of the points of a contact, N/m (around an axis per radian).
Real effective_normal_force(const fem::FemModel& model, const fem::FemState& state, Index contact)
{
  Real sum = 0;
  for (std::size_t k = 0; k < model.contact.size(); ++k) {
    if (model.contact[k].contact != contact) continue;
    const Real pressure = state.contact[k].traction.dot(model.contact[k].normal);
    sum += model.contact[k].area * std::max(Real(0), pressure - fem::interface_at(model, k, state).pore_pressure);
  }
  return sum;
}

/// The water that flows from the nodes of a head into the soil, m2/s (around an axis per radian: m3/s): q_i = -integral of grad L_i . w.
Real inflow_of_head(const fem::FemModel& model, const fem::FemState& state, std::size_t head)
{
  Real sum = 0;
  const std::vector<Index>& unknowns = model.flow.at_head[head];
  for (Index cell = 0; cell < model.mesh.cell_count(); ++cell) {
    if (!model.flow.in(cell)) continue;
    const auto& nodes = model.mesh.nodes[cell];
    const auto is_at_head = [&](int k) { return std::binary_search(unknowns.begin(), unknowns.end(), model.flow.unknown[nodes[k]]); };
    if (!is_at_head(0) && !is_at_head(1) && !is_at_head(2)) continue;
    fem::VolumeStrain displacement;
    std::array<Real, 3> pressure;
    for (int k = 0; k < 12; ++k) displacement[k] = state.displacement[2 * nodes[k / 2] + k % 2];
    for (int k = 0; k < 3; ++k) pressure[k] = state.displacement[model.flow.unknown[nodes[k]]];
    for (int q = 0; q < fem::triangle_points; ++q) {
      const fem::ShapeAtPoint& shape = model.shape[cell][q];
      const fem::CornerShape corners = corner_shape(shape);
      const Vec<2> flux = water_flux(shape, model.flow.water[cell][q], displacement, pressure);
      for (int k = 0; k < 3; ++k)
        if (is_at_head(k)) sum -= shape.area * corners.gradient[k].dot(flux);
    }
  }
  return sum;
}

}  // namespace

Vec<2> FemRecorder::displacement_of(const fem::FemModel& model, const fem::FemState& state, Index node) const
{
  if (large_) return position_now(model, state, node) - state.place_at(fem::Moment::zero)[node];
  return {state.displacement[2 * node] - zero_[2 * node], state.displacement[2 * node + 1] - zero_[2 * node + 1]};
}

void FemRecorder::zero_displacements(const std::vector<Real>& displacement, const problem::State<2>& state)
{
  zero_rigid_bodies(state);
  if (!large_) zero_ = displacement;
}

void FemRecorder::observe_solution(const fem::FemState& state, const fem::IncrementEnd& end)
{
  row_("iterations", static_cast<Real>(end.iterations), run_folder::bare, "iterations of the increment");
  row_("unbalance", end.unbalance, run_folder::bare, "out-of-balance force divided by the contact forces");
  row_("overstress", state.overstress, run_folder::bare, "stress beyond the strength divided by the stress");
  row_("strength_lag", end.lag.part(), run_folder::bare, "missing dissipation divided by dissipation");
}

void FemRecorder::observe_shaft_of_main(const fem::FemModel& model, const fem::FemState& state)
{
  const Index main = model.model.main_rigid;
  if (model.model.mesh.metric != mesh::Metric::axisymmetric || !has_corners<2>(model.model.rigid_bodies[main].shape)) return;
  Real sum = 0;
  for (std::size_t k = 0; k < state.contact.size(); ++k)
    if (const fem::FemContactPoint& point = model.contact[k];
        model.model.contacts[point.contact].rigid == main && contact::is_shaft(point.normal[1]))
      sum -= point.area * state.contact[k].traction[1];
  row_("V_shaft", sum, run_folder::newtons<2>, "vertical reaction of sides parallel to the axis");
}

void FemRecorder::observe_tractions(const fem::FemModel& model, const fem::FemState& state)
{
  for (std::size_t k = 0; k < model.loads.size(); ++k) {
    LoadedArea<2> area;
    for (const fem::NodalLoad& load : model.loads[k]) area.add(load.force, displacement_of(model, state, load.node), load.area);
    row_.of(model.model.tractions[k].name);
    area.observe(row_, state.tractions[k], counted("mean displacement"));
  }
}

void FemRecorder::observe_watches(const fem::FemModel& model, const fem::FemState& state)
{
  for (const fem::FemWatch& watch : model.watches) {
    row_.of(watch.name);
    const settings::BodySoil& soil = model.soil_of(watch.cell);
    const int pressure_place = pore_pressure_index(soil.materials.front());
    Vec<2> displacement = Vec<2>::Zero();
    SymTensor<2> stress{};
    Real pressure = 0;
    for (int k = 0; k < 6; ++k) displacement += watch.of_nodes[k] * displacement_of(model, state, model.mesh.nodes[watch.cell][k]);
    for (int q = 0; q < fem::triangle_points; ++q) {
      const fem::SoilPoint& point = state.points[watch.cell][q];
      for (int c = 0; c < tensor_size<2>; ++c) stress.c[c] += watch.of_points[q] * point.stress.c[c];
      if (pressure_place != none) pressure += watch.of_points[q] * point.law_state[pressure_place];
    }
    row_("u", displacement, run_folder::metres, counted("displacement"));
    row_("s", stress, run_folder::pascals, "stress");
    observe_water(row_, soil, stress, pressure);
  }
}

void FemRecorder::add_row(const fem::FemModel& model, const fem::FemState& state, const fem::IncrementEnd& end,
                          const fem::Remeshings& remeshings, run_folder::HistoryFile& file)
{
  const problem::State<2>& now = state.state;
  const problem::Totals<2>& t = now.ledger.totals;
  const Index main = model.model.main_rigid;
  const auto of_rigid = [&](Index rigid) {
    const std::string& name = model.model.rigid_bodies[rigid].name;
    rigid == main ? row_.of_main(name) : row_.of(name);
  };
  const auto observe_turn = [&](Index rigid) {
    observe_rotation<2>(row_, now.rigid_bodies[rigid].torque, now.rigid_bodies[rigid].orientation.angle);
  };
  row_.count_parts(model.model.parts);
  row_.begin(now.time, model.model.stages[now.stage.index].name);
  if (main != none) of_rigid(main), observe_rigid(model.model, now, main, now.rigid_bodies[main].reaction);
  row_.of_main("run");
  observe_energies({.kinetic = {},
                    .damping = {},
                    .filter = {},
                    .internal = t.internal,
                    .friction = t.friction,
                    .external = t.external,
                    .error = t.internal + t.friction - t.external});
  if (model.weight > 0) observe_out_of_balance(row_, state.unbalanced / model.weight);
  if (main != none) of_rigid(main), observe_shaft_of_main(model, state), observe_overlap(), observe_turn(main);
  for (const problem::Contact& contact : model.model.contacts)
    if (const Index rigid = contact.rigid; rigid != main)
      of_rigid(rigid), observe_rigid(model.model, now, rigid, now.rigid_bodies[rigid].reaction), observe_turn(rigid);
  if (model.model.driven[now.stage.index] != none && end.iterations > 0) {
    largest_unbalance_ = std::max(largest_unbalance_, end.unbalance);
    largest_overstress_ = std::max(largest_overstress_, state.overstress);
    lag_.missing += std::abs(end.lag.missing);
    lag_.dissipated += end.lag.dissipated;
  }
  row_.of_main("run");
  observe_solution(state, end);
  if (model.settings.large_deformation)
    row_("remeshings", static_cast<Real>(remeshings.count), run_folder::bare, "meshes made since the start");
  if (model.flow.count > 0) observe_consolidation(row_, now.stage);
  observe_tractions(model, state);
  observe_watches(model, state);
  for (Index k = 0; k < model.contact_count(); ++k)
    if (const Index rigid = model.model.contacts[k].rigid; rubs_in_water(model.model, rigid))
      of_rigid(rigid), observe_effective_normal<2>(row_, effective_normal_force(model, state, k));
  for (std::size_t s = 0; s < state.support_forces.size(); ++s) {
    row_.of(model.model.conditions.reported[s]);
    observe_reaction<2>(row_, state.support_forces[s]);
  }
  boundary::for_each_of<boundary::Head<2>>(model.model.conditions, [&](std::size_t h, const auto& row, const auto& head) {
    row_.of(row.name);
    observe_head<2>(row_, acting_fraction(row, now.heads[h], now.time) * head.pressure, inflow_of_head(model, state, h));
  });
  observe_movement();
  file.add(row_);
}

void FemRecorder::archive(Archive& k)
{
  Recorder<2>::archive(k);
  k("largest_unbalance", largest_unbalance_);
  k("largest_overstress", largest_overstress_);
  static_assert(sizeof(lag_) == 2 * sizeof(Real));
  k("lag_missing", lag_.missing);
  k("lag_dissipated", lag_.dissipated);
  if (counts_from_stages() && !large_) k.fixed("zero_of_nodes", zero_);
}

}  // namespace berm::simulation
