// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/envelope/envelope_test.cpp
#include "envelope/envelope_table.hpp"

#include "record/travel_curve.hpp"
#include "structures/base/driven_body.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::envelope {
namespace {

constexpr std::size_t max_path_points = 100;
constexpr Real first_part = 0.1;     // of what the end meets, up to which soil is elastic
constexpr Real largest_half = 0.05;  // of the travel of a footing, which may be as short as what noise is averaged over

/// V, H, M and w of a stage over its travel, from where it began: the row before its first; of a footing its displacements since then.
struct StagePath {
  record::TravelCurve V, H, w, M, since_w, since_u, since_theta;
};

/// Columns of a history from the row before the first of a stage.
class StageRows {
public:
  StageRows(const run_folder::History& history, const std::string& stage)
      : history_(history),
        first_(std::max<std::ptrdiff_t>(0, std::find(history.stage.begin(), history.stage.end(), stage) - history.stage.begin() - 1))
  {
  }
  std::vector<Real> operator[](const char* label) const
  {
    const std::vector<Real>& column = history_.by_label(label);
    return {column.begin() + first_, column.end()};
  }

private:
  const run_folder::History& history_;
  std::ptrdiff_t first_;
};

StagePath path_of(const StageRows& rows)
{
  const std::vector<Real> u = rows["u"], w = rows["w"];
  std::vector<Real> travel;
  for (std::size_t k = 0; k < u.size(); ++k) travel.push_back(std::hypot(u[k] - u[0], w[k] - w[0]));
  return {{travel, rows["V"]}, {travel, rows["H"]}, {travel, w}, {{}, {}}, {{}, {}}, {{}, {}}, {{}, {}}};
}

/// The same of the middle of the flat base of a footing, at `arm` below the centre that the history is about. In the history w is that of the lowest corner.
/// Finite elements of small strain keep the arms of their forces.
StagePath path_of_base(const StageRows& rows, const base::EmbeddedBody& body, const settings::Case& c)
{
  const bool plane = c.dimension() == 2, small_strain = c.small_strain();
  const std::vector<Real> V = rows["V"], H = rows["H"], moment = rows[plane ? "M" : "Mz"], angle = rows[plane ? "angle" : "anglez"];
  std::vector<Real> u = rows["u"], w = rows["w"], M, travel, since[3];
  for (std::size_t k = 0; k < u.size(); ++k) {
    const Real theta = -angle[k], arm = *body.arm;
    u[k] -= arm * std::sin(theta);
    w[k] -= body.width / 2 * std::abs(std::sin(theta));
    M.push_back(moment[k] + (small_strain ? arm * H[k] : arm * (H[k] * std::cos(theta) + V[k] * std::sin(theta))));
    since[0].push_back(w[k] - w[0]), since[1].push_back(u[k] - u[0]), since[2].push_back(angle[0] - angle[k]);
    travel.push_back(std::hypot(since[0][k], since[1][k], body.width * since[2][k]));
  }
  return {{travel, V}, {travel, H}, {travel, w}, {travel, M}, {travel, since[0]}, {travel, since[1]}, {travel, since[2]}};
}

std::string cell(Real value)
{
  return std::isfinite(value) ? fmt::format("{}", value) : "";
}

}  // namespace

ProbeResult result_of(const Probe& probe, const run_folder::History& history, const base::EmbeddedBody& body)
{
  ProbeResult result;
  const StageRows rows(history, probe.stage);
  const StagePath path = body.arm ? path_of_base(rows, body, probe.settings) : path_of(rows);
  if (path.V.empty() || path.H.empty()) return result;
  Real half = probe.settings.method == settings::Method::fem ? 0 : base::averaging_half_width * body.width;
  if (body.arm) half = std::min(half, largest_half * path.V.end());
  const auto at = [&](Real travel) {
    return EnvelopePoint{path.V.at(travel, half), path.H.at(travel, half), path.w.at(travel, half), path.M.at(travel, half)};
  };
  const Real angle = probe.kind == ProbeKind::swipe ? 0 : probe.angle * degree, turn = probe.turn * degree;
  const auto resistance = [&](const EnvelopePoint& p) {
    const Real flat = probe.turn == 0 ? p.H : p.H * std::cos(turn) + p.M / body.width * std::sin(turn);
    return p.V * std::sin(angle) + flat * std::cos(angle);
  };
  result.travel = path.V.end();
  result.end = at(path.V.end());
  result.growth = 1 - resistance(at((1 - last_part) * path.V.end())) / resistance(result.end);
  if (history.has("unbalance")) result.unbalance = history["unbalance"].back();
  if (history.has("overstress")) result.overstress = history["overstress"].back();
  const auto load_at = [&](Real travel) {  // without an average, which would be over more than what is elastic
    return EnvelopePoint{path.V.at(travel, 0), path.H.at(travel, 0), path.w.at(travel, 0), path.M.at(travel, 0)};
  };
  for (const Real s : path.since_w.travel()) {
    const EnvelopePoint load = load_at(s), before = load_at(0);
    if (s == 0 || resistance(load) - resistance(before) < first_part * resistance(result.end)) continue;
    result.first = {path.since_w.at(s, 0),
                    path.since_u.at(s, 0),
                    path.since_theta.at(s, 0),
                    {load.V - before.V, load.H - before.H, load.w - before.w, load.M - before.M}};
    break;
  }
  if (probe.kind == ProbeKind::swipe) {
    const std::vector<Real>& travel = path.V.travel();
    const std::size_t every = 1 + travel.size() / max_path_points;
    for (std::size_t k = 0; k < travel.size(); k += every) result.path.push_back(at(travel[k]));
  }
  return result;
}

