// SPDX-License-Identifier: BSD-3-Clause
#include "report/page_data.hpp"

#include "output/travel_curve.hpp"
#include "report/paper.hpp"
#include "report/shown.hpp"

#include <algorithm>

namespace berm {
namespace {

using Json = nlohmann::ordered_json;

constexpr Index most_rows = 5000;           // of a history on the page, but for the ends of stages
constexpr std::size_t most_points = 10000;  // of a curve that forces are averaged along as they are

Json number_or_null(Real value)
{
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

bool contains(const std::vector<std::string>& list, const std::string& name)
{
  return std::find(list.begin(), list.end(), name) != list.end();
}

/// Rows of the history that the page holds: each so manieth, and the first and the last of each stage.
std::vector<Index> kept_rows(const History& history)
{
  const Index rows = history.rows(), step = std::max(1, (rows + most_rows - 1) / most_rows);
  std::vector<Index> kept;
  for (Index k = 0; k < rows; ++k) {
    const bool first = k == 0 || history.stage[k] != history.stage[k - 1];
    const bool last = k + 1 == rows || history.stage[k] != history.stage[k + 1];
    if (k % step == 0 || first || last) kept.push_back(k);
  }
  return kept;
}

/// A force along a travel, to be averaged over +-half. A mean takes as long as there are rows within its reach, so where there are many rows those within
/// half / 50 of travel are one point, their mean; the ends stay as they are.
TravelCurve force_curve(const std::vector<Real>& travel, const std::vector<Real>& force, Real half)
{
  std::vector<Real> s, F;
  for (std::size_t k = 0; k < travel.size(); ++k) {
    if (std::isnan(travel[k]) || std::isnan(force[k]) || (!s.empty() && travel[k] <= s.back())) continue;
    s.push_back(travel[k]);
    F.push_back(force[k]);
  }
  if (s.size() <= most_points) return TravelCurve(s, F);
  std::vector<Real> mean_s{s.front()}, mean_F{F.front()};
  for (std::size_t k = 1; k + 1 < s.size();) {
    Real weight = 0, sum_s = 0, sum_F = 0;
    for (const Real end = s[k] + half / 50; k + 1 < s.size() && s[k] <= end; ++k) {
      const Real w = (s[k + 1] - s[k - 1]) / 2;
      weight += w;
      sum_s += w * s[k];
      sum_F += w * F[k];
    }
    mean_s.push_back(sum_s / weight);
    mean_F.push_back(sum_F / weight);
  }
  mean_s.push_back(s.back());
  mean_F.push_back(F.back());
  return TravelCurve(mean_s, mean_F);
}

/// The rows of a path among those that the page holds, and its forces freed from noise.
class PathWriter {
public:
  PathWriter(const RunRecord& run, const std::vector<Index>& kept) : run_(run), kept_(kept) {}

  Json push() const
  {
    std::vector<Index> rows;
    for (Index k = 0; k < run_.history.rows(); ++k)
      if (contains(run_.stages.push, run_.history.stage[k])) rows.push_back(k);
    return json(rows, run_.history["w_m"], 0);
  }

  Json drag() const
  {
    std::vector<Index> rows;
    for (Index k = 0; k < run_.history.rows(); ++k) {
      if (!contains(run_.stages.drag, run_.history.stage[k])) continue;
      if (rows.empty() && k > 0) rows.push_back(k - 1);
      rows.push_back(k);
    }
    const std::vector<Real>& u = run_.history["u_m"];
    const Real begin = rows.empty() ? 0 : u[rows.front()];
    std::vector<Real> travel;
    for (const Real here : u) travel.push_back(std::abs(here - begin));
    return json(rows, travel, begin);
  }

private:
  Json json(const std::vector<Index>& rows, const std::vector<Real>& travel_of_all, Real begin) const
  {
    const auto along = [&](const std::vector<Real>& column) {
      std::vector<Real> part;
      for (const Index k : rows) part.push_back(column[k]);
      return part;
    };
    const std::vector<Real> travel = along(travel_of_all);
    const Real half = averaging_half(run_.scale);
    const TravelCurve V = force_curve(travel, along(run_.history["V_N_m"]), half),
                      H = force_curve(travel, along(run_.history["H_N_m"]), half);
    const auto mean = [&](const TravelCurve& force, Real s) { return std::isnan(s) ? Json(nullptr) : number_or_null(force.at(s, half)); };
    Json path = {{"rows", Json::array()}, {"u_begin", begin}, {"V_mean", Json::array()}, {"H_mean", Json::array()}};
    auto on_page = kept_.begin();
    for (std::size_t k = 0; k < rows.size(); ++k) {
      on_page = std::lower_bound(on_page, kept_.end(), rows[k]);
      if (on_page == kept_.end() || *on_page != rows[k]) continue;
      path["rows"].push_back(on_page - kept_.begin());
      path["V_mean"].push_back(mean(V, travel[k]));
      path["H_mean"].push_back(mean(H, travel[k]));
    }
    return path;
  }

  const RunRecord& run_;
  const std::vector<Index>& kept_;
};

/// What forces are made dimensionless with (N/m) and its letters; what stresses and energies per metre are made so with follows by D.
Json measure_of(const RunRecord& run)
{
  const ForceMeasure measure = run.has_pipe() ? force_measure(run) : ForceMeasure{};
  if (!(measure.size > 0)) return nullptr;
  const bool weight = measure.kind == ForceMeasure::Kind::weight;
  return {{"size", measure.size},
          {"stress", weight ? "γ′ D" : "s_u"},
          {"force", weight ? "γ′ D²" : "D s_u"},
          {"energy", weight ? "γ′ D³" : "D² s_u"}};
}

}  // namespace

Json run_data(const RunRecord& run)
{
  const History& history = run.history;
  const std::vector<Index> kept = kept_rows(history);
  Json data;
  data["name"] = run.name;
  data["title"] = run.settings.title;
  data["method"] = run.settings.method == Method::mpm ? "mpm" : "fem";
  data["diameter"] = run.has_pipe() ? Json(run.scale.diameter) : Json(nullptr);
  data["measure"] = measure_of(run);
  data["prototype"] = has_prototype(run.scale) ? Json(run.scale.gravity_level) : Json(nullptr);
  data["of_paper"] = is_of_paper(run);
  data["columns"] = Json::object();
  for (std::size_t c = 0; c < history.columns.size(); ++c) {
    Json& column = data["columns"][history.columns[c]] = Json::array();
    for (const Index k : kept) column.push_back(number_or_null(history.values[c][k]));
  }
  data["stage"] = Json::array();
  for (const Index k : kept) data["stage"].push_back(history.stage[k]);
  data["row"] = static_cast<Index>(kept.size()) == history.rows() ? Json(nullptr) : Json(kept);
  const Json nothing = {{"rows", Json::array()}, {"u_begin", 0}, {"V_mean", Json::array()}, {"H_mean", Json::array()}};
  const bool path = run.has_pipe() && history.rows() > 0;
  data["push"] = path ? PathWriter(run, kept).push() : nothing;
  data["drag"] = path ? PathWriter(run, kept).drag() : nothing;
  data["film"] = nullptr;
  return data;
}

}  // namespace berm
