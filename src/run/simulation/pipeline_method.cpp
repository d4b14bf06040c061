// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/library/library_pipeline_test.cpp
#include "simulation/pipeline_method.hpp"

#include "beam/answers.hpp"
#include "core/ranks.hpp"
#include "input/read_case.hpp"
#include "input/write_case.hpp"
#include "io/atomic_file.hpp"
#include "io/log.hpp"
#include "mpm/body_sums.hpp"
#include "os/error.hpp"
#include "os/interrupt.hpp"
#include "os/text_of_list.hpp"
#include "simulation/memory.hpp"
#include "simulation/recorder.hpp"
#include "simulation/run_of_ranks.hpp"
#include "user_law/load.hpp"

#include <fmt/format.h>

namespace berm::simulation {
namespace {

constexpr run_folder::ColumnUnit kelvins{"K", "K"};
constexpr std::size_t numbers_of_node = 9;  ///< of line.csv
constexpr Real columns_of_diameter = 10;    ///< of berms.csv
constexpr const char* head_of_shapes = "frame,time_s,stage,x_m,y_m,z_m,u_m,P_N,M_Nm,strain_max,strain_min\n";

using beam::Plane;

/// With all places where these are not even.
std::string slices_in_words(const slices::LineOfCase& of)
{
  const std::string words = slices::words_of_places(of.places);
  return of.settings.slices.spacing ? words : fmt::format("{}: at x = {} m", words, text_of_list(of.places, ", ", "{:.4g}"));
}

Real across(const slices::LineOfCase& of, const beam::State& state, Plane plane, Index node)
{
  return state.displacement[of.line.across(plane, node)];
}

/// m from the axis of the line, or from its route where it has one.
Real sideways(const slices::LineOfCase& of, const beam::State& state, Index node)
{
  const Index at = of.line.across(Plane::lateral, node);
  return state.displacement[at] - (of.settings.route.empty() ? 0 : of.line.shape[at]);
}

Index crown_of(const slices::LineOfCase& of, const beam::State& state)
{
  return beam::crown(of.line, state, !of.settings.route.empty());
}

/// x of the first place beyond the crown at which the line crosses its axis, m; NaN where it does not.
Real crossing_of(const slices::LineOfCase& of, const beam::State& state)
{
  for (Index i = crown_of(of, state); i + 1 < of.line.nodes(); ++i) {
    const Real a = sideways(of, state, i), b = sideways(of, state, i + 1);
    if (a != 0 && a * b <= 0) return of.line.x[i] + a / (a - b) * of.line.length(i);
  }
  return nan;
}

/// Of the line on slices and of that on springs.
void add_shape(run_folder::Row& row, const slices::LineOfCase& of, const beam::State& now)
{
  const Index crown = crown_of(of, now);
  row("P", -beam::effective_force(of.line, now, 0), run_folder::whole_newtons, "effective compression at x = 0");
  row("x", of.line.x[crown], run_folder::metres, "position of the largest lateral displacement");
  row("y", sideways(of, now, crown), run_folder::metres,
      "largest lateral displacement of the line, from its straight axis, or from its route");
  row("M", beam::largest_moment(of.line, now), run_folder::whole_newton_metres, "largest lateral bending moment");
}

}  // namespace

namespace {

/// Rows of a number by column on other columns: that of the column a middle lies in, 0 beyond them.
std::vector<Real> on_columns(const slices::SoilColumns& columns, const slices::SoilColumns& before, const std::vector<Real>& rows)
{
  const std::vector<Real>& from = before.middles();
  const Real width = from[1] - from[0];
  std::vector<Real> numbers;
  for (std::size_t row = 0; row < rows.size(); row += from.size())
    for (const Real x : columns.middles()) {
      const auto c = static_cast<Index>(std::floor((x - from[0]) / width + Real(0.5)));
      numbers.push_back(c < 0 || c >= static_cast<Index>(from.size()) ? 0 : rows[row + static_cast<std::size_t>(c)]);
    }
  return numbers;
}

}  // namespace

PipelineMethod::PipelineMethod(const RunRequest& request, const io::ScratchFolder& scratch)
    : folder_(request.folder),
      first_(request, scratch),
      line_(first_.case_of_run(), model()),
      last_(line_.count(), state().ledger),
      works_(line_.count(), 0),
      columns_(model(), line_.of_case().diameter / columns_of_diameter),
      level_(line_.count(), columns_.heights(state()))
{
  if (line_.of_case().settings.springs) springs_.emplace(first_.case_of_run());
  if (!model().earthworks.empty()) throw KeyError("pipeline: cannot be combined with fills and excavations");
  make_soils(request, scratch);
  refuse_without_memory(memory_of_others(), memory_in_use(), fmt::format("{} slices", line_.count()),
                        "take larger cells, fewer particles or fewer slices");
  const bool springs = line_.of_case().settings.slices.as_spring == settings::SliceAsSpring::always;
  first_.expect_slices(springs ? 0 : line_.count(), memory_of_others());
}

/// A problem of its own for each other soil.
void PipelineMethod::make_soils(const RunRequest& request, const io::ScratchFolder& scratch)
{
  const std::vector<settings::OtherSoil>& others = line_.of_case().settings.soil;
  const std::vector<Real>& places = line_.of_case().places;
  for (std::size_t j = 0; j < others.size(); ++j) {
    RunRequest changed = request;
    try {
      changed.settings = input::read_case_text(request.case_file.string() + ", all keys written out",
                                               input::resolved_toml(request.settings), others[j].set);
      user_law::load(changed.settings, request.laws);
      soils_.push_back(std::make_unique<MpmMethod<2>>(changed, scratch));
    } catch (const InputError& error) {
      throw KeyError(fmt::format("pipeline.soil[{}].set: {}", j, error.what()));
    }
    const Real little = 1e-9 * places.back();
    std::size_t count = 0;
    for (std::size_t k = 1; k < places.size(); ++k) {
      if (places[k] < others[j].from - little || places[k] > others[j].to + little) continue;
      line_.give_soil(k, soils_.back()->model(), soils_.back()->state());
      ++count;
    }
    if (count == 0)
      throw KeyError(fmt::format("pipeline.soil[{}]: no slice lies between {:.4g} and {:.4g} m", j, others[j].from, others[j].to));
  }
}

/// Bytes, at most: each has the particles and sums of the first; they share its mesh.
Real PipelineMethod::memory_of_others() const
{
  return static_cast<Real>(line_.count() - 1) * memory_of<2>(size_of(first_.problem()));
}

std::string PipelineMethod::size_words() const
{
  const slices::LineOfCase& of = line_.of_case();
  return fmt::format("{}, {}, line of {} nodes", first_.size_words(), slices_in_words(of), of.line.nodes());
}

Estimate PipelineMethod::estimate(const Context& context)
{
  const slices::LineOfCase& of = line_.of_case();
  Estimate e = first_.estimate(context);
  e.lines.insert(e.lines.begin(),
                 fmt::format("pipeline     {}{}, line of {} nodes to {:.4g} m; cells, nodes and particles are those of one slice",
                             slices_in_words(of),
                             of.settings.slices.as_spring == settings::SliceAsSpring::always ? ", as springs"
                             : of.may_be_springs()                                           ? ", as springs until they slide"
                                                                                             : "",
                             of.line.nodes(), of.line.x.back()));
  return e;
}

void PipelineMethod::step()
{
  if (!on_line()) return first_.step();
  if (springs_ && !springs_->ready() && !find_springs()) return come_to_checkpoint_boundary();
  line_.step(first_.state_now(), first_.workspace(), [&] { first_.step(); });
  if (springs_) springs_->step(line_.loads_at(state(), state().time), state().dt);
}

/// By a drag, before the first step of the line. False where a signal has asked to stop; the next step begins anew.
bool PipelineMethod::find_springs()
{
  io::info("springs beside the line: a copy of the laid slice is dragged laterally over {:.4g} m",
           line_.of_case().settings.springs->travel);
  const auto found = springs_->find(model(), state(), [] { return Ranks::of_run().count() == 1 && interrupted(); });
  if (!found) return false;
  const std::vector<beam::CurvePoint>& points = found->backbone.points;
  io::info("springs beside the line: {:.4g} N/m at {:.3g} m, {:.4g} N/m at {:.3g} m; of {} points {} were left out and {} lowered",
           points.front().force, points.front().displacement, points.back().force, points.back().displacement, found->measured,
           found->left_out, found->lowered);
  return true;
}

bool PipelineMethod::next_stage()
{
  if (!first_.next_stage()) return false;
  if (!on_line()) return true;
  if (!line_.is_coupled()) {
    for (std::size_t j = 0; j < soils_.size(); ++j) try {
        soils_[j]->step_to(settings::StageKind::pipeline);
      } catch (const RunError& error) {
        throw RunError(fmt::format("pipeline.soil[{}], while the pipe is laid there: {}", j, error.what()));
      }
    line_.couple(state());
    for (std::size_t k = 1; k < line_.count(); ++k) last_[k] = line_.slice(k).ledger;
    hung_at_ = state().step;
    const Real carried = line_.forces()[0].force[1], weight = line_.of_case().settings.submerged_weight;
    constexpr Real allowed = 0.1;
    if (!(std::abs(carried / weight - 1) < allowed))
      io::warn("the laid pipe exerts {:.4g} N/m on the soil, and the submerged weight of the line is {:.4g} N/m: set the vertical force of "
               "the last "
               "stage before the line to its weight",
               carried, weight);
  }
  line_.begin_stage(state());
  return true;
}

void PipelineMethod::come_to_checkpoint_boundary()
{
  if (line_.is_coupled()) return line_.find_time_steps(first_.state_now(), first_.workspace());
  first_.come_to_checkpoint_boundary();
}

void PipelineMethod::drive(int freedom, bool by_force, Real value)
{
  if (on_line())
    throw InputError(
        fmt::format("the stage \"{}\" is one of a pipeline, whose line drives the pipe", model().stages[state().stage.index].name));
  first_.drive(freedom, by_force, value);
}

void PipelineMethod::lengthen(std::unique_ptr<PipelineMethod> before)
{
  first_.lengthen(before->first_);
  before_ = std::move(before);
}

Sides PipelineMethod::sides() const
{
  Sides all = first_.sides();
  const Extent first = all.now;
  for (std::size_t k = 1; line_.is_coupled() && k < line_.count(); ++k) {
    const Real further = line_.slice(k).rigid_bodies[0].displacement[0] - state().rigid_bodies[0].displacement[0];
    all.now = {std::min(all.now.from, first.from + further), std::max(all.now.to, first.to + further)};
  }
  return all;
}

void PipelineMethod::begin(bool at_start)
{
  first_.begin(at_start);
  before_.reset();
}

void PipelineMethod::archive(Archive& k)
{
  PipelineMethod& of = before_ != nullptr && k.reads() ? *before_ : *this;
  first_.archive(k);
  k.table("pipeline", [&] {
    of.line_.archive(k, of.state());
    if (&of != this) line_.lengthen(of.line_, first_.case_of_run(), state(), *first_.start());
    if (springs_) k.table("springs", [&] { springs_->archive(k); });
    k("hung_at", hung_at_);
    k("last_row", last_row_);
    k("largest_slope", largest_slope_);
    k("energy_error_of_slices", energy_error_of_slices_);
    k.fixed("works", works_);
    k("largest_contact_mass", largest_contact_mass_);
    for (std::size_t s = 0; s < last_.size(); ++s) k.table(fmt::format("ledger_{}", s), [&] { problem::archive(k, last_[s]); });
    k("shapes", shapes_);
    k("stages", stages_);
    k("berms", berms_);
    k("first_frame_of_berms", first_frame_of_berms_);
    for (std::size_t s = 0; of.state().lengthened && s < of.level_.size(); ++s) k.fixed(fmt::format("level_{}", s), of.level_[s]);
    if (!k.reads()) return;
    if (&of != this) take_berms(of);
    if (shapes_.size() != stages_.size() * static_cast<std::size_t>(line_.of_case().line.nodes()) * numbers_of_node)
      k.refuse("the shapes of the line are incomplete");
  });
}

/// The rise of soil on the columns of a shorter mesh. What it counts from here is found from it: carried particles do not lie as those of the start.
void PipelineMethod::take_berms(const PipelineMethod& before)
{
  berms_ = on_columns(columns_, before.columns_, berms_);
  for (std::size_t s = 0; s < level_.size(); ++s) {
    std::vector<Real> rise = before.columns_.heights(before.slice(s));
    for (std::size_t c = 0; c < rise.size(); ++c) rise[c] -= before.level_[s][c];
    rise = on_columns(columns_, before.columns_, rise);
    level_[s] = columns_.heights(slice(s));
    for (std::size_t c = 0; c < rise.size(); ++c) level_[s][c] -= rise[c];
  }
}

/// The first one, until all are there.
const problem::State<2>& PipelineMethod::slice(std::size_t k) const
{
  return k == 0 || !line_.is_coupled() ? state() : line_.slice(k);
}

void PipelineMethod::add_row(run_folder::HistoryFile& file)
{
  first_.add_row(file, [&](run_folder::Row& row) {
    add_line(row);
    add_slices(row);
  });
  last_row_ = state().time;
}

void PipelineMethod::add_line(run_folder::Row& row)
{
  const slices::LineOfCase& of = line_.of_case();
  const beam::State& now = line_.state();
  const slices::LineLoads loads = line_.loads_at(state(), state().time);
  const Index crown = crown_of(of, now),
              last_of_slices = static_cast<Index>(std::lower_bound(of.line.x.begin(), of.line.x.end(), of.places.back() * (1 - 1e-9)) -
                                                  of.line.x.begin());
  Real stretched = 0, compressed = 0, contact_mass = 0;
  for (Index e = 0; e < of.line.elements(); ++e) {
    const beam::FibreStrain strain = beam::longitudinal_strain(of.line, now, e);
    stretched = std::max(stretched, strain.largest);
    compressed = std::min(compressed, strain.smallest);
  }
  for (const slices::SliceForce& slice : line_.forces()) contact_mass = std::max(contact_mass, slice.contact_mass);
  largest_slope_ = std::max(largest_slope_, beam::largest_slope(of.line, now));
  largest_contact_mass_ = std::max(largest_contact_mass_, contact_mass / of.mass);
  row.of("line");
  row("T", loads.temperature, kelvins, "rise of temperature since the line was laid");
  row("p", loads.pressure, run_folder::pascals, "rise of internal pressure since the line was laid");
  row("P0", of.constrained_force(loads, 0), run_folder::whole_newtons, "effective compression of a fully constrained length");
  add_shape(row, of, now);
  row("z", across(of, now, Plane::vertical, crown), run_folder::metres, "height of the line there, relative to where it was laid");
  row("crossing", crossing_of(of, now), run_folder::metres, "position beyond it where the line crosses its axis");
  row("strain_max", stretched, run_folder::bare, "largest longitudinal strain");
  row("strain_min", compressed, run_folder::bare, "smallest longitudinal strain: the largest in compression");
  row("feed_in", -now.displacement[of.line.axial(last_of_slices)], run_folder::metres,
      "axial displacement at the last slice towards x = 0");
  row("contact_mass", contact_mass, run_folder::kilograms<2>, "largest mass of soil at the nodes that the pipe touches in a slice");
  if (!springs_) return;
  row.of("springs");
  add_shape(row, of, springs_->ready() ? springs_->line().state() : now);  // before, both lie as they were laid
}

/// The largest error of the balance of energy in the other slices, over the largest work done there so far.
Real PipelineMethod::energy_error_of_slices()
{
  Real largest = energy_error_of_slices_;
  for (std::size_t k = 1; k < line_.count(); ++k) {
    if (!line_.is_coupled() || line_.is_spring(k) || slices::CoupledLine::rank_of(k) != Ranks::of_run().rank()) continue;
    const problem::State<2>& slice = line_.slice(k);
    const problem::Totals<2>& t = slice.ledger.totals;
    Real kinetic = 0;
    for (const bodies::Particles<2>& particles : slice.particles) kinetic += mpm::sums_over(particles).kinetic;
    const Real error = kinetic + t.internal + t.damping + t.filter + t.friction - t.external;
    works_[k] = std::max({works_[k], std::abs(t.external), std::abs(t.internal)});
    largest = std::max(largest, std::abs(error) / works_[k]);
  }
  return Ranks::of_run().count() > 1 ? Ranks::of_run().messenger()->largest(largest) : largest;
}

void PipelineMethod::add_slices(run_folder::Row& row)
{
  energy_error_of_slices_ = energy_error_of_slices();
  const Real time = state().time - last_row_;
  for (std::size_t k = 0; k < line_.count(); ++k) {
    const problem::State<2>& now = slice(k);
    const Vec<2> impulse = difference<2>(now.ledger, last_[k]).contact_sums[0].impulse;  // of the soil on the pipe
    const Vec<2> reaction = time > 0 ? Vec<2>(impulse / time) : Vec<2>(Vec<2>::Zero());
    last_[k] = now.ledger;
    if (k == 0) continue;  // the main columns
    row.of(fmt::format("slice_{}", k));
    observe<2>(row, response_of<2>(model(), now, 0, reaction));
  }
}

void PipelineMethod::note_shape()
{
  const slices::LineOfCase& of = line_.of_case();
  const beam::State& now = line_.state();
  stages_.push_back(state().stage.index);
  for (Index i = 0; i < of.line.nodes(); ++i) {
    const Index e = std::min(i, of.line.elements() - 1);
    const beam::FibreStrain strain = beam::longitudinal_strain(of.line, now, e);
    shapes_.insert(shapes_.end(), {state().time, of.line.x[i], across(of, now, Plane::lateral, i), across(of, now, Plane::vertical, i),
                                   now.displacement[of.line.axial(i)], -beam::effective_force(of.line, now, e),
                                   beam::moment(of.line, now, Plane::lateral, i), strain.largest, strain.smallest});
  }
}

run_folder::Frame<2> PipelineMethod::make_frame(run_folder::Frame<2> old)
{
  note_shape();
  note_berms();
  if (Ranks::of_run().is_first()) {
    write_shapes();
    write_berms();
    if (springs_ && springs_->ready()) write_springs();
  }
  return first_.make_frame(std::move(old));
}

/// Of the slices that this rank has; the first has all then.
void PipelineMethod::note_berms()
{
  if (!line_.is_coupled()) {
    first_frame_of_berms_ = static_cast<Index>(stages_.size());
    return;
  }
  const std::size_t size = columns_.middles().size(), begin = berms_.size();
  for (std::size_t k = 0; k < line_.count(); ++k) {
    const std::vector<Real> now = columns_.heights(slice(k));
    for (std::size_t c = 0; c < size; ++c) berms_.push_back(now[c] - level_[k][c]);
  }
  gather_on_first_rank([&](Archive& k, int rank) {
    for (std::size_t s = 0; s < line_.count(); ++s) {
      if (slices::CoupledLine::rank_of(s) != rank) continue;
      const auto at = berms_.begin() + static_cast<std::ptrdiff_t>(begin + s * size);
      std::vector<Real> of_slice(at, at + static_cast<std::ptrdiff_t>(size));
      k.fixed(fmt::format("slice_{}", s), of_slice);
      std::copy(of_slice.begin(), of_slice.end(), at);
    }
  });
}

void PipelineMethod::write_berms() const
{
  if (berms_.empty()) return;
  std::string text = "frame,slice,x_m";
  for (const Real y : columns_.middles()) fmt::format_to(std::back_inserter(text), ",rise_m_at_{:.3f}_m", y);
  text += '\n';
  const std::size_t size = columns_.middles().size(), slices = line_.count();
  for (std::size_t row = 0; row < berms_.size() / size; ++row) {
    fmt::format_to(std::back_inserter(text), "{},{},{:.6g}", first_frame_of_berms_ + static_cast<Index>(row / slices), row % slices,
                   line_.of_case().places[row % slices]);
    for (std::size_t c = 0; c < size; ++c) fmt::format_to(std::back_inserter(text), ",{:.4f}", berms_[row * size + c]);
    text += '\n';
  }
  io::write_atomically(folder_ / "berms.csv", text);
}

void PipelineMethod::write_shapes() const
{
  std::string text = head_of_shapes;
  const std::size_t nodes = static_cast<std::size_t>(line_.of_case().line.nodes());
  for (std::size_t row = 0; row < shapes_.size() / numbers_of_node; ++row) {
    const Real* n = &shapes_[row * numbers_of_node];
    fmt::format_to(std::back_inserter(text), "{},{},{}", row / nodes, n[0], model().stages[stages_[row / nodes]].name);
    for (std::size_t c = 1; c < numbers_of_node; ++c) fmt::format_to(std::back_inserter(text), ",{}", n[c]);
    text += '\n';
  }
  io::write_atomically(folder_ / "line.csv", text);
}

void PipelineMethod::write_springs() const
{
  std::string text = "u_m,H_N_m\n";
  for (const beam::CurvePoint& point : springs_->curve().points)
    fmt::format_to(std::back_inserter(text), "{},{}\n", point.displacement, point.force);
  io::write_atomically(folder_ / "springs.csv", text);
}

mpm::WholeState<2> PipelineMethod::whole_state()
{
  if (line_.is_coupled()) gather_on_first_rank([&](Archive& k, int rank) { line_.archive_of_rank(k, rank); });
  return first_.whole_state();
}

run_folder::Summary::Checks PipelineMethod::checks() const
{
  run_folder::Summary::Checks checks = first_.checks();
  checks.push_back({"energy_error_of_slices", energy_error_of_slices_});
  checks.push_back({"line_slope", largest_slope_});
  checks.push_back({"contact_mass_over_mass", largest_contact_mass_});
  if (largest_slope_ > beam::largest_valid_slope)
    io::warn("the line has a slope of {:.2g}; its strain measure is valid up to {} (docs/theory/fem_safety_pipelines.md)", largest_slope_,
             beam::largest_valid_slope);
  return checks;
}

Real PipelineMethod::particle_steps() const
{
  const BigIndex before = line_.is_coupled() ? hung_at_ : state().step;
  return static_cast<Real>(counts().particles * (before + line_.slice_steps()));
}

}  // namespace berm::simulation
