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
constexpr Real last_part = 0.25;  // of the travel, over which growth is told

/// V, H and w of a stage over its travel, from where it began: the row before its first.
struct StagePath {
  record::TravelCurve V, H, w;
};

StagePath path_of(const run_folder::History& history, const std::string& stage)
{
  const auto first = std::find(history.stage.begin(), history.stage.end(), stage) - history.stage.begin();
  const auto part = [&](const char* label) {
    const std::vector<Real>& column = history.by_label(label);
    return std::vector<Real>(column.begin() + std::max<std::ptrdiff_t>(0, first - 1), column.end());
  };
  const std::vector<Real> u = part("u"), w = part("w");
  std::vector<Real> travel;
  for (std::size_t k = 0; k < u.size(); ++k) travel.push_back(std::hypot(u[k] - u[0], w[k] - w[0]));
  return {record::TravelCurve(travel, part("V")), record::TravelCurve(travel, part("H")), record::TravelCurve(travel, w)};
}

std::string cell(Real value)
{
  return std::isfinite(value) ? fmt::format("{}", value) : "";
}

}  // namespace

ProbeResult result_of(const Probe& probe, const run_folder::History& history, Real width)
{
  ProbeResult result;
  const StagePath path = path_of(history, probe.stage);
  if (path.V.empty() || path.H.empty()) return result;
  const Real half = probe.settings.method == problem::Method::fem ? 0 : base::averaging_half_width * width;
  const auto at = [&](Real travel) { return EnvelopePoint{path.V.at(travel, half), path.H.at(travel, half), path.w.at(travel, half)}; };
  const Real angle = probe.kind == ProbeKind::swipe ? 0 : probe.angle * degree;
  const auto resistance = [&](const EnvelopePoint& p) { return p.V * std::sin(angle) + p.H * std::cos(angle); };
  result.end = at(path.V.end());
  result.growth = 1 - resistance(at((1 - last_part) * path.V.end())) / resistance(result.end);
  if (history.has("unbalance")) result.unbalance = history["unbalance"].back();
  if (history.has("overstress")) result.overstress = history["overstress"].back();
  if (probe.kind == ProbeKind::swipe) {
    const std::vector<Real>& travel = path.V.travel();
    const std::size_t every = 1 + travel.size() / max_path_points;
    for (std::size_t k = 0; k < travel.size(); k += every) result.path.push_back(at(travel[k]));
  }
  return result;
}

EnvelopeExtremes extremes_of(const std::vector<EnvelopeRow>& rows)
{
  EnvelopeExtremes extremes{nan, nan, nan};
  const auto take = [&](const EnvelopePoint& p) {
    if (std::isfinite(p.H) && !(p.H <= extremes.H_max)) extremes.H_max = p.H, extremes.V_at_H_max = p.V;
  };
  for (const EnvelopeRow& row : rows) {
    if (row.probe.angle == 90) extremes.V_max = row.result.end.V;
    take(row.result.end);
    for (const EnvelopePoint& point : row.result.path) take(point);
  }
  return extremes;
}

std::string envelope_csv(const std::vector<EnvelopeRow>& rows)
{
  const EnvelopeExtremes extremes = extremes_of(rows);
  std::string text = "probe,kind,angle_deg,V_N_m,H_N_m,V_over_Vmax,H_over_Hmax,w_m,growth,unbalance,overstress,state\n";
  const auto point = [&](const EnvelopePoint& p) {
    return fmt::format("{},{},{},{},{}", cell(p.V), cell(p.H), cell(p.V / extremes.V_max), cell(p.H / extremes.H_max), cell(p.w));
  };
  for (const EnvelopeRow& row : rows)
    text += fmt::format("{},{},{},{},{},{},{},{}\n", row.probe.name, row.probe.kind == ProbeKind::swipe ? "swipe" : "direction",
                        cell(row.probe.angle), point(row.result.end), cell(row.result.growth), cell(row.result.unbalance),
                        cell(row.result.overstress), row.state);
  for (const EnvelopeRow& row : rows)
    for (const EnvelopePoint& p : row.result.path) text += fmt::format("{},path,,{},,,,{}\n", row.probe.name, point(p), row.state);
  return text;
}

}  // namespace berm::envelope
