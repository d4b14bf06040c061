// SPDX-License-Identifier: BSD-3-Clause
#include "structures/pipe/published.hpp"

#include "formulas/f114.hpp"
#include "structures/driven/resistance.hpp"
#include "structures/driven/run_points.hpp"
#include "structures/pipe/published_of_soil.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::pipe {
namespace {

constexpr Real push_parts[] = {0.1, 0.25, 0.5, 0.75, 1}, drag_parts[] = {0.1, 0.3, 0.5, 1};  // of D

template <std::size_t size>
bool is_one_of(Real part, const Real (&parts)[size])
{
  return std::any_of(parts, parts + size, [&](Real p) { return std::abs(p - part) < 1e-6; });
}

/// The states without their comparisons.
std::vector<ComparedState> states_of(const driven::DrivenRun& run)
{
  const driven::RunPoints points = driven::points_of(run);
  const bool small_strain = run.settings.small_strain();
  const Real D = run.scale.width;
  std::vector<ComparedState> states;
  // Small strains leave the pipe where it began: what it carries on the way is no strength.
  if (!small_strain)
    for (const driven::PushPoint& p : points.push)
      if (is_one_of(p.w / D, push_parts)) states.push_back({ComparedState::Kind::push, nan, p.w, p.V, {}});
  if (points.push_end) {
    const Real w = small_strain ? points.first_w : points.push_end->w;
    states.push_back({ComparedState::Kind::end_of_push, nan, w, points.push_end->V, {}});
  }
  for (const driven::DragPoint& p : points.drag)
    if (is_one_of(p.u / D, drag_parts)) states.push_back({ComparedState::Kind::drag, p.u, small_strain ? points.first_w : p.w, p.V, {}});
  return states;
}

std::string remark_on_place(const driven::DrivenRun& run)
{
  if (run.settings.small_strain())
    return fmt::format(
        "This run is wished in place: the pipe lies at w = {:.3g} D from the start, below a flat surface, and strains are small. Formulas "
        "with heave are for a pipe that was pushed there.",
        driven::points_of(run).first_w / run.scale.width);
  if (driven::starts_embedded(run))
    return fmt::format(
        "In this run the pipe is wished in place at w = {:.3g} D and moves with large strains from there: the soil heaves beside it. "
        "Formulas for a pipe wished in place take a flat surface.",
        driven::points_of(run).first_w / run.scale.width);
  return "In this run the pipe is pushed in from the surface: the soil heaves beside it. Formulas for a pipe wished in place take a flat "
         "surface and leave this out.";
}

std::string remark_on_ground(const driven::DrivenRun& run)
{
  const Real x = base::circle_of(run.settings)->center[0], reach = 2 * run.scale.width;
  const auto [low, high] = run.record.ground.line.heights(x - reach, x + reach);
  return fmt::format("All formulas here are for a level bed. The ground of this run is not: within 2 D of the pipe's start it rises and "
                     "falls by {:.2g} D. They "
                     "are out of range, and show the order of magnitude only; forces are horizontal and vertical, and w is measured from "
                     "the ground below the pipe's axis.",
                     (high - low) / run.scale.width);
}

/// The first drag where H breaks out, begins to slide, or is largest; empty where it has no such point.
std::optional<ComparedState> peak_of(const driven::DrivenRun& run, const driven::RunPoints& points, Real& H)
{
  const driven::Resistance resistance = driven::resistance_of(run);
  using Point = ComparedState::Point;
  const Point point = resistance.breakout ? Point::peak : resistance.onset ? Point::onset : Point::largest;
  const std::optional<driven::Resistance::Point> peak = point == Point::onset     ? driven::Resistance::Point{0, *resistance.onset}
                                                        : point == Point::largest ? resistance.largest
                                                                                  : resistance.breakout;
  if (!peak || run.history.rows() == 0) return {};
  const driven::Path path = driven::path_of(run.history, run.stages);
  const driven::DragPath& drag = path.main_drag();
  const Real half = base::averaging_half(run.scale);
  const bool small_strain = run.settings.small_strain();
  H = peak->H;
  // A held V is not there yet when the drag begins.
  const Real there = record::TravelCurve(drag.travel, drag.V).at(peak->u, half);
  const Real V = point == Point::onset ? run.results().main_drag().V.value_or(there) : there;
  return ComparedState{ComparedState::Kind::peak,
                       peak->u,
                       small_strain ? points.first_w : record::TravelCurve(drag.travel, drag.w).at(peak->u, half),
                       V,
                       {},
                       point};
}

/// Unloading and other stages may lie between the push and the drag.
Real w_where_the_drag_begins(const driven::DrivenRun& run, const driven::RunPoints& points)
{
  if (run.settings.small_strain()) return points.first_w;  // small strains leave it there
  const driven::Path path = run.history.rows() > 0 ? driven::path_of(run.history, run.stages) : driven::Path{};
  if (!path.main_drag().w.empty() && std::isfinite(path.main_drag().w.front())) return path.main_drag().w.front();
  return points.push_end ? points.push_end->w : points.first_w;
}

/// Comparisons of the first drag with the formulas of breakout, which at_peak(w, V, H) makes.
template <class AtPeak>
void add_breakout(PublishedValues& values, const driven::DrivenRun& run, const driven::RunPoints& points, Real part, const AtPeak& at_peak)
{
  Real H = nan;
  if (std::optional<ComparedState> peak = peak_of(run, points, H)) {
    peak->V /= part;
    peak->comparisons = at_peak(peak->w, peak->V, H / part);
    if (!peak->comparisons.empty()) values.states.push_back(*peak);
  }
  const Real w = w_where_the_drag_begins(run, points);
  const auto breakout = driven::resistance_of(run).breakout;
  const Real u = breakout ? breakout->u : nan;
  values.states.push_back({ComparedState::Kind::breakout, u, w, nan, displacement_at_breakout(run.scale.width, w, u)});
}

void put_out_of_range(ComparedState& state, const char* range)
{
  for (Comparison& comparison : state.comparisons) {
    comparison.published.valid = false;
    comparison.published.source.range = range;
  }
}

/// Each drag of a diameter or more: the first with its residual beside what that is said to be, those that follow in clay beside sweeps between berms.
void add_sweeps(PublishedValues& values, const driven::DrivenRun& run, const PipeSoil& soil, Real part)
{
  const auto* clay = std::get_if<ClayAround>(&soil);
  if (run.history.rows() == 0 || run.settings.small_strain()) return;
  const driven::Path path = driven::path_of(run.history, run.stages);
  const driven::Results results = run.results();
  const Real D = run.scale.width, half = base::averaging_half(run.scale);
  bool swept = false;
  for (std::size_t k = 0; k < path.drags.size(); ++k) {
    const driven::DragPath& travelled = path.drags[k];
    const auto drag = std::ranges::find(results.drags, travelled.stage.name, &driven::DragResults::stage);
    // A force that is given is no resistance.
    if (drag == results.drags.end() || drag->moved || !drag->end || drag->end->u < (1 - 1e-6) * D) continue;
    if (swept && clay == nullptr) break;
    const driven::Resistance resistance = driven::resistance_in(path, k, run.scale);
    SweepResults sweep{travelled.w.front(), drag->end->w, drag->end->V / part,
                       record::TravelCurve(travelled.travel, travelled.H).at(drag->end->u / 2, half) / part};
    if (resistance.residual) {
      sweep.residual = *resistance.residual / part;
      sweep.w_residual = record::TravelCurve(travelled.travel, travelled.w).at(*resistance.residual_at, half);
    }
    if (resistance.berm) sweep.berm = *resistance.berm / part;
    std::vector<Comparison> comparisons = clay == nullptr ? sand_after_sweep(std::get<SandAround>(soil), sweep)
                                          : swept         ? clay_between_berms(*clay, sweep)
                                                          : clay_after_sweep(*clay, sweep);
    if (!swept && k == path.main) {
      const std::vector<Comparison> displacement = displacement_to_the_residual(D, resistance.residual_from.value_or(nan));
      comparisons.insert(comparisons.end(), displacement.begin(), displacement.end());
    }
    values.states.push_back(
        {ComparedState::Kind::end_of_drag, drag->end->u, sweep.w, sweep.V, std::move(comparisons), {}, drag->stage, nan, sweep.w_begin});
    swept = true;
  }
}

Real H_at(const driven::RunPoints& points, Real u)
{
  for (const driven::DragPoint& p : points.drag)
    if (p.u == u) return p.H;
  return nan;
}

}  // namespace

