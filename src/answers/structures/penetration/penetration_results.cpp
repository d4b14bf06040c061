// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/penetration/penetration_test.cpp
#include "structures/penetration/penetration_results.hpp"

#include "structures/base/answer.hpp"
#include "structures/driven/path.hpp"
#include "structures/penetration/soil_on_body.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::penetration {
namespace {

using base::AnswerUnit, run_folder::QuantityKind;

constexpr Real shallow = 0.25;  // of D: above a footing that is no deeper there is no hole to speak of
constexpr Real reached = 1e-3;  // of D: a stage that ends at a depth may stop this much short of it

/// A run at a depth, at the end of its push, and where H of its first drag is largest. In names q and N are the symbols of resistance and factor, J that which is judged: the
/// factor, without one the resistance.
struct AtDepth {
  const PenetrationRun& run;
  Real z;
};
struct AtEnd {
  const PenetrationRun& run;
  const LastTravel& last = run.last();
  Real backflow = nan;  ///< Pa
  bool has_factor = run.symbol() != nullptr;
};
struct AtFailure {
  Real V, H, M;                ///< N, N m; plane strain N/m, N m/m
  Real area, width, strength;  ///< m2 (plane strain m), m, Pa; NaN of other soil
};

bool flows_around(const Penetrometer& how)
{
  return how.flows_around;
}
bool keeps_push(const Penetrometer& how)
{
  return how.keeps_push;
}

constexpr base::Answer<AtDepth, Penetrometer> depth_answers[] = {
    {"{q}_at_z", AnswerUnit::stress, "resistance over the area; z is the depth of the {level}",
     [](const AtDepth& at) { return at.run.q_at(at.z); }},
    {"{N}_at_z", AnswerUnit::ratio, "factor of the net resistance; z is the depth of the {level}",
     [](const AtDepth& at) { return at.run.factor_at(at.z); }},
};

constexpr base::Answer<AtEnd, Penetrometer> end_answers[] = {
    {"soil_above", AnswerUnit::ratio,
     "fraction of the space above the body, D/2 wide and D/2 high, that is filled with soil at the end of the push: 0 under an open "
     "cavity, 1 "
     "where the soil has closed",
     [](const AtEnd& end) { return end.run.how.flows_around ? soil_above_at_end(end.run) : nan; }, QuantityKind::quality, nullptr,
     flows_around},
    {"z_end", AnswerUnit::length, "depth of the {level} at the end of the push", [](const AtEnd& end) { return end.run.z_end(); },
     QuantityKind::prescribed},
    {"area", AnswerUnit::area, "of the modelled part of the body on a level plane", [](const AtEnd& end) { return end.run.area(); },
     QuantityKind::prescribed},
    {"{q}_end", AnswerUnit::stress, "mean resistance {over}", [](const AtEnd& end) { return end.last.q; }},
    {"f_shaft_end", AnswerUnit::stress, "mean friction of the shaft in the soil, {over}",
     [](const AtEnd& end) { return end.last.friction; }},
    {"{N}_end", AnswerUnit::ratio, "mean factor {over}", [](const AtEnd& end) { return end.last.factor; }},
    {"sigma_backflow_end", AnswerUnit::stress, "weight of the soil on the body at the end of the push, over the area",
     [](const AtEnd& end) { return end.backflow; }, QuantityKind::answer, nullptr, keeps_push},
    {"{N}_end_backflow", AnswerUnit::ratio, "mean factor {over}, with that weight on the body",
     [](const AtEnd& end) { return end.last.factor + end.backflow / end.run.soil.at(end.run.z_end()).strength; }, QuantityKind::answer,
     nullptr, keeps_push},
    {"{J}_change", AnswerUnit::ratio, "change of its straight line divided by the mean, {over}",
     [](const AtEnd& end) { return end.last.change; }, QuantityKind::quality},
    {"{J}_scatter", AnswerUnit::ratio, "standard deviation of the rows about that line divided by the mean, {over}",
     [](const AtEnd& end) { return end.last.scatter; }, QuantityKind::quality},
    {"{q}_steady", AnswerUnit::stress, "steady value: it changes by less than 5 % {over}",
     [](const AtEnd& end) { return end.last.steady() && !end.has_factor ? end.last.q : nan; }},
    {"{N}_steady", AnswerUnit::ratio, "steady value: it changes by less than 5 % {over}",
     [](const AtEnd& end) { return end.last.steady() && end.has_factor ? end.last.factor : nan; }},
    {"z_at_{J}_steady", AnswerUnit::length, "depth from which it stays within 5 % of that",
     [](const AtEnd& end) { return end.last.steady() ? end.last.steady_from : nan; }, QuantityKind::quality},
};

constexpr base::Answer<AtFailure, Penetrometer> failure_answers[] = {
    {"V_at_H_max", AnswerUnit::force, "vertical reaction where H of the first drag is largest", [](const AtFailure& f) { return f.V; }},
    {"M_at_H_max", AnswerUnit::moment, "moment on the body about the middle of its base there, counter-clockwise",
     [](const AtFailure& f) { return f.M; }},
    {"V_at_H_max_over_As_u", AnswerUnit::ratio, "the same over area and strength",
     [](const AtFailure& f) { return f.V / (f.area * f.strength); }},
    {"H_max_over_As_u", AnswerUnit::ratio, "largest H of the first drag over area and strength",
     [](const AtFailure& f) { return f.H / (f.area * f.strength); }},
    {"M_at_H_max_over_ADs_u", AnswerUnit::ratio, "moment there over area, width and strength",
     [](const AtFailure& f) { return f.M / (f.area * f.width * f.strength); }},
};

/// What the soil on a footing in a hole weighs: the bearing capacity of an open hole is net of sigma_v0, and of what has flowed back it gets that weight back.
Real backflow_of(const PenetrationRun& run)
{
  const bool in_a_hole = run.how.keeps_push && run.measure() == Measure::strength && run.z_end() > shallow * run.body.width;
  return in_a_hole ? backflow_pressure(run) : nan;
}

/// Empty where no drag follows the push, or its moments are not known.
std::optional<AtFailure> failure_of(const PenetrationRun& run)
{
  const run_folder::History& history = run.record.history;
  if (!run.how.keeps_push || !history.has_label("M") || run.record.settings.geometry == settings::Geometry::space) return {};
  const driven::Path path = driven::path_of(history, driven::stages_of(run.record.settings));
  const driven::DragPath& drag = path.drag();
  if (drag.travel.size() < 3) return {};
  std::vector<Real> moment;
  for (std::size_t k = 0; k < drag.rows.size(); ++k)
    moment.push_back(history.by_label("M")[drag.rows[k]] + drag.stage.direction * drag.H[k] * run.body.height / 2);
  const record::TravelCurve H(drag.travel, drag.H), V(drag.travel, drag.V), M(drag.travel, moment);
  const Real half = std::min(base::averaging_half(run.scale), (H.end() - H.begin()) / 20);
  const record::TravelCurve smooth = H.smoothed(half);
  const auto largest = std::max_element(smooth.value().begin(), smooth.value().end());
  const Real u = smooth.travel()[largest - smooth.value().begin()], strength = run.soil.at(run.z_end()).strength;
  return AtFailure{V.at(u, half), *largest, M.at(u, half), run.area(), run.whole_width(), strength > 0 ? strength : nan};
}

}  // namespace

