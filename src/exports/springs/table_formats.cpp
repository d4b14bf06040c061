// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/springs/formats_test.cpp
#include "springs/written_springs.hpp"
#include "structures/base/invalid_answer.hpp"
#include "study/study_report.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace berm::springs {
namespace {

using Json = nlohmann::ordered_json;
using Words = std::vector<std::string>;

std::string exact(Real value)
{
  return std::isnan(value) ? "" : fmt::format("{}", value);
}

/// What numbers of this kind are divided by to be without dimension, with its name.
struct Normal {
  const char* name;
  Real by;
};
std::vector<Normal> normals(const Design& design, const Estimate& e)
{
  const Springs& s = design.best;
  if (e.kind == Kind::displacement) return {{"over_D", s.diameter}};
  if (e.kind != Kind::force) return {};
  std::vector<Normal> list = {{"over_gammaD2", s.weight}, {"over_suD", s.strength}};
  for (const Lateral& l : s.lateral)
    if (e.spring == "lateral " + l.stage) list.push_back({"over_V", l.V});
  return list;
}

constexpr const char* springs_head =
    "spring,number,unit,best,low (5 %),middle (50 %),high (95 %),runs,lognormal mean of ln,lognormal deviation of ln,lognormal distance,"
    "lognormal at 5 % of tests,best over gamma' D^2,best over su D,best over V,best over D,meaning,run,state,travel,source\n";

std::string springs_csv(const Design& design)
{
  std::string text;
  for (const std::string& line : design.provenance) text += "# " + line + "\n";
  for (const std::string& line : design.best.missing) text += "# " + line + "\n";
  if (design.best.scale != 1) text += fmt::format("# prototype: {:.6g} times the size of the model\n", design.best.scale);
  for (const std::string& line : refused_stiffnesses(design.best)) text += "# " + line + "\n";
  text += springs_head;
  for (const Estimate& e : design.estimates) {
    std::array<Real, 4> over = {nan, nan, nan, nan};
    for (const Normal& normal : normals(design, e)) {
      const std::string name = normal.name;
      over[name == "over_gammaD2" ? 0
           : name == "over_suD"   ? 1
           : name == "over_V"     ? 2
                                  : 3] = (std::isnan(e.best) ? e.middle : e.best) / normal.by;
    }
    const std::string verdict = std::isnan(e.fit.distance) ? "" : e.fit.fits() ? "not refused" : "refused";
    Words words = {e.spring,
                   e.name,
                   unit_of(e.kind),
                   exact(e.best),
                   exact(e.low),
                   exact(e.middle),
                   exact(e.high),
                   e.size > 0 ? fmt::format("{}", e.size) : "",
                   exact(e.fit.mean),
                   exact(e.fit.deviation),
                   exact(e.fit.distance),
                   verdict};
    for (const Real number : over) words.push_back(exact(number));
    for (const std::string& word : {e.meaning, design.best.run, design.best.state, e.travel, e.source}) words.push_back(word);
    text += study::csv_line(words);
  }
  return text;
}

std::string curves_csv(const Design& design)
{
  std::string text;
  for (const std::string& line : design.provenance)
    if (line.starts_with(base::invalid_line_begin)) text += "# " + line + "\n";
  text += study::csv_line({"spring", "estimate", "displacement (m)", "resistance (N/m)", "run", "state", "travel", "source"});
  const auto add = [&](const std::string& spring, const std::string& estimate, const Points& points, const Springs& s,
                       const std::string& travel) {
    const std::string source = spring == "axial" ? axial_title(s) + ": " + axial_origin(s) : "computed";
    for (const Point& p : points) text += study::csv_line({spring, estimate, exact(p.x), exact(p.F), s.run, s.state, travel, source});
  };
  for (const auto& [set, springs] : sets_of(design)) {
    for (const Lateral& l : springs->lateral) add("lateral " + l.stage, set, l.spring(), *springs, l.stage);
    add("vertical", set, vertical_spring(*springs), *springs, "push");
    add("vertical virgin", set, springs->vertical.curve, *springs, "push");
    add("axial", set, axial_spring(*springs), *springs, "");
  }
  for (const auto& [set, estimate] : {std::pair("best, low displacements", &Range::low), {"best, high displacements", &Range::high}})
    add("axial", set, axial_spring(design.best, estimate), design.best, "");
  for (const Lateral& l : design.best.lateral) add("lateral " + l.stage, "computed", l.curve, design.best, l.stage);
  return text;
}

Json number(Real value)
{
  return std::isnan(value) ? Json(nullptr) : Json(value);
}

Json json_of(const Points& points)
{
  Json list = Json::array();
  for (const Point& p : points) list.push_back({p.x, p.F});
  return list;
}

Json json_of(const Range& range)
{
  return {number(range.low), number(range.best), number(range.high)};
}

Json json_of(const Springs& s)
{
  Json lateral = Json::array(), unloading = Json::array(), set_up = Json::array();
  for (const SetUp& rest : s.axial.set_up)
    set_up.push_back(
        {{"stage", rest.stage}, {"U", number(rest.degree)}, {"before_N_m", number(rest.before)}, {"after_N_m", number(rest.after)}});
  for (const Lateral& l : s.lateral) {
    Json mobilised = Json::array();
    for (const Real u : l.mobilised) mobilised.push_back(number(u));
    lateral.push_back({{"stage", l.stage},
                       {"V_N_m", number(l.V)},
                       {"breaks_out", l.breaks},
                       {"peak_N_m", number(l.peak)},
                       {"mobilised_m", mobilised},
                       {"u_peak_m", number(l.u_peak)},
                       {"largest_N_m", number(l.largest)},
                       {"u_largest_m", number(l.u_largest)},
                       {"residual_N_m", number(l.residual)},
                       {"berm_resistance_N_m", number(l.berm)},
                       {"end_N_m", number(l.end)},
                       {"u_residual_m", number(l.u_residual)},
                       {"travel_m", number(l.travel)},
                       {"spring", json_of(l.spring())},
                       {"computed", json_of(l.curve)}});
  }
  for (const Unloading& u : s.vertical.unloading)
    unloading.push_back({{"stage", u.stage},
                         {"V_begin_N_m", number(u.V_begin)},
                         {"V_end_N_m", number(u.V_end)},
                         {"stiffness_N_m2", number(is_stiffness(u.stiffness) ? u.stiffness : nan)}});
  return {{"run", s.run},
          {"state", s.state},
          {"state_origin", s.state_origin},
          {"V_N_m", number(s.V)},
          {"embedment_m", number(s.embedment)},
          {"missing", s.missing},
          {"lateral", lateral},
          {"vertical",
           {{"spring", json_of(vertical_spring(s))},
            {"virgin", json_of(s.vertical.curve)},
            {"preload_N_m", number(s.vertical.preload)},
            {"stiffness_N_m2", number(normal_stiffness(s).value)},
            {"stiffness_source", normal_stiffness(s).origin},
            {"unloading", unloading},
            {"refused", refused_stiffnesses(s)}}},
          {"axial",
           {{"wedging", number(s.axial.wedging)},
            {"drained_N_m", number(s.axial.drained)},
            {"undrained_N_m", number(s.axial.undrained)},
            {"undrained_strength", s.axial.strength},
            {"undrained_sensitivity", number(s.axial.sensitivity)},
            {"drained_source", s.axial.drained_source},
            {"undrained_source", s.axial.undrained_source},
            {"consolidated_N_m", number(s.axial.settled)},
            {"breakout_N_m", number(s.axial.breakout())},
            {"residual_N_m", number(s.axial.residual)},
            {"after_cycles_N_m", {number(s.axial.cyclic().low), number(s.axial.cyclic().high)}},
            {"set_up", set_up},
            {"breakout_m", json_of(s.axial.u_breakout)},
            {"residual_m", json_of(s.axial.u_residual)},
            {"spring", json_of(axial_spring(s))}}}};
}

}  // namespace

