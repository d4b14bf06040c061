// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/simulation/run_test.cpp
#include "simulation/space_fem_method.hpp"

#include "io/duration_text.hpp"
#include "io/log.hpp"
#include "mesh/mesh_settings.hpp"
#include "problem/stages.hpp"
#include "simulation/good_sense.hpp"
#include "simulation/lost_soil.hpp"
#include "simulation/memory.hpp"
#include "simulation/processor_clock.hpp"
#include "simulation/run_place.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::simulation {
namespace {

constexpr const char* larger_elements = "take larger elements";
constexpr Real iterations_a_stage = 100;

/// The minimum number of elements that a case can have, before its mesh is made: there are none above the bed.
Real min_elements(settings::Case c)
{
  if (auto* bed = std::get_if<mesh::SeabedMesh>(&c.mesh)) bed->headroom = bed->near_height = 0;
  return min_size<3>(c).cells;
}

fem::SpaceProblem build_for(const RunRequest& request, const io::ScratchFolder& scratch)
{
  const settings::Case c = case_to_run(request);
  const Real elements = min_elements(c);
  refuse_without_memory(elements * fem::SpaceAssembly::bytes_of_element(), memory_in_use(), words_of_count(elements, "elements"),
                        larger_elements);
  refuse_without_memory_for_gmsh(c);
  return fem::build_in_space(c, mesh::make_mesh<3>(c.mesh, request.case_file.parent_path(), scratch.path()));
}

}  // namespace

void SpaceFemRecorder::add_row(const fem::SpaceModel& model, const fem::SpaceState& state, const fem::IncrementEnd& end,
                               run_folder::HistoryFile& file)
{
  const problem::State<3>& now = state.state;
  const problem::Totals<3>& t = now.ledger.totals;
  const Index main = model.model.main_rigid;
  const auto of_rigid = [&](Index rigid) {
    const std::string& name = model.model.rigid_bodies[rigid].name;
    rigid == main ? row_.of_main(name) : row_.of(name);
  };
  const auto observe_turn = [&](Index rigid) {
    observe_rotation<3>(row_, now.rigid_bodies[rigid].torque, rotation_of(now.rigid_bodies[rigid].orientation));
  };
  row_.count_parts(model.model.parts);
  row_.begin(now.time, model.model.stages[now.stage.index].name);
  if (main != none) of_rigid(main), observe_rigid(model.model, now, main, now.rigid_bodies[main].reaction);
  row_.of_main("run");
  observe_energies({.kinetic = {},
                    .damping = {},
                    .filter = {},
                    .internal = t.internal,
                    .friction = 0,
                    .external = t.external,
                    .error = t.internal - t.external});
  if (model.weight > 0) observe_out_of_balance(row_, state.unbalanced / model.weight);
  if (main != none) of_rigid(main), observe_turn(main);
  for (const problem::Contact& contact : model.model.contacts)
    if (const Index rigid = contact.rigid; rigid != main)
      of_rigid(rigid), observe_rigid(model.model, now, rigid, now.rigid_bodies[rigid].reaction), observe_turn(rigid);
  if (model.model.driven[now.stage.index] != none && end.iterations > 0) {
    largest_unbalance_ = std::max(largest_unbalance_, end.unbalance);
    largest_overstress_ = std::max(largest_overstress_, state.overstress);
  }
  row_.of_main("run");
  row_("iterations", static_cast<Real>(end.iterations), run_folder::bare, "iterations of the increment");
  row_("unbalance", end.unbalance, run_folder::bare, "out-of-balance force divided by the contact forces");
  row_("overstress", state.overstress, run_folder::bare, "stress beyond the strength divided by the stress");
  file.add(row_);
}

void SpaceFemRecorder::archive(Archive& k)
{
  Recorder<3>::archive(k);
  k("largest_unbalance", largest_unbalance_);
  k("largest_overstress", largest_overstress_);
}

SpaceFemMethod::SpaceFemMethod(const RunRequest& request, const io::ScratchFolder& scratch)
    : problem_(build_for(request, scratch)),
      steps_(problem_.model, problem_.state),
      recorder_(problem_.model.model),
      frame_maker_(problem_.model)
{
  refuse_without_memory(steps_.newton().memory_to_come(), memory_in_use(), size_words(), larger_elements);
}