std::string name_at(const std::string& what, Real over_D)
{
  return what + "_at_z" + base::AnswerList::ending_at(over_D);
}

std::vector<run_folder::Quantity> penetration_quantities(const PenetrationRun& run)
{
  base::AnswerList list(run.record.settings.force_dimension());
  const Real D = run.body.width;
  if (!run.z().empty() && std::isfinite(run.area())) {
    const std::string q = run.how.resistance.plain, N = run.symbol() == nullptr ? q : run.symbol()->plain;
    list.fill({{"q", q},
               {"N", N},
               {"J", N},
               {"level", run.how.level},
               {"over", fmt::format("over the last {:.3g} D of the push", run.last().travel / D)}});
    list.of("push", "");
    list.twins(0, D);
    const Real end = run.q_curve().end();
    for (const Real part : run.how.depths)
      if (part * D <= end + reached * D) list.at(part), list.add(depth_answers, AtDepth{run, std::min(part * D, end)});
    list.at({});
    list.add(end_answers, AtEnd{.run = run, .backflow = backflow_of(run)});
    list.of("", "");
  }
  if (const std::optional<AtFailure> failure = failure_of(run)) list.add(failure_answers, *failure);
  return list.list();
}

base::Headline penetration_headline(const PenetrationRun& run)
{
  const std::string q = run.how.resistance.plain, N = run.symbol() == nullptr ? "" : run.symbol()->plain;
  const char* N_html = run.symbol() == nullptr ? "" : run.symbol()->html;
  const base::HeadlineNumber depth{"z_end", fmt::format("Depth of the {}", run.how.level)};
  const base::Headline factor{{N + "_end", fmt::format("{} at the end", N_html)}};
  base::Headline others{{q + "_end", fmt::format("Resistance {} at the end", run.how.resistance.html)}};
  if (run.last().friction > 0) others.push_back({"f_shaft_end", "Mean shaft friction"});
  const bool asks_depth = std::isfinite(run.force_limit());
  base::Headline numbers = asks_depth ? base::Headline{depth} : factor;
  numbers.insert(numbers.end(), others.begin(), others.end());
  asks_depth ? numbers.push_back(factor.front()) : numbers.push_back(depth);
  return numbers;
}

std::vector<std::string> penetration_names(const Penetrometer& how)
{
  base::AnswerList list(3);
  list.twins(0, 1);
  const std::string q = how.resistance.plain;
  for (const std::string N : {how.in_clay.plain, how.in_sand.plain})
    for (const std::string& judged : {q, N}) {
      list.fill({{"q", q}, {"N", N}, {"J", judged}});
      for (const Real part : how.depths) list.at(part), list.add_names(depth_answers, how);
      list.at({});
      list.add_names(end_answers, how);
    }
  if (how.keeps_push) list.add_names(failure_answers, how);
  return list.names();
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

}  // namespace berm::penetration
