// SPDX-License-Identifier: BSD-3-Clause
#include "springs/springs.hpp"

#include "formulas/axial.hpp"
#include "formulas/rebound.hpp"
#include "input/message_text.hpp"
#include "material/clay.hpp"
#include "os/error.hpp"
#include "structures/base/soil_words.hpp"
#include "structures/driven/resistance.hpp"
#include "structures/driven/run_points.hpp"
#include "structures/pipe/axial_results.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <limits>

namespace berm::springs {
namespace {

using record::TravelCurve;

/// Where a curve first reaches F, in the straight line between its points; NaN where it does not, or begins above.
Real first_at(const Points& curve, Real F)
{
  if (curve.empty() || curve.front().F >= F) return nan;
  Point before{0, 0};
  for (const Point& point : curve) {
    if (point.F >= F && point.F > before.F)
      return before.x + (point.x - before.x) * std::clamp<Real>((F - before.F) / (point.F - before.F), 0, 1);
    before = point;
  }
  return nan;
}

Lateral lateral_of(const driven::Path& path, std::size_t number, const driven::DragResults& results, const driven::BodyScale& scale)
{
  const driven::DragPath& drag = path.drags[number];
  const TravelCurve H(drag.travel, drag.H);
  const driven::Resistance resistance = driven::resistance_in(path, number, scale);
  Lateral lateral;
  lateral.stage = drag.stage.name;
  lateral.travel = resistance.travel;
  lateral.V = results.V.value_or(nan);
  if (results.end) lateral.end = results.end->H;
  if (H.travel().size() < 3) return lateral;
  const TravelCurve smooth = H.smoothed(base::averaging_half(scale));
  for (std::size_t k = 0; k < smooth.travel().size(); ++k) lateral.curve.push_back({smooth.travel()[k], smooth.value()[k]});
  lateral.breaks = resistance.breakout.has_value();
  if (resistance.berm && !lateral.breaks)  // the largest H is that against the berm
    lateral.peak = resistance.residual.value_or(nan), lateral.u_peak = first_at(lateral.curve, lateral.peak);
  else if (const auto& peak = lateral.breaks ? resistance.breakout : resistance.largest)
    lateral.peak = peak->H, lateral.u_peak = peak->u;
  if (const auto& largest = resistance.largest;
      lateral.breaks && !resistance.berm && largest->u > lateral.u_peak && largest->H > lateral.peak)
    lateral.largest = largest->H, lateral.u_largest = largest->u;
  for (std::size_t k = 0; k < mobilised_parts.size(); ++k)
    lateral.mobilised[k] = first_at(lateral.curve, mobilised_parts[k] * lateral.peak);
  lateral.residual = resistance.residual.value_or(nan);
  lateral.berm = resistance.berm.value_or(nan);
  lateral.u_residual = resistance.residual_from.value_or(nan);
  return lateral;
}

/// The slope of V over w by the line fitted to w over V, which is what the stage drives; NaN where they do not go together.
Real stiffness_of(const std::vector<Index>& rows, const std::vector<Real>& w, const std::vector<Real>& V)
{
  constexpr Real least_correlation = 0.7;
  Real n = 0, mean_w = 0, mean_V = 0;
  for (const Index k : rows) mean_w += w[k], mean_V += V[k], ++n;
  mean_w /= n, mean_V /= n;
  Real wV = 0, VV = 0, ww = 0;
  for (const Index k : rows) {
    const Real dw = w[k] - mean_w, dV = V[k] - mean_V;
    wV += dw * dV, VV += dV * dV, ww += dw * dw;
  }
  return std::abs(wV) > least_correlation * std::sqrt(ww * VV) ? VV / wV : nan;
}

Unloading unloading_of(const std::string& stage, std::vector<Index> rows, const run_folder::History& history)
{
  const std::vector<Real>&w = history["w_m"], &V = history.by_label("V");
  if (rows.front() > 0) rows.insert(rows.begin(), rows.front() - 1);
  return {stage, V[rows.front()], V[rows.back()], stiffness_of(rows, w, V)};
}

/// The soil at an embedment.
std::optional<material::Material> soil_at(const record::RunRecord& run, Real w)
{
  const std::optional<settings::BodySoil> soil = base::touched_soil(run);
  if (!soil) return {};
  return soil->at("", base::soil_depth(run.settings, run.ground, w));
}

/// The strength of the soil at an embedment, Pa; 0 where it has friction or none is known.
Real strength_at(const record::RunRecord& run, Real w)
{
  const std::optional<material::Material> soil = soil_at(run, w);
  const std::optional<material::Strength> strength = soil ? strength_at_rest(*soil) : std::nullopt;
  return strength && strength->friction_angle == 0 ? strength->cohesion : 0;
}

/// Undisturbed strength of the clay below the pipe over that remoulded; 1 of other soil.
Real sensitivity_of(const record::RunRecord& run)
{
  const std::optional<settings::BodySoil> soil = base::touched_soil(run);
  const auto* clay = soil ? soil->materials.front().get_if<material::Clay>() : nullptr;
  return clay == nullptr ? 1 : clay->sensitivity;
}

/// Undrained resistance that is remoulded, and grows by consolidation under the V of the state. OCR is by the flooded pipe, where it was.
void consolidate(Axial& axial, Real D, const driven::State& state, const driven::States& states, Real roughness, const AxialClay& clay)
{
  const driven::State* flooded = driven::find_state(states, "flooded");
  const Real preload = flooded != nullptr && flooded->row <= state.row ? flooded->V / state.V : 1,
             remoulded = axial.undrained / axial.sensitivity;
  const formulas::Formula grown =
      formulas::axial_consolidated(D, state.w, state.V, clay.consolidation, {*clay.strength_ratio, clay.exponent, roughness, preload});
  axial.undrained = std::max(remoulded, grown.value);
  axial.set_up.push_back({"consolidation", clay.consolidation, remoulded, axial.undrained});
  axial.strength = fmt::format("clay consolidated to U = {:.3g} (s_u/sigma'_v = {:.3g})", clay.consolidation, *clay.strength_ratio);
  axial.undrained_source = citation(grown.source);
}

Axial axial_of(const driven::DrivenRun& run, const driven::State& state, const driven::States& states, const AxialClay& clay)
{
  Axial axial;
  if (state.V <= 0) return axial;
  const Real D = run.scale.width;
  const formulas::Formula wedging = formulas::wedging_factor(D, state.w);
  axial.wedging = wedging.value;
  const contact::ContactSettings* contact = base::contact_of_body(run.settings);
  if (contact == nullptr) return axial;
  if (contact->friction_angle > 0) {
    const formulas::Formula drained = formulas::axial_drained(D, state.w, contact->friction_angle, state.V);
    axial.drained = drained.value, axial.drained_source = citation(drained.source);
    for (const base::SurfaceForce& force : base::surface_forces_of(run.record))
      if (force.stage == state.stage && force.V > 0) {
        axial.wedging = force.N_eff / force.V, axial.wedging_source = "computed effective normal force divided by V, " + state.stage;
        axial.drained = std::tan(contact->friction_angle) * force.N_eff;
        axial.drained_source = "axial_friction_of_" + state.stage + ": friction of the interface times the computed effective normal force";
        axial.settled = drained.value, axial.settled_source = citation(drained.source);
      }
    const std::vector<std::string>& stages = run.record.history.stage;
    for (const pipe::AxialGain& gain : pipe::axial_gains(run.record))
      if (std::ranges::find(stages, gain.stage) - stages.begin() <= state.row)
        axial.set_up.push_back({gain.stage, gain.degree, gain.before, gain.after});
  }
  const Real strength = strength_at(run.record, state.w),
             adhesion = contact->adhesion > 0 ? contact->adhesion : contact->adhesion_factor * strength;
  if (adhesion > 0) {
    const formulas::Formula undrained = formulas::axial_undrained(D, state.w, adhesion);
    axial.undrained = undrained.value;
    axial.strength = contact->adhesion > 0 ? "given adhesion" : "undisturbed clay";
    axial.sensitivity = std::max(contact->adhesion_sensitivity, contact->adhesion > 0 ? 1 : sensitivity_of(run.record));
    axial.undrained_source = citation(undrained.source) + ", with the " +
                             (contact->adhesion > 0 ? "adhesion of the case" : "strength of undisturbed clay at the invert");
    if (clay.strength_ratio) consolidate(axial, D, state, states, contact->adhesion_factor > 0 ? contact->adhesion_factor : 1, clay);
    if (clay.interface_angle && std::isnan(axial.drained)) {
      const formulas::Formula drained = formulas::axial_drained(D, state.w, *clay.interface_angle, state.V);
      axial.drained = drained.value, axial.drained_source = citation(drained.source);
    }
  }
  axial.residual = axial.breakout() / axial.sensitivity;
  axial.mobilise(D);
  return axial;
}

/// Lengths and forces per length times the scale; stresses, and so stiffness of V over w, are those of the model.
void carry_to_prototype(Springs& s, Real scale)
{
  const auto carry = [&](Points& points) {
    for (Point& point : points) point.x *= scale, point.F *= scale;
  };
  s.scale = scale;
  for (Real* number : {&s.V, &s.diameter, &s.embedment, &s.weight, &s.strength, &s.axial.drained, &s.axial.undrained, &s.axial.settled,
                       &s.axial.residual, &s.vertical.preload})
    *number *= scale;
  for (SetUp& rest : s.axial.set_up) rest.before *= scale, rest.after *= scale;
  s.axial.mobilise(s.diameter);  // its millimetres are those of the prototype
  for (Lateral& l : s.lateral) {
    for (Real* number : {&l.V, &l.peak, &l.u_peak, &l.largest, &l.u_largest, &l.residual, &l.berm, &l.end, &l.u_residual, &l.travel})
      *number *= scale;
    for (Real& u : l.mobilised) u *= scale;
    carry(l.curve);
  }
  carry(s.vertical.curve);
  for (Unloading& u : s.vertical.unloading)
    for (Real* number : {&u.V_begin, &u.V_end}) *number *= scale;
}

}  // namespace

Range Axial::cyclic() const
{
  return {std::min(residual, breakout()), breakout(),
          std::max({breakout(), std::isnan(drained) ? breakout() : drained, std::isnan(settled) ? breakout() : settled})};
}

void Axial::mobilise(Real diameter)
{
  if (std::isnan(breakout())) return;
  const auto range = [](const formulas::Estimates& u) { return Range{u.low.value, u.best.value, u.high.value}; };
  u_breakout = range(formulas::f114_axial_breakout_displacement(diameter));
  u_residual = range(formulas::f114_axial_residual_displacement(diameter));
}

std::string axial_displacement_source()
{
  return formulas::citation(formulas::f114_axial_breakout_displacement(1).best.source);
}

Points Lateral::spring() const
{
  Points points{{0, 0}};
  const auto add = [&](Real x, Real F) {
    if (std::isfinite(x) && std::isfinite(F) && x > points.back().x) points.push_back({x, F});
  };
  for (std::size_t k = 0; k < mobilised_parts.size(); ++k) add(mobilised[k], mobilised_parts[k] * peak);
  if (!(peak > 0)) return {};
  if (breaks || std::isnan(residual) || !std::isnan(berm)) add(u_peak, peak);
  if (u_largest < u_residual) add(u_largest, largest);
  add(u_residual, residual);
  add(u_largest, largest);
  const Real last = !std::isnan(residual) ? residual : std::isnan(berm) ? end : peak;  // what a berm adds is none of the drag
  add(travel, breaks ? last : std::max(last, points.back().F));
  return points;
}

Real Lateral::stiffness() const
{
  constexpr std::size_t half = 1;
  for (std::size_t k = half; k < mobilised_parts.size(); ++k)
    if (std::isfinite(mobilised[k])) return mobilised_parts[k] * peak / mobilised[k];
  return peak / u_peak;
}

namespace {

/// The state that is asked for. Throws InputError where the run has it not.
driven::State state_of(const driven::States& states, const std::string& asked, const driven::Results& results, const std::string& folder)
{
  // Where the history is lost the results still know the end of the push.
  if (states.empty() && results.push_end && (asked.empty() || asked == "touchdown"))
    return {"touchdown", "end of the push", "", 0, 0, results.push_end->w, 0, results.push_end->V};
  for (const char* name : {"operation", "touchdown"})
    if (asked.empty())
      if (const driven::State* state = driven::find_state(states, name)) return *state;
  if (const driven::State* state = driven::find_state(states, asked)) return *state;
  std::vector<std::string> names;
  for (const driven::State& state : states) names.push_back(state.name);
  if (asked.empty() && !names.empty()) return states.back();
  throw InputError(fmt::format("--state: {} has no state {}{}", folder, input::in_quotes(asked), input::suggestion(asked, names)));
}

/// The row of the state of the pipe's life that follows, beyond all rows where none does.
Index next_state(const driven::States& states, const driven::State& state)
{
  Index next = std::numeric_limits<Index>::max();
  for (const char* name : driven::state_names)
    if (const driven::State* other = driven::find_state(states, name); other != nullptr && other->row > state.row)
      next = std::min(next, other->row);
  return next;
}

/// Whether a drag begins in the state, before the next one, and does not lay the pipe.
bool begins_in(const driven::DragPath& drag, const driven::States& states, const driven::State& state, const Selection& selection)
{
  const Index begin = drag.rows.front();
  return !drag.stage.lays && (selection.whole_life || (begin >= state.row && begin < next_state(states, state)));
}

/// Whether the springs of a drag are asked for.
bool is_asked(const driven::DragPath& drag, const driven::States& states, const driven::State& state, const Selection& selection)
{
  if (!selection.travels.empty()) return std::ranges::find(selection.travels, drag.stage.name) != selection.travels.end();
  return !drag.stage.by_force && begins_in(drag, states, state, selection);
}

std::string by_force_words(const driven::DragPath& drag)
{
  return fmt::format("{} is driven by a force: it gives displacements, no resistance", input::in_quotes(drag.stage.name));
}

/// The name of the state of the pipe's life in which a drag begins; "" where there is none.
std::string life_at(const driven::States& states, const driven::DragPath& drag)
{
  const driven::State* latest = nullptr;
  for (const char* name : driven::state_names)
    if (const driven::State* state = driven::find_state(states, name); state != nullptr && state->row <= drag.rows.front())
      if (latest == nullptr || state->row >= latest->row) latest = state;
  return latest == nullptr ? "" : latest->name;
}

void check_travels(const driven::Path& path, const std::vector<std::string>& travels, const std::string& folder)
{
  std::vector<std::string> names;
  for (const driven::DragPath& drag : path.drags) names.push_back(drag.stage.name);
  for (const std::string& travel : travels) {
    const auto found = std::ranges::find(names, travel);
    if (found == names.end())
      throw InputError(fmt::format("--travels: {} has no drag {}{}", folder, input::in_quotes(travel), input::suggestion(travel, names)));
    const driven::DragPath& drag = path.drags[static_cast<std::size_t>(found - names.begin())];
    if (drag.stage.by_force) throw InputError(fmt::format("--travels: {}: {}", folder, by_force_words(drag)));
  }
}

/// V over w of the push.
Points virgin_of(const driven::Results& results, Real D)
{
  Points curve;
  for (const driven::PushPoint& p : results.push) curve.push_back({p.w, p.V});
  if (const auto& end = results.push_end)
    if (curve.empty() || end->w > curve.back().x + driven::same_point * D) curve.push_back({end->w, end->V});
  return curve;
}

/// The largest V of the push and of the states up to this one.
Real preload_of(const Points& virgin, const driven::Results& results, const driven::States& states, const driven::State& state)
{
  Real most = results.push_end ? results.push_end->V : 0;
  for (const Point& p : virgin) most = std::max(most, p.F);
  for (const driven::State& one : states)
    if (one.row <= state.row && one.V > most) most = one.V;
  return most;
}

/// The row from which on the bed is that of the state: what was found before is of soil that was dug, placed or moved away since.
Index bed_since(const std::optional<driven::SoilWork>& work)
{
  return work ? work->row : 0;
}

/// The V of the bed downwards, and the slopes of pushes before the next state, but for lifts.
Vertical vertical_of(const driven::DrivenRun& run, const driven::Results& results, const driven::Path& path, const driven::States& states,
                     const driven::State& state, const std::optional<driven::SoilWork>& work)
{
  Vertical vertical;
  const std::vector<Index>& pushed = path.push.rows;
  if (!pushed.empty() && pushed.front() < bed_since(work)) {
    vertical.without_curve = fmt::format("the push was into soil that no longer exists in state {}: {}", state.name, work->words);
  } else if (!starts_embedded(run)) {
    vertical.curve = virgin_of(results, run.scale.width);
    vertical.preload = preload_of(vertical.curve, results, states, state);
  } else if (!pushed.empty()) {
    vertical.unloading.push_back(unloading_of("push", pushed, run.history));
  }
  if (vertical.curve.empty() && vertical.without_curve.empty()) vertical.without_curve = "no push begins at the seabed";
  const Index next = next_state(states, state);
  for (const driven::OtherPush& push : path.other_pushes)
    if (!push.lifts && push.rows.front() <= next && push.rows.front() >= bed_since(work))
      vertical.unloading.push_back(unloading_of(push.stage, push.rows, run.history));
  if (const std::optional<material::Material> soil = soil_at(run.record, state.w); soil && !vertical.curve.empty()) {
    const material::YoungPoisson elastic = young_poisson(*soil);
    const formulas::Formula rebound = formulas::pipe_rebound_stiffness(elastic.shear_modulus(), elastic.poisson_ratio);
    if (rebound.valid) vertical.rebound = rebound.value, vertical.rebound_source = citation(rebound.source);
  }
  return vertical;
}

/// Why a drag by a force has no spring, and why there is none at all.
std::vector<std::string> missing_lateral(const Springs& s, const driven::Path& path, const driven::States& states,
                                         const driven::State& state, const Selection& selection)
{
  std::vector<std::string> lines;
  if (!selection.travels.empty()) return lines;
  for (const driven::DragPath& drag : path.drags)
    if (drag.stage.by_force && begins_in(drag, states, state, selection)) lines.push_back(by_force_words(drag));
  if (!s.lateral.empty() || !lines.empty()) return lines;
  const bool others = std::ranges::any_of(path.drags, [](const driven::DragPath& drag) { return !drag.stage.by_force; });
  return {fmt::format("there is no lateral spring: no drag begins in state {}{}", s.state,
                      others ? " before the next state; --travels names others" : "")};
}

/// Why travels have no spring.
std::vector<std::string> without_spring(const Springs& s)
{
  std::vector<std::string> lines;
  for (const Lateral& l : s.lateral)
    if (l.only_berm())
      lines.push_back(
          fmt::format("{} has no lateral spring: its H increases to {:.6g} N/m against a berm, with neither a peak nor a residual before; "
                      "curves.csv (--to table) has its H against u",
                      l.stage, l.berm));
  return lines;
}

/// Drags that were asked for, in a bed that is no longer there.
std::vector<std::string> moved_away(const std::vector<std::string>& drags, const Springs& s, const std::optional<driven::SoilWork>& work)
{
  std::vector<std::string> lines;
  for (const std::string& drag : drags)
    lines.push_back(
        fmt::format("{} has no lateral spring in state {}: the soil that it moved on no longer exists: {}", drag, s.state, work->words));
  return lines;
}

/// Why there is no axial spring.
std::vector<std::string> missing_axial(const Springs& s, const driven::Results& results, const std::optional<driven::SoilWork>& work)
{
  if (s.axial.drained > 0 || s.axial.undrained > 0) return {};
  if (work && s.V > 0)
    return {fmt::format("there is no axial spring: the strength of the soil at the pipe is not known after {}", work->words)};
  if (!(s.V <= 0)) return {"there is no axial spring: the interface has neither friction nor adhesion that are known"};
  std::vector<std::string> lines = {
      fmt::format("there is no axial spring: V in state {} is {:.4g} N/m, which does not press the pipe onto the bed", s.state, s.V)};
  for (const driven::UpliftResults& lift : results.uplifts)
    lines.push_back(fmt::format("resistance to uplift is {}.R_max in summary.json", lift.stage));
  return lines;
}

}  // namespace

Springs springs_of(const record::RunRecord& record, const Selection& selection)
{
  const std::string folder = record.folder.string();
  if (!base::drives_a_body(record.settings) || record.settings.geometry != settings::Geometry::plane_strain)
    throw RunError(fmt::format("{} is not a plane-strain run of a pipe: springs are forces per length of pipe", folder));
  const driven::DrivenRun run(record);
  const driven::Results results = run.results();
  const driven::Path path = run.history.rows() > 0 ? path_of(run.history, run.stages) : driven::Path{};
  if (results.push.empty() && !results.push_end && path.drags.empty() && path.other_pushes.empty())
    throw RunError(fmt::format("{} has neither pushed nor dragged its pipe yet", folder));
  const auto drags = std::count_if(run.stages.begin(), run.stages.end(),
                                   [](const driven::Stage& stage) { return stage.kind == settings::StageKind::drag; });
  if (record.end == record::RunEnd::finished && static_cast<std::ptrdiff_t>(path.drags.size()) < drags)
    throw RunError(
        fmt::format("{} is finished, but its history has rows of {} of {} drags only: it is damaged", folder, path.drags.size(), drags));
  const driven::States states = driven::states_of(record);
  const driven::State state = state_of(states, selection.state, results, folder);
  check_travels(path, selection.travels, folder);
  Springs springs;
  springs.run = record.name, springs.state = state.name, springs.state_origin = state.origin;
  springs.V = state.V, springs.embedment = state.w;
  springs.diameter = run.scale.width;
  if (run.scale.unit_weight > 0) springs.weight = run.scale.unit_weight * run.scale.width * run.scale.width;
  if (const Real strength = strength_at(record, state.w); strength > 0) springs.strength = strength * run.scale.width;
  const std::optional<driven::SoilWork> work = driven::last_soil_work(record, state.row);
  springs.vertical = vertical_of(run, results, path, states, state, work);
  std::vector<std::string> of_another_bed;
  for (std::size_t k = 0; k < path.drags.size(); ++k)
    if (is_asked(path.drags[k], states, state, selection)) {
      if (path.drags[k].rows.back() < bed_since(work)) {
        of_another_bed.push_back(path.drags[k].stage.name);
        continue;
      }
      const auto found = std::ranges::find(results.drags, path.drags[k].stage.name, &driven::DragResults::stage);
      springs.lateral.push_back(lateral_of(path, k, found == results.drags.end() ? driven::DragResults{} : *found, run.scale));
      springs.lateral.back().state = life_at(states, path.drags[k]);
    }
  springs.axial = axial_of(run, state, states, selection.clay);
  if (work) {  // the strength that it takes is that of undisturbed soil
    springs.axial.undrained = nan, springs.axial.strength.clear(), springs.axial.sensitivity = 1;
    springs.axial.residual = springs.axial.drained;
    if (std::isnan(springs.axial.drained)) springs.axial = {};
  }
  if (has_prototype(run.scale)) carry_to_prototype(springs, run.scale.gravity_level);
  springs.missing = missing_lateral(springs, path, states, state, selection);
  for (const std::string& line : without_spring(springs)) springs.missing.push_back(line);
  for (const std::string& line : moved_away(of_another_bed, springs, work)) springs.missing.push_back(line);
  if (springs.vertical.curve.empty()) springs.missing.push_back("there is no vertical spring: " + springs.vertical.without_curve);
  for (const std::string& line : missing_axial(springs, results, work)) springs.missing.push_back(line);
  return springs;
}

}  // namespace berm::springs
