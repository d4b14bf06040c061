// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/simulation/run_test.cpp
#include "simulation/fem_method.hpp"

#include "fem/fem_problem.hpp"
#include "io/duration_text.hpp"
#include "io/log.hpp"
#include "problem/safety.hpp"
#include "problem/stages.hpp"
#include "settings/safety.hpp"
#include "simulation/good_sense.hpp"
#include "simulation/lost_soil.hpp"
#include "simulation/memory.hpp"
#include "simulation/processor_clock.hpp"
#include "simulation/run_place.hpp"

#include <cmath>
#include <fmt/format.h>

namespace berm::simulation {
namespace {

/// Of what plastic flow dissipates: twice what the passes of an increment leave (LoadSteps).
constexpr Real max_lag = 0.02;

constexpr const char* larger_elements = "take larger elements";

/// The minimum number of elements that a case can have, before its mesh is made: there are none above the bed.
Real min_elements(settings::Case c)
{
  if (auto* bed = std::get_if<mesh::SeabedMesh>(&c.mesh)) bed->headroom = bed->near_height = 0;
  return min_size<2>(c).cells;
}

fem::FemProblem build_for(const RunRequest& request, const io::ScratchFolder& scratch)
{
  const settings::Case c = case_to_run(request);
  const Real elements = min_elements(c);
  refuse_without_memory(elements * fem::Assembly::bytes_of_element(), memory_in_use(), words_of_count(elements, "elements"),
                        larger_elements);
  refuse_without_memory_for_gmsh(c);
  return fem::build_fem(c, request.case_file.parent_path().string(), scratch.path().string());
}

std::optional<fem::Remesher> remesher_of(const settings::Case& c, const io::ScratchFolder& scratch)
{
  if (!c.fem.large_deformation) return std::nullopt;
  return fem::Remesher(c, scratch.path());
}

}  // namespace

FemMethod::FemMethod(const RunRequest& request, const io::ScratchFolder& scratch)
    : memory_for_mesh_(memory_in_use() + memory_of_gmsh(request.settings)),
      problem_(build_for(request, scratch)),
      steps_(problem_.model, problem_.state, remesher_of(request.settings, scratch)),
      recorder_(problem_.model),
      frame_maker_(problem_.model)
{
  refuse_without_memory(steps_.memory_to_come(), memory_in_use(), size_words(), larger_elements);
  if (!request.settings.safety) return;
  factor_ = request.settings.safety->factor;
  const NodeField<Vec<2>>& nodes = problem_.model.mesh.position;
  const Real depth = depth_of_soil(model(), std::vector<Vec<2>>(nodes.begin(), nodes.end()));
  trial_.emplace(movement_at_failure(request.settings, model(), depth), time_factor_of_last_stage(request.settings, depth));
  trial_->begin_stage(!moves_body(model().stages.front()));
  moved_from_ = problem_.state.displacement;
}

/// In a trial of the factor of safety soil without an equilibrium is soil that fails.
template <class Act>
void FemMethod::try_to(const Act& act)
{
  try {
    act();
  } catch (const fem::NoEquilibrium& why) {
    if (!trial_) throw;
    io::info("{}", why.what());
    trial_->note_no_equilibrium();
  }
}

/// The largest displacement of a node, m.
Real FemMethod::movement() const
{
  const std::vector<Real>& now = problem_.state.displacement;
  Real largest = 0;
  for (Index node = 0; node < problem_.model.mesh.node_count(); ++node)
    largest = std::max(largest, std::hypot(now[2 * node] - moved_from_[2 * node], now[2 * node + 1] - moved_from_[2 * node + 1]));
  return largest;
}

bool FemMethod::is_last_stage() const
{
  return state().stage.index + 1 == static_cast<Index>(model().stages.size());
}

/// What a body has moved counts no more.
void FemMethod::end_stage_of_trial()
{
  if (is_last_stage()) trial_->end_flow(problem_.state.overstress);
  if (is_last_stage() || trial_->failed()) return io::info("{}", trial_->words(factor_));
  if (moves_body(model().stages[state().stage.index])) moved_from_ = problem_.state.displacement;
  trial_->begin_stage(!moves_body(model().stages[state().stage.index + 1]));
}

void FemMethod::add_row(run_folder::HistoryFile& file)
{
  if (trial_) {
    trial_->note(state().time, movement());
    recorder_.note_movement(trial_->movement());
  }
  recorder_.add_row(problem_.model, problem_.state, last_, steps_.remeshings(), file);
}

std::string FemMethod::size_words() const
{
  return fmt::format("{} elements, {} nodes", problem_.model.mesh.cell_count(), problem_.model.mesh.node_count());
}

sanity::Scene FemMethod::scene(const RunRequest& request, int) const
{
  sanity::Cost cost;
  constexpr Real bytes_of_node = 200;  // with its part of the elements
  cost.frame_bytes = bytes_of_node * static_cast<Real>(problem_.model.mesh.node_count());
  cost.free_bytes = free_disk(request.folder);
  return sanity::scene_of<2>(request.settings, request.places, model(), {}, {}, cost);
}

void FemMethod::begin(bool at_start)
{
  if (!at_start) return;
  try_to([&] { steps_.find_first_equilibrium(); });
  recorder_.observe_steps(steps_);
}

void FemMethod::step()
{
  if (trial_ && trial_->failed()) return;
  const BigIndex folds = steps_.remeshings().folds;
  try_to([&] { last_ = steps_.advance(); });
  if (trial_ && trial_->failed()) return;
  if (steps_.remeshings().folds > folds)
    io::info("t = {:.6g} s: soil has come into contact with soil or with a wall, and is joined to it there", state().time);
  if (!trial_ && keeps_mesh()) refuse_lost_soil<2>(problem_.model.mesh, model().mesh, problem_.state.displacement, state().time);
  recorder_.observe_steps(steps_);
  iterations_ += last_.iterations;
  if (last_.converged) return;
  ++accepted_above_tolerance_;
  io::warn("t = {:.6g} s: the increment has converged only loosely, with unbalanced forces of {:.2g} of the contact forces", state().time,
           last_.unbalance);
}

bool FemMethod::next_stage()
{
  if (trial_) {
    end_stage_of_trial();
    if (trial_->failed()) return false;
  }
  bool begins = true;
  const std::vector<Real> at_end = problem_.state.displacement;
  const problem::State<2> bodies_at_end = state();
  try_to([&] { begins = steps_.next_stage(); });
  if (begins && model().stages[state().stage.index].zero_displacements) {
    recorder_.zero_displacements(at_end, bodies_at_end);
    frame_maker_.zero_displacements(at_end);
    note_places(problem_.model, fem::Moment::zero, at_end, problem_.state);
  }
  if (begins) recorder_.observe_steps(steps_);
  return begins;
}

void FemMethod::archive(Archive& k)
{
  if (problem_.model.settings.large_deformation) k.table("elements", [&] { steps_.archive_mesh(k); });
  k.table("increments", [&] { frame_maker_.archive(k); });
  k.table("recorder", [&] { recorder_.archive(k); });
  k.table("steps", [&] { steps_.archive(k); });
  k("iterations", iterations_);
  k("accepted_above_tolerance", accepted_above_tolerance_);
  if (trial_)
    k.table("trial", [&] {
      trial_->archive(k);
      k.fixed("moved_from", moved_from_);
    });
  k.table("state", [&] { fem::archive(k, problem_.model, problem_.state); });
  if (problem_.model.settings.large_deformation && k.reads()) place_contact(problem_.model, problem_.state);
}

run_folder::Frame<2> FemMethod::make_frame(run_folder::Frame<2>)
{
  run_folder::Frame<2> frame = frame_maker_.make(problem_.state);
  note_places(problem_.model, fem::Moment::last_frame, problem_.state.displacement, problem_.state);
  return frame;
}

run_folder::Summary::Checks FemMethod::checks() const
{
  if (recorder_.strength_lag() > max_lag)
    io::warn("the strength of the soil lags behind its pressure by {:.2g} of the plastic dissipation, and forces may be wrong by as "
             "much; compare a run with a tenth of fem.largest_step",
             recorder_.strength_lag());
  run_folder::Summary::Checks checks = {{"energy_error", recorder_.energy_error()},
                                        {"largest_unbalance", recorder_.largest_unbalance()},
                                        {"loose_increments", static_cast<Real>(accepted_above_tolerance_)},
                                        {"largest_overstress", recorder_.largest_overstress()},
                                        {"strength_lag", recorder_.strength_lag()},
                                        {"friction_work_is_loss", state().ledger.totals.friction >= 0}};
  if (const fem::Remeshings& of = steps_.remeshings(); of.count > 0) {
    checks.emplace_back("remeshings", static_cast<Real>(of.count));
    checks.emplace_back("largest_change_by_remeshing", of.largest_change_over_force());
    checks.emplace_back("mean_change_by_remeshing", of.mean_change());
    const Real width = problem_.model.width, work = recorder_.largest_work();
    const Real size = std::pow(width, model().mesh.metric == mesh::Metric::axisymmetric ? 3 : 2);
    checks.emplace_back("energy_lost_by_remeshing", work > 0 ? of.lost_energy / work : 0);
    checks.emplace_back("folds_closed_by_remeshing", static_cast<Real>(of.folds));
    checks.emplace_back("area_lost_by_remeshing", of.lost_area / size);
  }
  if (trial_)
    for (auto& check : trial_->checks()) checks.push_back(std::move(check));
  return checks;
}

Estimate FemMethod::estimate(const Context& context)
{
  const fem::FemModel& model = problem_.model;
  const Real iteration = measure_iteration();
  Estimate e;
  e.cells = model.mesh.cell_count();
  e.nodes = model.mesh.node_count();
  e.memory = std::max(memory_for_mesh_, memory_in_use() + steps_.memory_to_come());
  e.time = time_of_stages(iteration);
  e.lines = {fmt::format("elements     {}", e.cells), fmt::format("nodes        {}", e.nodes),
             fmt::format("contact      {} points", model.contact.size()),
             fmt::format("memory       about {:.0f} MiB at most", e.memory / (1 << 20)),
             fmt::format("time         about {} with {} thread{} of a free machine ({:.2g} s an iteration)", io::duration_text(e.time),
                         context.threads(), context.threads() == 1 ? "" : "s", iteration)};
  return e;
}

/// In large deformations by the travel of the body.
Real FemMethod::time_of_stages(Real iteration) const
{
  constexpr Real iterations_a_stage = 300, iterations_an_increment = 6, iterations_a_mesh = 12, time_of_gmsh = 0.04;
  const fem::FemModel& of = problem_.model;
  Real travel = 0;
  for (const settings::StageSettings& stage : model().stages)
    if (const Real speed = std::abs(stage.velocity.value_or(0)); speed > 0) travel += speed * expected_time(stage) / of.width;
  if (!(travel > 0) || !of.settings.large_deformation) return iterations_a_stage * static_cast<Real>(model().stages.size()) * iteration;
  const Real meshes = travel / of.settings.remeshing_travel,
             increments = travel / std::min(of.settings.largest_step, of.settings.remeshing_travel / 4);
  return iteration * (iterations_an_increment * increments + iterations_a_mesh * meshes) + time_of_gmsh * meshes;
}

Real FemMethod::expected_wall_time()
{
  return time_of_stages(measure_iteration());
}

/// What an iteration takes on a free machine, s: the processor time of this thread.
Real FemMethod::measure_iteration()
{
  const ProcessorClock clock;
  fem::Newton& newton = steps_.newton();
  std::vector<Real> change(problem_.model.unknowns(), 0.);
  fem::FemLoads loads;
  loads.gravity = gravity_now(model(), state().time);
  newton.assembly().store_initial_imbalance(problem_.state, loads);
  const fem::IncrementEnd end = newton.find_equilibrium(problem_.state, loads, 1, change);
  return clock.passed() / (end.iterations + 1);
}

}  // namespace berm::simulation
