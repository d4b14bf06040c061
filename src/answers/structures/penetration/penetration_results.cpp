// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/penetration/penetration_test.cpp
#include "structures/penetration/penetration_results.hpp"

#include "structures/driven/path.hpp"
#include "structures/penetration/soil_on_body.hpp"
#include "text/quantity_words.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::penetration {
namespace {

constexpr Real shallow = 0.25;  // of D: above a footing that is no deeper there is no hole to speak of
constexpr Real reached = 1e-3;  // of D: a stage that ends at a depth may stop this much short of it

}  // namespace

std::string name_at(const std::string& what, Real over_D)
{
  return fmt::format("{}_at_z_{:g}D", what, over_D);
}

std::vector<run_folder::Quantity> penetration_quantities(const PenetrationRun& run)
{
  std::vector<run_folder::Quantity> list;
  if (run.z().empty() || !std::isfinite(run.area())) return list;
  const Reading& reading = run.reading;
  const Real D = run.body.width;
  const std::string q = reading.resistance.plain, N = run.symbol() == nullptr ? "" : run.symbol()->plain;
  using enum run_folder::QuantityKind;
  const auto add = [&](const std::string& name, Real value, const char* unit, const std::string& meaning,
                       run_folder::QuantityKind kind = answer) {
    if (std::isfinite(value)) list.push_back({name, value, unit, meaning, kind, "push"});
  };
  const std::string level = fmt::format("z is the depth of the {}", reading.level);
  for (const Real part : reading.depths) {
    if (part * D > run.q_curve().end() + reached * D) break;
    const Real z = std::min(part * D, run.q_curve().end());
    add(name_at(q, part), run.q_at(z), "Pa", "resistance over the area; " + level);
    if (!N.empty()) add(name_at(N, part), run.factor_at(z), "1", "factor of the net resistance; " + level);
  }
  add("soil_above", reading.flows_around ? soil_above_at_end(run) : nan, "1",
      "fraction of the space above the body, D/2 wide and D/2 high, that is filled with soil at the end of the push: 0 under an open "
      "cavity, 1 "
      "where "
      "the soil has closed",
      quality);
  add("z_end", run.z_end(), "m", fmt::format("depth of the {} at the end of the push", reading.level), prescribed);
  add("z_end_over_D", run.z_end() / D, "1", fmt::format("depth of the {} at the end of the push", reading.level), ratio);
  add("area", run.area(), run.record.settings.force_dimension() == 2 ? "m" : "m2", "of the modelled part of the body on a level plane",
      prescribed);
  const LastTravel& last = run.last();
  const std::string over = fmt::format("over the last {:.3g} D of the push", last.travel / D), judged = N.empty() ? q : N;
  add(q + "_end", last.q, "Pa", "mean resistance " + over);
  add("f_shaft_end", last.friction, "Pa", "mean friction of the shaft in the soil, " + over);
  if (!N.empty()) add(N + "_end", last.factor, "1", "mean factor " + over);
  // Soil that has flowed back rests on the body: the bearing capacity of an open hole is net of sigma_v0, and of that weight it gets back.
  const bool in_a_hole = reading.keeps_push && run.measure() == Measure::strength && run.z_end() > shallow * D;
  if (const Real back = in_a_hole ? backflow_pressure(run) : nan; std::isfinite(back)) {
    add("sigma_backflow_end", back, "Pa", "weight of the soil on the body at the end of the push, over the area");
    add(N + "_end_backflow", last.factor + back / run.soil.at(run.z_end()).strength, "1",
        "mean factor " + over + ", with that weight on the body");
  }
  add(judged + "_change", last.change, "1", "change of its straight line, over the mean, " + over, quality);
  add(judged + "_scatter", last.scatter, "1", "standard deviation of the rows about that line, over the mean, " + over, quality);
  if (!last.steady()) return list;
  add(judged + "_steady", N.empty() ? last.q : last.factor, N.empty() ? "Pa" : "1", "steady value: it changes by less than 5 % " + over);
  add(fmt::format("z_at_{}_steady", judged), last.steady_from, "m", "depth from which it stays within 5 % of that", quality);
  add(fmt::format("z_at_{}_steady_over_D", judged), last.steady_from / D, "1", "depth from which it stays within 5 % of that", ratio);
  return list;
}