std::string SpaceFemMethod::size_words() const
{
  return fmt::format("{} elements, {} nodes", problem_.model.mesh.cell_count(), problem_.model.mesh.node_count());
}

sanity::Scene SpaceFemMethod::scene(const RunRequest& request, int) const
{
  sanity::Cost cost;
  constexpr Real bytes_of_node = 250;
  cost.frame_bytes = bytes_of_node * static_cast<Real>(problem_.model.mesh.node_count());
  cost.free_bytes = free_disk(request.folder);
  return sanity::scene_of<3>(request.settings, request.places, model(), {}, {}, cost);
}

void SpaceFemMethod::begin(bool at_start)
{
  if (at_start) steps_.find_first_equilibrium();
}

void SpaceFemMethod::step()
{
  last_ = steps_.advance();
  refuse_lost_soil<3>(problem_.model.mesh, model().mesh, problem_.state.displacement, state().time);
  iterations_ += last_.iterations;
  if (last_.converged) return;
  ++accepted_above_tolerance_;
  io::warn("t = {:.6g} s: the increment has converged only loosely, with unbalanced forces of {:.2g} of the contact forces", state().time,
           last_.unbalance);
}

bool SpaceFemMethod::next_stage()
{
  const std::vector<Real> at_end = problem_.state.displacement;
  const problem::State<3> bodies_at_end = state();
  if (!steps_.next_stage()) return false;
  if (model().stages[state().stage.index].zero_displacements) {
    recorder_.zero_displacements(bodies_at_end);
    frame_maker_.zero_displacements(at_end);
  }
  return true;
}

void SpaceFemMethod::archive(Archive& k)
{
  k.table("increments", [&] { frame_maker_.archive(k); });
  k.table("recorder", [&] { recorder_.archive(k); });
  k.table("steps", [&] { steps_.archive(k); });
  k("iterations", iterations_);
  k("accepted_above_tolerance", accepted_above_tolerance_);
  k.table("state", [&] { fem::archive(k, problem_.model, problem_.state); });
}

run_folder::Summary::Checks SpaceFemMethod::checks() const
{
  return {{"energy_error", recorder_.energy_error()},
          {"largest_unbalance", recorder_.largest_unbalance()},
          {"loose_increments", static_cast<Real>(accepted_above_tolerance_)},
          {"largest_overstress", recorder_.largest_overstress()}};
}

Estimate SpaceFemMethod::estimate(const Context& context)
{
  Estimate e;
  e.cells = problem_.model.mesh.cell_count();
  e.nodes = problem_.model.mesh.node_count();
  e.memory = memory_in_use() + steps_.newton().memory_to_come();
  const Real iteration = measure_iteration();
  e.time = iterations_a_stage * static_cast<Real>(model().stages.size()) * iteration;
  e.lines = {fmt::format("elements     {}", e.cells), fmt::format("nodes        {}", e.nodes),
             fmt::format("memory       about {:.0f} MiB at most", e.memory / (1 << 20)),
             fmt::format("time         about {} with {} thread{} of a free machine ({:.2g} s an iteration)", io::duration_text(e.time),
                         context.threads(), context.threads() == 1 ? "" : "s", iteration)};
  return e;
}

Real SpaceFemMethod::expected_wall_time()
{
  return iterations_a_stage * static_cast<Real>(model().stages.size()) * measure_iteration();
}

/// What an iteration takes on a free machine, s: the processor time of this thread.
Real SpaceFemMethod::measure_iteration()
{
  const ProcessorClock clock;
  std::vector<Real> change(static_cast<std::size_t>(problem_.model.unknowns()), 0.);
  fem::ElementLoads<3> loads;
  loads.gravity = gravity_now(model(), state().time);
  constexpr Real small_step = 1e-6;  // of the width: it takes a factorization, which soil at rest does not
  if (problem_.model.contact_count() > 0) loads.rigid[model().axes.up].value = small_step * problem_.model.width;
  steps_.newton().assembly().store_initial_imbalance(problem_.state, loads);
  const fem::IncrementEnd end = steps_.newton().find_equilibrium(problem_.state, loads, 1, change);
  return clock.passed() / std::max(end.iterations, 1);
}

}  // namespace berm::simulation
