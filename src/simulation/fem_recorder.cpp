// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/run_fem_test.cpp
#include "simulation/fem_recorder.hpp"

#include "simulation/observe.hpp"

namespace berm::simulation {
namespace {

Vec<2> displacement_of(const fem::FemState& state, Index node)
{
  return {state.displacement[2 * node], state.displacement[2 * node + 1]};
}

}  // namespace

void FemRecorder::observe_rigid(const fem::FemModel& model, const fem::FemState& state)
{
  const bodies::RigidState<2>& rigid = state.state.rigid_bodies[model.rigid];
  const RigidMotion motion = motion_of(model.model, state.state, model.rigid, rigid.reaction);
  horizontal_ = motion.H;
  vertical_ = motion.V;
  row_.of_main(model.model.rigid_bodies[model.rigid].name);
  observe<2>(row_, motion);
}

void FemRecorder::observe_solution(const fem::FemState& state, const fem::IncrementEnd& end)
{
  row_("iterations", static_cast<Real>(end.iterations), run_folder::bare, "iterations of the increment");
  row_("unbalance", end.unbalance, run_folder::bare, "force out of balance over the contact forces");
  row_("overstress", state.overstress, run_folder::bare, "stress beyond the strength over the stress");
  row_("strength_lag", end.lag.part(), run_folder::bare, "dissipation missed over dissipation");
}

void FemRecorder::observe_tractions(const fem::FemModel& model, const fem::FemState& state)
{
  for (std::size_t k = 0; k < model.loads.size(); ++k) {
    LoadedArea<2> area;
    for (const fem::NodalLoad& load : model.loads[k]) area.add(load.force, displacement_of(state, load.node), load.area);
    row_.of(model.model.tractions[k].name);
    area.observe(row_, state.tractions[k]);
  }
}

void FemRecorder::observe_watches(const fem::FemModel& model, const fem::FemState& state)
{
  for (const fem::FemWatch& watch : model.watches) {
    row_.of(watch.name);
    row_("u", displacement_of(state, watch.node), run_folder::metres, "displacement");
    row_("s", state.points[watch.cell][watch.point].stress, run_folder::pascals, "stress");
  }
}

void FemRecorder::add_row(const fem::FemModel& model, fem::FemState& state, const fem::IncrementEnd& end)
{
  const problem::State<2>& now = state.state;
  const problem::Totals<2>& t = now.totals;
  const Real error = t.internal + t.friction - t.external;
  largest_error_ = std::max(largest_error_, std::abs(error));
  largest_work_ = std::max({largest_work_, std::abs(t.external), std::abs(t.internal)});
  row_.begin(now.time, model.model.stages[now.stage.index].name);
  if (model.rigid != none) observe_rigid(model, state);
  row_.of_main("run");
  observe<2>(
      row_, Energies{.kinetic = {}, .damping = {}, .internal = t.internal, .friction = t.friction, .external = t.external, .error = error});
  if (model.weight > 0) observe_out_of_balance(row_, state.unbalanced / model.weight);
  if (model.rigid != none) {
    bodies::RigidState<2>& rigid = state.state.rigid_bodies[model.rigid];
    row_.of_main(model.model.rigid_bodies[model.rigid].name);
    observe_overlap(row_, rigid.max_overlap);
    rigid.max_overlap = 0;
    observe_turn<2>(row_, rigid.torque, rigid.orientation.angle);
    if (model.model.driven[now.stage.index] != none && end.iterations > 0) {
      largest_unbalance_ = std::max(largest_unbalance_, end.unbalance);
      largest_overstress_ = std::max(largest_overstress_, state.overstress);
      lag_.missing += std::abs(end.lag.missing);
      lag_.dissipated += end.lag.dissipated;
    }
  }
  row_.of_main("run");
  observe_solution(state, end);
  observe_tractions(model, state);
  observe_watches(model, state);
  file_.add(row_);
}

}  // namespace berm::simulation
