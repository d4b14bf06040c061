// SPDX-License-Identifier: BSD-3-Clause
#include "report/page_data.hpp"

#include "output/travel_curve.hpp"

#include <algorithm>

namespace berm {
namespace {

using Json = nlohmann::ordered_json;

constexpr Index most_rows = 5000;  // of a history on the page

Json number_or_null(Real value)
{
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

bool contains(const std::vector<std::string>& list, const std::string& name)
{
  return std::find(list.begin(), list.end(), name) != list.end();
}

/// The rows of a path among those that the page holds, and its forces freed from noise.
class PathWriter {
public:
  PathWriter(const RunRecord& run, Index step) : run_(run), step_(step) {}

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
    const TravelCurve V(travel, along(run_.history["V_N_m"])), H(travel, along(run_.history["H_N_m"]));
    const Real half = averaging_half(run_.scale);
    Json path = {{"rows", Json::array()}, {"u_begin", begin}, {"V_mean", Json::array()}, {"H_mean", Json::array()}};
    for (std::size_t k = 0; k < rows.size(); ++k) {
      if (rows[k] % step_ != 0) continue;
      path["rows"].push_back(rows[k] / step_);
      path["V_mean"].push_back(number_or_null(V.at(travel[k], half)));
      path["H_mean"].push_back(number_or_null(H.at(travel[k], half)));
    }
    return path;
  }

  const RunRecord& run_;
  Index step_;
};

/// The undrained strength of the soil that the pipe touches; NaN where it has friction or none is touched.
Real strength_of(const Case& c)
{
  const Material* material = touched_material(c);
  const auto* law = material == nullptr ? nullptr : std::get_if<MohrCoulomb>(material);
  return law != nullptr && law->friction_angle == 0 ? law->cohesion : std::numeric_limits<Real>::quiet_NaN();
}

}  // namespace

Json run_data(const RunRecord& run)
{
  const History& history = run.history;
  const Index step = std::max(1, (history.rows() + most_rows - 1) / most_rows);
  Json data;
  data["name"] = run.name;
  data["title"] = run.settings.title;
  data["method"] = run.settings.method == Method::mpm ? "mpm" : "fem";
  data["diameter"] = run.has_pipe() ? Json(run.scale.diameter) : Json(nullptr);
  data["unit_weight"] = run.scale.unit_weight;
  data["gravity_level"] = run.scale.gravity_level;
  data["strength"] = number_or_null(strength_of(run.settings));
  data["columns"] = Json::object();
  for (std::size_t c = 0; c < history.columns.size(); ++c) {
    Json& column = data["columns"][history.columns[c]] = Json::array();
    for (Index k = 0; k < history.rows(); k += step) column.push_back(number_or_null(history.values[c][k]));
  }
  data["stage"] = Json::array();
  for (Index k = 0; k < history.rows(); k += step) data["stage"].push_back(history.stage[k]);
  data["row_step"] = step;
  const Json nothing = {{"rows", Json::array()}, {"u_begin", 0}, {"V_mean", Json::array()}, {"H_mean", Json::array()}};
  const bool path = run.has_pipe() && history.rows() > 0;
  data["push"] = path ? PathWriter(run, step).push() : nothing;
  data["drag"] = path ? PathWriter(run, step).drag() : nothing;
  data["film"] = nullptr;
  return data;
}

}  // namespace berm
