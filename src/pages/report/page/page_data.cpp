// SPDX-License-Identifier: BSD-3-Clause
#include "report/page/page.hpp"

#include "record/travel_curve.hpp"
#include "structures/structures.hpp"

#include <algorithm>

namespace berm::report {
namespace {

using Json = nlohmann::ordered_json;

constexpr Index max_rows = 5000;  // of a history on the page, but for the ends of stages

Json number_or_null(Real value)
{
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

/// Rows of the history that the page holds: every n-th row, and the first and the last of each stage.
std::vector<Index> kept_rows(const run_folder::History& history)
{
  const Index rows = history.rows(), step = std::max(1, (rows + max_rows - 1) / max_rows);
  std::vector<Index> kept;
  for (Index k = 0; k < rows; ++k) {
    const bool first = k == 0 || history.stage[k] != history.stage[k - 1];
    const bool last = k + 1 == rows || history.stage[k] != history.stage[k + 1];
    if (k % step == 0 || first || last) kept.push_back(k);
  }
  return kept;
}

/// Adds the rows of a push or a drag (of the history, ascending) among those that the page holds, and its forces as smooth lines along its travel (m) are drawn.
void add_path(Json& path, const record::RunRecord& run, const std::vector<Index>& kept, const base::StagePath& stage)
{
  const auto& [rows, travel] = stage;
  const Real half = averaging_half(base::body_scale(run));
  const auto mean_of = [&](const char* column) {
    std::vector<Real> force;
    for (const Index k : rows) force.push_back(run.history.by_label(column)[k]);
    return record::drawn_along(travel, force, half);
  };
  const std::vector<Real> V = mean_of("V"), H = mean_of("H");
  auto on_page = kept.begin();
  for (std::size_t k = 0; k < rows.size(); ++k) {
    on_page = std::lower_bound(on_page, kept.end(), rows[k]);
    if (on_page == kept.end() || *on_page != rows[k]) continue;
    path["rows"].push_back(on_page - kept.begin());
    path["V_mean"].push_back(number_or_null(V[k]));
    path["H_mean"].push_back(number_or_null(H[k]));
  }
}

/// Of pushes or drags, one after the other.
Json path_json(const record::RunRecord& run, const std::vector<Index>& kept, const std::vector<base::StagePath>& stages)
{
  Json path = {{"rows", Json::array()}, {"u_begin", 0}, {"V_mean", Json::array()}, {"H_mean", Json::array()}};
  for (const base::StagePath& stage : stages)
    if (!stage.rows.empty()) add_path(path, run, kept, stage);
  if (!stages.empty() && !stages.front().rows.empty()) path["u_begin"] = run.history["u_m"][stages.front().rows.front()];
  return path;
}

/// The charts that the structure has by itself, in those rows that the page holds.
Json own_charts_json(const std::vector<base::OwnChart>& charts, const std::vector<Index>& kept)
{
  Json list = Json::array();
  const auto axis = [](const base::OwnChart::Axis& a) { return Json{{"words", a.words}, {"symbol", a.symbol}, {"unit", a.unit}}; };
  for (const base::OwnChart& chart : charts) {
    Json one = {{"id", chart.id}, {"title", chart.title}, {"x", axis(chart.x)}, {"y", axis(chart.y)}, {"rows", Json::array()}};
    std::vector<std::size_t> places;
    for (std::size_t k = 0; k < chart.rows.size(); ++k)
      if (const auto on_page = std::ranges::lower_bound(kept, chart.rows[k]); on_page != kept.end() && *on_page == chart.rows[k])
        places.push_back(k), one["rows"].push_back(on_page - kept.begin());
    const auto numbers = [&](const std::vector<Real>& values) {
      Json shown = Json::array();
      for (const std::size_t k : places) shown.push_back(number_or_null(values[k]));
      return shown;
    };
    for (const base::OwnChart::Curve& curve : chart.curves)
      one["curves"].push_back({{"name", curve.name}, {"x", numbers(curve.x)}, {"y", numbers(curve.y)}, {"mean", numbers(curve.mean)}});
    list.push_back(std::move(one));
  }
  return list;
}

/// How sure the curves of charts are.
Json bands_json(const record::RunRecord& run)
{
  Json bands = Json::array();
  if (!run.summary || !run.summary->uncertainty) return bands;
  const auto side = [](const std::vector<Real>& values) {
    Json numbers = Json::array();
    for (const Real value : values) numbers.push_back(number_or_null(value));
    return numbers;
  };
  for (const run_folder::CurveBand& band : run.summary->uncertainty->curves)
    bands.push_back({{"chart", band.chart}, {"x", side(band.x)}, {"low", side(band.low)}, {"high", side(band.high)}});
  return bands;
}

/// What forces are made dimensionless with (N/m) and its letters; what stresses and energies per metre are made so with follows by D.
Json measure_of(const base::BodyScale& scale)
{
  const base::ForceMeasure measure = scale.width > 0 ? force_measure(scale) : base::ForceMeasure{};
  if (!(measure.size > 0)) return nullptr;
  const bool weight = measure.kind == base::ForceMeasure::Kind::weight;
  return {{"size", measure.size},
          {"stress", weight ? "γ′ D" : "s_u"},
          {"force", weight ? "γ′ D²" : "D s_u"},
          {"energy", weight ? "γ′ D³" : "D² s_u"}};
}

}  // namespace

Json run_data(const record::RunRecord& run)
{
  const run_folder::History& history = run.history;
  const base::BodyScale scale = base::body_scale(run);
  const std::vector<Index> kept = kept_rows(history);
  Json data;
  data["name"] = run.name;
  data["title"] = run.settings.title;
  data["method"] = run.settings.method == problem::Method::mpm ? "mpm" : "fem";
  data["diameter"] = scale.width > 0 ? Json(scale.width) : Json(nullptr);
  data["measure"] = measure_of(scale);
  data["prototype"] = has_prototype(scale) ? Json(scale.gravity_level) : Json(nullptr);
  data["of_test"] = false;
  data["quantities"] = Json::object();
  for (const run_folder::Column& column : history.columns)
    data["quantities"][column.name] = {
        {"label", column.label}, {"words", column.words()}, {"unit", column.unit == run_folder::bare.name ? "" : column.unit}};
  data["columns"] = Json::object();
  for (std::size_t c = 0; c < history.columns.size(); ++c) {
    Json& column = data["columns"][history.columns[c].name] = Json::array();
    for (const Index k : kept) column.push_back(number_or_null(history.values[c][k]));
  }
  data["stage"] = Json::array();
  for (const Index k : kept) data["stage"].push_back(history.stage[k]);
  data["row"] = static_cast<Index>(kept.size()) == history.rows() ? Json(nullptr) : Json(kept);
  const base::Structure& structure = structures::structure_of(run.settings);
  const base::StagePaths paths = structure.paths(run);
  data["push"] = path_json(run, kept, {paths.push});
  data["drag"] = path_json(run, kept, paths.drags);
  if (const std::optional<base::PointTravel> point = structure.point_travel(run)) {
    data["drag"]["u"] = {{"words", point->words}, {"values", Json::array()}};
    for (const Json& row : data["drag"]["rows"])
      data["drag"]["u"]["values"].push_back(number_or_null(point->u[kept[row.get<std::size_t>()]]));
  }
  data["lift"] = path_json(run, kept, paths.lifts);
  data["charts"] = own_charts_json(structure.own_charts(run), kept);
  data["bands"] = bands_json(run);
  data["film"] = nullptr;
  return data;
}

}  // namespace berm::report
