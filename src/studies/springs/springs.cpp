// SPDX-License-Identifier: BSD-3-Clause
#include "springs/springs.hpp"

#include "core/error.hpp"
#include "structures/formulas/axial.hpp"
#include "structures/driven/results/resistance.hpp"
#include "structures/driven/results/run_points.hpp"

#include <algorithm>
#include <fmt/format.h>

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

Lateral lateral_of(const driven::DragPath& drag, const driven::DragResults& results, const driven::BodyScale& scale)
{
  const TravelCurve H(drag.travel, drag.H);
  const driven::Resistance resistance = driven::resistance_to(H, scale);
  Lateral lateral;
  lateral.stage = drag.stage.name;
  lateral.travel = resistance.travel;
  lateral.V = results.V.value_or(nan);
  if (results.end) lateral.end = results.end->H;
  if (H.travel().size() < 3) return lateral;
  const TravelCurve smooth = H.smoothed(base::averaging_half(scale));
  for (std::size_t k = 0; k < smooth.travel().size(); ++k) lateral.curve.push_back({smooth.travel()[k], smooth.value()[k]});
  lateral.breaks = resistance.breakout.has_value();
  if (const auto& peak = lateral.breaks ? resistance.breakout : resistance.largest) lateral.peak = peak->H, lateral.u_peak = peak->u;
  for (std::size_t k = 0; k < mobilised_parts.size(); ++k)
    lateral.mobilised[k] = first_at(lateral.curve, mobilised_parts[k] * lateral.peak);
  lateral.residual = resistance.residual.value_or(nan);
  lateral.u_residual = resistance.residual_from.value_or(nan);
  return lateral;
}

Unloading unloading_of(const std::string& stage, const std::vector<Index>& rows, const run_folder::History& history)
{
  const std::vector<Real>&w = history["w_m"], &V = history.by_label("V");
  const Index first = std::max(rows.front() - 1, 0), last = rows.back();
  const Real way = w[first] - w[last];
  return {stage, V[first], V[last], way != 0 ? (V[first] - V[last]) / way : nan};
}

Axial axial_of(const driven::DrivenRun& run, Real w, Real V)
{
  Axial axial;
  const Real D = run.scale.width;
  axial.wedging = formulas::wedging_factor(D, w).value;
  const contact::ContactSettings* contact = base::contact_of_body(run.settings);
  if (contact == nullptr) return axial;
  if (contact->friction_angle > 0) axial.drained = formulas::axial_drained(D, w, contact->friction_angle, V).value;
  const Real adhesion = contact->adhesion > 0 ? contact->adhesion : contact->adhesion_factor * run.scale.strength;
  if (adhesion > 0) axial.undrained = formulas::axial_undrained(D, w, adhesion).value;
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
  for (Real* number : {&s.diameter, &s.embedment, &s.weight, &s.strength, &s.axial.drained, &s.axial.undrained}) *number *= scale;
  s.axial.mobilise(s.diameter);  // its millimetres are those of the prototype
  for (Lateral& l : s.lateral) {
    for (Real* number : {&l.V, &l.peak, &l.u_peak, &l.residual, &l.end, &l.u_residual, &l.travel}) *number *= scale;
    for (Real& u : l.mobilised) u *= scale;
    carry(l.curve);
  }
  carry(s.vertical.curve);
  for (Unloading& u : s.vertical.unloading)
    for (Real* number : {&u.V_begin, &u.V_end}) *number *= scale;
}

}  // namespace

void Axial::mobilise(Real diameter)
{
  if (std::isnan(drained) && std::isnan(undrained)) return;
  const formulas::Estimates u = formulas::f114_axial_breakout_displacement(diameter);
  breakout_low = u.low.value, breakout = u.best.value, breakout_high = u.high.value;
}

std::string axial_breakout_source()
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
  if (breaks || std::isnan(residual)) add(u_peak, peak);
  add(u_residual, residual);
  const Real last = std::isnan(residual) ? end : residual;
  add(travel, breaks ? last : std::max(last, points.back().F));
  return points;
}

Springs springs_of(const record::RunRecord& record)
{
  const std::string folder = record.folder.string();
  if (!base::drives_a_body(record.settings) || record.settings.geometry != problem::Geometry::plane_strain)
    throw RunError(fmt::format("{} is no run of a pipe in plane strain: springs are forces per length of pipe", folder));
  const driven::DrivenRun run(record);
  const driven::Results results = run.results();
  const driven::Path path = run.history.rows() > 0 ? pipe_path(run.history, run.stages) : driven::Path{};
  if (results.push.empty() && !results.push_end && path.drags.empty())
    throw RunError(fmt::format("{} has neither pushed nor dragged its pipe yet", folder));
  const auto drags = std::count_if(run.stages.begin(), run.stages.end(),
                                   [](const driven::Stage& stage) { return stage.kind == problem::StageKind::drag; });
  if (record.end == record::RunEnd::finished && static_cast<std::ptrdiff_t>(path.drags.size()) < drags)
    throw RunError(
        fmt::format("{} is finished, but its history has rows of {} of {} drags only: it is damaged", folder, path.drags.size(), drags));
  Springs springs;
  springs.diameter = run.scale.width;
  if (run.scale.unit_weight > 0) springs.weight = run.scale.unit_weight * run.scale.width * run.scale.width;
  if (run.scale.strength > 0) springs.strength = run.scale.strength * run.scale.width;
  if (const auto& end = results.push_end)
    springs.embedment = end->w;
  else if (run.history.rows() > 0)
    springs.embedment = run.history["w_m"][path.drags.empty() ? run.history.rows() - 1 : path.drags[0].rows.front()];
  if (!starts_embedded(run)) {
    for (const driven::PushPoint& p : results.push) springs.vertical.curve.push_back({p.w, p.V});
    if (const auto& end = results.push_end;
        end && (springs.vertical.curve.empty() || end->w > springs.vertical.curve.back().x + driven::same_point * springs.diameter))
      springs.vertical.curve.push_back({end->w, end->V});
  } else if (!path.push.rows.empty()) {
    springs.vertical.unloading.push_back(unloading_of("push", path.push.rows, run.history));
  }
  for (const driven::OtherPush& push : path.other_pushes)
    springs.vertical.unloading.push_back(unloading_of(push.stage, push.rows, run.history));
  for (std::size_t k = 0; k < path.drags.size(); ++k)
    springs.lateral.push_back(lateral_of(path.drags[k], k < results.drags.size() ? results.drags[k] : driven::DragResults{}, run.scale));
  springs.axial = axial_of(run, springs.embedment, springs.lateral.empty() ? nan : springs.lateral[0].V);
  if (has_prototype(run.scale)) carry_to_prototype(springs, run.scale.gravity_level);
  return springs;
}

}  // namespace berm::springs