EnvelopeExtremes extremes_of(const std::vector<EnvelopeRow>& rows)
{
  EnvelopeExtremes extremes;
  const auto take = [&](const Probe& probe, const EnvelopePoint& p) {
    const auto larger = [](Real value, Real than) { return std::isfinite(value) && !(value <= than); };
    if (probe.turn == 0 && larger(p.H, extremes.H_max)) extremes.H_max = p.H, extremes.V_at_H_max = p.V;
    if (probe.free_sideways && larger(p.M, extremes.M_max)) extremes.M_max = p.M, extremes.V_at_M_max = p.V;
    if (larger(p.M, extremes.M_largest)) extremes.M_largest = p.M, extremes.H_at_M_largest = p.H;
  };
  for (const EnvelopeRow& row : rows) {
    if (row.probe.angle == 90) extremes.V_max = row.result.end.V;
    take(row.probe, row.result.end);
    for (const EnvelopePoint& point : row.result.path) take(row.probe, point);
  }
  return extremes;
}

std::vector<EnvelopePoint> section_at(Real V, const std::vector<EnvelopeRow>& rows)
{
  std::vector<EnvelopePoint> section;
  for (const EnvelopeRow& row : rows) {
    const std::vector<EnvelopePoint>& path = row.result.path;
    if (row.probe.free_sideways) continue;
    for (std::size_t k = 1; k < path.size(); ++k) {
      if ((path[k - 1].V - V) * (path[k].V - V) > 0 || path[k - 1].V == path[k].V) continue;
      const Real part = (V - path[k - 1].V) / (path[k].V - path[k - 1].V);
      const auto between = [&](Real EnvelopePoint::*value) { return std::lerp(path[k - 1].*value, path[k].*value, part); };
      section.push_back({V, between(&EnvelopePoint::H), between(&EnvelopePoint::w), between(&EnvelopePoint::M)});
      break;
    }
  }
  return section;
}

std::string envelope_csv(const std::vector<EnvelopeRow>& rows, bool with_moments, int force_dimension)
{
  const EnvelopeExtremes extremes = extremes_of(rows);
  const char *force = force_dimension == 2 ? "N_m" : "N", *moment = force_dimension == 2 ? "Nm_m" : "Nm";
  std::string text = fmt::format("probe,kind,angle_deg,V_{0},H_{0},V_over_Vmax,H_over_Hmax,w_m,growth,unbalance,overstress,state{1}\n",
                                 force, with_moments ? fmt::format(",turn_deg,free_sideways,M_{},M_over_Mmax", moment) : "");
  const auto point = [&](const EnvelopePoint& p) {
    return fmt::format("{},{},{},{},{}", cell(p.V), cell(p.H), cell(p.V / extremes.V_max), cell(p.H / extremes.H_max), cell(p.w));
  };
  const auto turning = [&](const Probe& probe, const EnvelopePoint& p) {
    if (!with_moments) return std::string();
    return fmt::format(",{},{:d},{},{}", cell(probe.turn), probe.free_sideways, cell(p.M), cell(p.M / extremes.M_max));
  };
  for (const EnvelopeRow& row : rows)
    text += fmt::format("{},{},{},{},{},{},{},{}{}\n", row.probe.name, row.probe.kind == ProbeKind::swipe ? "swipe" : "direction",
                        cell(row.probe.angle), point(row.result.end), cell(row.result.growth), cell(row.result.unbalance),
                        cell(row.result.overstress), row.state, turning(row.probe, row.result.end));
  for (const EnvelopeRow& row : rows)
    for (const EnvelopePoint& p : row.result.path)
      text += fmt::format("{},path,,{},,,,{}{}\n", row.probe.name, point(p), row.state, turning(row.probe, p));
  return text;
}

}  // namespace berm::envelope