std::vector<run_folder::Quantity> failure_point(const PenetrationRun& run)
{
  std::vector<run_folder::Quantity> list;
  const run_folder::History& history = run.record.history;
  if (history.rows() == 0 || !history.has_label("M") || run.record.settings.geometry == problem::Geometry::space) return list;
  const driven::Path path = driven::path_of(history, driven::stages_of(run.record.settings));
  const driven::DragPath& drag = path.drag();
  if (drag.travel.size() < 3) return list;
  std::vector<Real> moment;
  for (std::size_t k = 0; k < drag.rows.size(); ++k)
    moment.push_back(history.by_label("M")[drag.rows[k]] + drag.stage.direction * drag.H[k] * run.body.height / 2);
  const record::TravelCurve H(drag.travel, drag.H), V(drag.travel, drag.V), M(drag.travel, moment);
  const Real half = std::min(base::averaging_half(run.scale), (H.end() - H.begin()) / 20);
  const record::TravelCurve smooth = H.smoothed(half);
  const auto largest = std::max_element(smooth.value().begin(), smooth.value().end());
  const Real u = smooth.travel()[largest - smooth.value().begin()], area = run.area(), strength = run.soil.at(run.z_end()).strength;
  const bool plane = run.record.settings.force_dimension() == 2;
  list.push_back({"V_at_H_max", V.at(u, half), plane ? "N/m" : "N", "vertical reaction where H of the first drag is largest"});
  list.push_back(
      {"M_at_H_max", M.at(u, half), plane ? "N m/m" : "N m", "moment on the body about the middle of its base there, counter-clockwise"});
  if (!(strength > 0)) return list;
  list.push_back({"V_at_H_max_over_As_u", V.at(u, half) / (area * strength), "1", "the same over area and strength"});
  list.push_back({"H_max_over_As_u", *largest / (area * strength), "1", "largest H of the first drag over area and strength"});
  list.push_back(
      {"M_at_H_max_over_ADs_u", M.at(u, half) / (area * run.whole_width() * strength), "1", "moment there over area, width and strength"});
  return list;
}

std::vector<std::string> penetration_names(const Reading& reading)
{
  std::vector<std::string> names = {"z_end", "z_end_over_D", "area", "f_shaft_end"};
  for (const char* symbol : {reading.resistance.plain, reading.in_clay.plain, reading.in_sand.plain}) {
    for (const Real part : reading.depths) names.push_back(name_at(symbol, part));
    for (const char* end : {"end", "change", "scatter", "steady"}) names.push_back(fmt::format("{}_{}", symbol, end));
    for (const char* end : {"", "_over_D"}) names.push_back(fmt::format("z_at_{}_steady{}", symbol, end));
  }
  if (reading.flows_around) names.emplace_back("soil_above");
  if (reading.keeps_push)
    for (const char* name : {"sigma_backflow_end", "N_c_end_backflow", "V_at_H_max", "M_at_H_max", "V_at_H_max_over_As_u",
                             "H_max_over_As_u", "M_at_H_max_over_ADs_u"})
      names.emplace_back(name);
  return names;
}

bool is_of_reading(const std::string& name, const Reading& reading)
{
  const auto begins = [&](const char* symbol) { return name.starts_with(std::string(symbol) + "_"); };
  return begins(reading.resistance.plain) || begins(reading.in_clay.plain) || begins(reading.in_sand.plain) || name.starts_with("z_") ||
         name == "area" || name == "f_shaft_end" || name == "soil_above" || name == "sigma_backflow_end";
}

std::string log_csv(const PenetrationRun& run)
{
  if (run.z().empty() || !std::isfinite(run.area())) return "";
  const record::TravelCurve q_mean = run.q_curve().smoothed(run.half()), factor_mean = run.factor_curve().smoothed(run.half());
  std::string csv = "z_m,w_m,q_Pa,factor,q_mean_Pa,factor_mean,f_shaft_Pa,s_u_Pa,sigma_v0_Pa\n";
  for (std::size_t k = 0; k < run.z().size(); ++k) {
    const Real z = run.z()[k], q = run.q()[k];
    const SoilAt soil = run.soil.at(z);
    csv += fmt::format("{:.7g},{:.7g},{:.7g},{:.6g},{:.7g},{:.6g},{:.6g},{:.6g},{:.6g}\n", z, z + run.body.shoulder, q, run.factor(z, q),
                       q_mean.at(z, 0), factor_mean.at(z, 0), run.knows_shaft() ? run.friction()[k] : nan, soil.strength, soil.overburden);
  }
  return csv;
}

std::string penetration_table(const std::vector<run_folder::Quantity>& quantities, const Reading& reading)
{
  std::string table;
  for (const run_folder::Quantity& quantity : quantities) {
    if (!is_of_reading(quantity.name, reading) || quantity.kind == run_folder::QuantityKind::ratio) continue;
    const std::string value = quantity.unit == "Pa" ? text::stress_words(quantity.value)
                              : quantity.unit == "m"
                                  ? text::length_words(quantity.value)
                                  : fmt::format("{:.4g}{}", quantity.value, quantity.unit == "1" ? "" : " " + quantity.unit);
    table += fmt::format("{:<32}{:>16}\n", quantity.name, value);
  }
  return table.empty() ? "" : table + fmt::format("z: depth of the {}\n", reading.level);
}

}  // namespace berm::penetration
