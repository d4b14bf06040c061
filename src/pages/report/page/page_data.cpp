// SPDX-License-Identifier: BSD-3-Clause
#include "report/page/page.hpp"

#include "report/animation/ground_chart.hpp"
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

/// Of pushes or drags, one after the other: their rows among those that the page holds, and their forces freed from noise. `H` is "" where it does not matter.
Json path_json(const record::RunRecord& run, const std::vector<Index>& kept, const base::Charts& charts, const char* V, const char* H)
{
  Json path = {{"rows", Json::array()}, {"u_begin", 0}, {"V_mean", Json::array()}, {"H_mean", Json::array()}};
  const std::vector<base::Curve>&of_V = curves_in(charts, V), &of_H = curves_in(charts, H);
  for (std::size_t k = 0; k < of_V.size(); ++k) {
    auto on_page = kept.begin();
    for (std::size_t row = 0; row < of_V[k].rows.size(); ++row) {
      on_page = std::lower_bound(on_page, kept.end(), of_V[k].rows[row]);
      if (on_page == kept.end() || *on_page != of_V[k].rows[row]) continue;
      path["rows"].push_back(on_page - kept.begin());
      path["V_mean"].push_back(number_or_null(of_V[k].smooth[row]));
      path["H_mean"].push_back(k < of_H.size() ? number_or_null(of_H[k].smooth[row]) : Json(nullptr));
    }
  }
  if (!of_V.empty() && !of_V.front().rows.empty()) path["u_begin"] = run.history["u_m"][of_V.front().rows.front()];
  return path;
}

/// The charts that are shown as they are, in those rows that the page holds.
Json own_charts_json(const base::Charts& charts, const std::vector<Index>& kept)
{
  Json list = Json::array();
  for (const base::Chart& chart : charts)
    if (!chart.title.empty()) list.emplace_back(json_of(chart, {}, &kept))["title"] = chart.title;
  return list;
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
  data["method"] = run.settings.method == settings::Method::mpm ? "mpm" : "fem";
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
  const base::Charts charts = structure.charts(run);
  data["push"] = path_json(run, kept, charts, "V_w", "");
  data["drag"] = path_json(run, kept, charts, "V_u", "H_u");
  if (const std::optional<base::PointTravel> point = structure.point_travel(run)) {
    data["drag"]["u"] = {{"words", point->words}, {"values", Json::array()}};
    for (const Json& row : data["drag"]["rows"])
      data["drag"]["u"]["values"].push_back(number_or_null(point->u[kept[row.get<std::size_t>()]]));
  }
  data["lift"] = path_json(run, kept, charts, "V_s", "");
  base::Charts own = charts;
  if (std::optional<base::Chart> ground = ground_chart(run)) own.push_back(std::move(*ground));
  data["charts"] = own_charts_json(own, kept);
  const bool has_bands = run.summary && run.summary->uncertainty;
  data["bands"] = has_bands ? json_of(*run.summary->uncertainty)["curves"] : Json::array();
  data["film"] = nullptr;
  return data;
}

}  // namespace berm::report