ExportFiles table_files(const Design& design)
{
  return {{"springs.csv", springs_csv(design)}, {"curves.csv", curves_csv(design)}};
}

ExportFiles json_files(const Design& design)
{
  const Springs& s = design.best;
  Json root = {{"name", design.name},
               {"provenance", design.provenance},
               {"diameter_m", number(s.diameter)},
               {"embedment_m", number(s.embedment)},
               {"prototype_over_model", s.scale},
               {"gammaD2_N_m", number(s.weight)},
               {"suD_N_m", number(s.strength)}};
  Json estimates = Json::array();
  for (const Estimate& e : design.estimates) {
    Json entry = {{"spring", e.spring}, {"number", e.name},   {"unit", unit_of(e.kind)}, {"meaning", e.meaning},
                  {"travel", e.travel}, {"source", e.source}, {"best", number(e.best)}};
    if (e.size > 0)
      entry.update({{"low", number(e.low)},
                    {"middle", number(e.middle)},
                    {"high", number(e.high)},
                    {"runs", e.size},
                    {"lognormal",
                     {{"mean", number(e.fit.mean)},
                      {"deviation", number(e.fit.deviation)},
                      {"distance", number(e.fit.distance)},
                      {"limit", lognormal_limit}}}});
    for (const Normal& normal : normals(design, e))
      if (const Real value = (std::isnan(e.best) ? e.middle : e.best) / normal.by; !std::isnan(value)) entry[normal.name] = value;
    estimates.push_back(entry);
  }
  root["estimates"] = estimates;
  for (const auto& [set, springs] : sets_of(design)) root["springs"][set] = json_of(*springs);
  return {{"springs.json", root.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"}};
}

}  // namespace berm::springs