std::vector<Comparison> with_estimates(const char* quantity, Comparison::Unit unit, Real berm, const formulas::Estimates& estimates,
                                       const std::string& about)
{
  const std::string before = about.empty() ? "" : about + ", ";
  return {{quantity, unit, berm, estimates.low, before + "LE, low estimate"},
          {quantity, unit, berm, estimates.best, before + "BE, best estimate"},
          {quantity, unit, berm, estimates.high, before + "HE, high estimate"}};
}

std::vector<Comparison> displacement_at_breakout(Real diameter, Real w, Real u)
{
  return with_estimates("u at breakout", Comparison::Unit::length, u, formulas::f114_breakout_displacement(diameter, w), "");
}

std::vector<Comparison> displacement_to_the_residual(Real diameter, Real u)
{
  return with_estimates("u to the residual", Comparison::Unit::length, u, formulas::f114_residual_displacement(diameter), "");
}

PublishedValues published_beside(const driven::DrivenRun& run)
{
  PublishedValues values;
  const PipeSoil soil = pipe_soil(run.record);
  if (const auto* no_formula = std::get_if<NoFormula>(&soil)) {
    values.remarks.push_back(no_formula->why);
    return values;
  }
  values.states = states_of(run);
  const driven::RunPoints points = driven::points_of(run);
  const bool drags = !run.results().main_drag().moved && (!points.drag.empty() || driven::resistance_of(run).breakout);
  const std::vector<driven::UpliftResults> uplifts = run.results().uplifts;
  if (values.states.empty() && !drags && uplifts.empty()) {
    values.remarks.emplace_back("This run reached no state that a formula can be compared with.");
    return values;
  }
  values.remarks.push_back(remark_on_place(run));
  if (base::modelled_part(run.settings) < 1)
    values.remarks.emplace_back(
        "This run models half of the pipe beside an axis of symmetry. Here its forces are doubled: those of the whole pipe.");

  const auto* sand = std::get_if<SandAround>(&soil);
  const auto* clay = std::get_if<ClayAround>(&soil);
  const bool heaves = !run.settings.small_strain() && points.push_end.has_value();
  const Real part = base::modelled_part(run.settings);
  for (ComparedState& state : values.states) {
    state.V /= part;
    if (state.kind == ComparedState::Kind::drag) {
      if (clay != nullptr) state.comparisons = clay_in_drag(*clay, state.w, state.V, H_at(points, state.u) / part);
    } else {
      state.comparisons = sand != nullptr ? sand_in_push(*sand, state.w, state.V) : clay_in_push(*clay, state.w, state.V, heaves);
    }
  }
  std::erase_if(values.states, [](const ComparedState& state) { return state.comparisons.empty(); });
  const bool level = run.record.ground.line.level();
  if (drags)
    add_breakout(values, run, points, part,
                 [&](Real w, Real V, Real H) { return sand != nullptr ? sand_in_drag(*sand, w, V, H) : clay_at_breakout(*clay, w, V, H); });
  add_sweeps(values, run, soil, part);
  for (const driven::UpliftResults& lift : uplifts)
    if (std::vector<Comparison> beside = in_uplift(soil, lift.w_begin, lift.largest.H / part, lift.largest.u); !beside.empty())
      values.states.push_back({ComparedState::Kind::uplift, lift.largest.u, lift.w_begin, nan, std::move(beside),
                               lift.falls() ? ComparedState::Point::peak : ComparedState::Point::largest, lift.stage});
  if (clay != nullptr)
    for (ComparedState& state : values.states) state.strength = clay->at(state.w).strength;
  if (sand != nullptr && !sand->has_little_cohesion())
    for (ComparedState& state : values.states) put_out_of_range(state, "c cot φ up to 5 % of γ' D");
  if (!level) {
    values.remarks.insert(values.remarks.begin(), remark_on_ground(run));
    for (ComparedState& state : values.states) put_out_of_range(state, "a level bed");
  }
  if (clay != nullptr && !points.drag.empty())
    values.remarks.emplace_back("Formulas for H give the ultimate resistance; early in a drag H is not yet fully mobilised.");
  const std::vector<std::string> of_soil = sand != nullptr ? remarks_on(*sand) : remarks_on(*clay);
  values.remarks.insert(values.remarks.end(), of_soil.begin(), of_soil.end());
  return values;
}

}  // namespace berm::pipe
