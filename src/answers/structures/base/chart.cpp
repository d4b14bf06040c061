// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/driven/run_charts_test.cpp
#include "structures/base/chart.hpp"

#include "record/travel_curve.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace berm::base {

using Json = nlohmann::ordered_json;

Curve travelled(Curve curve, Real half)
{
  curve.smooth = record::drawn_along(curve.travel, curve.y, half);
  for (std::size_t k = 0; k < curve.y.size(); ++k)
    if (std::isnan(curve.travel[k])) curve.smooth[k] = curve.y[k];
  return curve;
}

const std::vector<Curve>& curves_in(const Charts& charts, const std::string& id)
{
  static const std::vector<Curve> none_there{};
  const auto found = std::ranges::find(charts, id, &Chart::id);
  return found == charts.end() ? none_there : found->curves;
}

Json json_of(const Chart& chart, const std::vector<run_folder::CurveBand>& bands, const std::vector<Index>* kept)
{
  const auto axis = [](const Chart::Axis& a) { return Json{{"symbol", a.symbol}, {"unit", a.unit}, {"meaning", a.words}}; };
  Json json = {{"chart", chart.id}, {"x", axis(chart.x)}, {"y", axis(chart.y)}, {"curves", Json::array()}, {"bands", Json::array()}};
  for (const Curve& curve : chart.curves) {
    if (curve.x.empty()) continue;
    Json of{{"name", curve.name}, {"direction", curve.direction}, {"x", Json::array()}, {"y", Json::array()}};
    if (!curve.rows.empty()) of["rows"] = Json::array();
    for (std::size_t k = 0; k < curve.x.size(); ++k) {
      if (!curve.rows.empty()) {
        const auto place = kept == nullptr ? std::vector<Index>::const_iterator{} : std::ranges::lower_bound(*kept, curve.rows[k]);
        if (kept != nullptr && (place == kept->end() || *place != curve.rows[k])) continue;
        of["rows"].push_back(kept == nullptr ? curve.rows[k] : place - kept->begin());
      }
      of["x"].push_back(curve.x[k]), of["y"].push_back(curve.y[k]);
      if (!curve.smooth.empty()) of["smoothed"].push_back(curve.smooth[k]);
    }
    json["curves"].push_back(std::move(of));
  }
  for (const run_folder::CurveBand& band : bands)
    if (band.chart == chart.id) json["bands"].push_back({{"x", band.x}, {"low", band.low}, {"high", band.high}});
  return json;
}

std::string json_text(const Charts& charts, Index rows, const std::vector<run_folder::CurveBand>& bands)
{
  constexpr int version = 1;
  Json root = {{"version", version}, {"history_rows", rows}, {"charts", Json::array()}};
  for (const Chart& chart : charts) root["charts"].push_back(json_of(chart, bands));
  return root.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace berm::base
