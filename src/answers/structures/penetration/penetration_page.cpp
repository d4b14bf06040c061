// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/penetration/penetration_test.cpp
#include "structures/penetration/penetration_page.hpp"

#include "structures/base/general_measures.hpp"
#include "structures/driven/report.hpp"
#include "structures/penetration/depth_log.hpp"
#include "structures/penetration/penetration_results.hpp"
#include "structures/penetration/soil_on_body.hpp"
#include "text/html.hpp"
#include "text/quantity_words.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::penetration {
namespace {

using text::HtmlCell;

std::string in_D(Real length, Real D)
{
  return text::short_number(length / D) + " D";
}

std::string angle_of(Real radians)
{
  return text::short_number(radians / degree) + "°";
}

/// "8.3 ± 1.1" of a quantity that has a band; "" without one.
std::string converged_of(const PenetrationRun& run, const std::string& quantity)
{
  const std::optional<run_folder::RunSummary>& summary = run.record.summary;
  const run_folder::Band* band = summary && summary->uncertainty ? summary->uncertainty->find(quantity) : nullptr;
  return band == nullptr ? "" : text::with_half_width(band->converged, band->half_width);
}

/// The name of its factor, or else of its resistance.
std::string judged_name(const PenetrationRun& run)
{
  return run.symbol() == nullptr ? run.how.resistance.plain : run.symbol()->plain;
}

/// "0.0667 to 0.1 D": the depths over which the means of the end are taken.
std::string last_depths(const PenetrationRun& run)
{
  return fmt::format("{} to {}", text::short_number((run.z_end() - run.last().travel) / run.body.width), in_D(run.z_end(), run.body.width));
}

/// "N<sub>kt</sub> = 11.3 (q<sub>t</sub> = 115 kPa), mean of the last 2 D"; of a footing with V, and the depths of which it is the mean.
std::string last_words(const PenetrationRun& run, const base::DisplayUnits& shown)
{
  const LastTravel& last = run.last();
  const bool at_a_depth = run.how.keeps_push;
  const std::string q = fmt::format("{} = {}{}", run.how.resistance.html, text::stress_words(last.q),
                                    at_a_depth ? ", V = " + shown.force_text(run.scale, run.V_last()) : "");
  const std::string what =
      run.symbol() == nullptr ? q : fmt::format("{} = {} ({})", run.symbol()->html, text::short_number(last.factor), q);
  const std::string converged = run.symbol() == nullptr ? "" : converged_of(run, judged_name(run) + "_end");
  return fmt::format("{}, {}{}", what,
                     at_a_depth ? "means over z = " + last_depths(run) : "mean of the last " + in_D(last.travel, run.body.width),
                     converged.empty() ? "" : ", converged " + converged);
}

std::string steady_words(const PenetrationRun& run)
{
  const LastTravel& last = run.last();
  if (last.steady())
    return fmt::format("It is steady from z = {} on: over that travel it changes by {}, and its rows scatter by {}.",
                       in_D(last.steady_from, run.body.width), text::percent_words(std::abs(last.change)),
                       text::percent_words(last.scatter));
  return fmt::format("It is <strong>not steady</strong>: over that travel it {} by {} (steady: less than {}).",
                     last.change > 0 ? "grows" : "falls", text::percent_words(std::abs(last.change)),
                     text::percent_words(LastTravel::max_change));
}

/// Whether an open cavity lies above a body around which soil shall flow.
bool cavity_is_open(const PenetrationRun& run)
{
  return base::quantity_value(run.record, "soil_above") < closed_soil;
}

std::string cavity_words(const PenetrationRun& run)
{
  if (!cavity_is_open(run)) return "";
  return fmt::format(" The cavity above the {} is <strong>still open</strong>: soil fills {} of the D/2 above it. Full flow is not "
                     "reached, and the factor grows as the cavity closes: push deeper.",
                     text::html_text(base::body_word(run.record.settings)),
                     text::percent_words(base::quantity_value(run.record, "soil_above")));
}

/// What the factor is made of, at the end of the way.
std::string soil_words(const PenetrationRun& run)
{
  const SoilAt here = run.soil.at(run.z_end());
  const std::string q = run.how.resistance.html;
  const std::string net = run.how.flows_around
                              ? (here.unit_weight > 0 ? q + " less the weight of the soil that the body displaces, over the area" : q)
                              : (here.overburden > 0 ? fmt::format("{} − σ<sub>v0</sub>", q) : q);
  switch (run.measure()) {
  case Measure::none:
    return "";
  case Measure::strength: {
    const std::string overburden =
        here.overburden > 0 && !run.how.flows_around ? fmt::format(" σ<sub>v0</sub> = {},", text::stress_words(here.overburden)) : "";
    std::string words =
        fmt::format(" {} = ({})/s<sub>u</sub>, all at z. At the end s<sub>u</sub> = {},{} I<sub>r</sub> = G/s<sub>u</sub> = {}",
                    run.symbol()->html, net, text::stress_words(here.strength), overburden, text::short_number(here.rigidity_index));
    if (std::isfinite(here.anisotropy))
      words += fmt::format(", Δ = (σ<sub>v0</sub> − σ<sub>h0</sub>)/2s<sub>u</sub> = {}", text::short_number(here.anisotropy));
    return words + (std::isfinite(here.interface_ratio) ? fmt::format(", interface α = {}.", text::short_number(here.interface_ratio))
                                                        : ", an interface with friction.");
  }
  case Measure::overburden:
    return fmt::format(" {} = ({})/σ<sub>v0</sub>, both at z.", run.symbol()->html, net);
  case Measure::half_weight:
    return fmt::format(" {} = 2 ({})/(γ′ D).", run.symbol()->html, net);
  }
  return "";
}

/// Of a footing that is deep: whether the hole above it is open, as N_c takes it, and the factor with the soil that has flowed back.
std::string backflow_words(const PenetrationRun& run)
{
  constexpr Real little = 0.02;  // of N_c
  const Real back = base::quantity_value(run.record, "sigma_backflow_end"), N = base::quantity_value(run.record, "N_c_end_backflow");
  if (!std::isfinite(N)) return "";
  const std::string name = text::html_text(base::body_word(run.record.settings));
  if (N < (1 + little) * run.last().factor)
    return fmt::format(" σ<sub>v0</sub> is that beside a hole that stays open, as it does here above the {}.", name);
  return fmt::format(" σ<sub>v0</sub> is that beside a hole that stays open. Here soil has flowed back over the {} and its weight divided "
                     "by the area of the body "
                     "is {} at the end: with that {} = (q − σ<sub>v0</sub> + {})/s<sub>u</sub> = {}.",
                     name, text::stress_words(back), run.symbol()->html, text::stress_words(back), text::short_number(N));
}

/// What a footing on the surface of the soil below this one has, where that is known.
std::string surface_words(const PenetrationRun& run)
{
  std::string words;
  for (const Comparison& c : run.how.published(run))
    if (!c.on_surface.empty() && std::isfinite(c.published.value))
      words +=
          fmt::format("{}{} ({})", words.empty() ? fmt::format(" On the surface of the soil below it {} is exactly ", c.quantity) : ", ",
                      text::short_number(c.published.value), c.on_surface);
  return words.empty() ? "" : words + ".";
}

std::string area_words(const PenetrationRun& run)
{
  const bool plane = run.record.settings.force_dimension() == 2;
  const Real scale = plane ? 1 : run.area() < 0.1 ? 1e4 : 1;
  return fmt::format("{} {}", text::short_number(run.area() * scale), plane ? "m² per metre" : scale > 1 ? "cm²" : "m²");
}

/// The measures of the body: its area over which V stands, its angle.
std::string body_words(const PenetrationRun& run)
{
  if (run.body.bore > 0)
    return fmt::format("D = {}, wall of {}, area of the ring {}", text::length_words(run.whole_width()),
                       text::length_words(run.body.wall()), area_words(run));
  std::string words = fmt::format("D = {}, area {}", text::length_words(run.whole_width()), area_words(run));
  if (run.whole_width() > 1.5 * run.area() && run.record.settings.force_dimension() == 2) words += " of the half that is modelled";
  if (run.body.conical) words += fmt::format(", apex angle {}", angle_of(run.body.apex_angle()));
  return words;
}

std::string summary_table(const PenetrationRuns& runs, const std::string& id)
{
  text::HtmlTable table(id, "At the end of the push");
  const std::string q = runs.front().how.resistance.html;
  const bool shaft = std::any_of(runs.begin(), runs.end(), [](const PenetrationRun& run) { return run.knows_shaft(); });
  const bool bands = std::any_of(runs.begin(), runs.end(),
                                 [](const PenetrationRun& run) { return !converged_of(run, judged_name(run) + "_end").empty(); });
  const auto without = [&](std::vector<HtmlCell> cells) {
    if (!bands) cells.erase(cells.begin() + 7);
    if (!shaft) cells.erase(cells.begin() + 4);
    return cells;
  };
  table.columns(without({{"run"},
                         {"body"},
                         {"z/D", true},
                         {q + ", kPa", true},
                         {"f, kPa", true},
                         {"factor"},
                         {"mean", true},
                         {"converged", true},
                         {"change", true},
                         {"scatter", true},
                         {"steady from z/D", true}}));
  for (const PenetrationRun& run : runs) {
    const std::string plain = judged_name(run);
    const auto number = [&](const std::string& name, Real unit) {
      return HtmlCell{text::table_number(base::quantity_value(run.record, name) * unit), true};
    };
    const auto part = [&](const std::string& name) {
      const Real value = base::quantity_value(run.record, name);
      return HtmlCell{std::isfinite(value) ? text::percent_words(value) : text::no_number, true};
    };
    const Real from = base::quantity_value(run.record, fmt::format("z_at_{}_steady_over_D", plain));
    table.row(
        without({{text::html_text(run.record.name)},
                 {body_words(run)},
                 run.how.keeps_push && std::isfinite(run.last().travel) ? HtmlCell{last_depths(run), true} : number("z_end_over_D", 1),
                 number(std::string(run.how.resistance.plain) + "_end", 1e-3),
                 number("f_shaft_end", 1e-3),
                 {run.symbol() == nullptr ? text::no_number : run.symbol()->html},
                 number(run.symbol() == nullptr ? "" : plain + "_end", 1),
                 {run.symbol() == nullptr ? "" : converged_of(run, plain + "_end"), true},
                 part(plain + "_change"),
                 part(plain + "_scatter"),
                 {std::isfinite(from) ? text::table_number(from) : "not steady", true}}));
  }
  return table.html();
}

/// Resistance and factor by depth: of a single run two columns, of several the factor (without one: the resistance) of each. Of a single footing load and settlement, too.
std::string depth_table(const PenetrationRuns& runs, const base::DisplayUnits& shown, const std::string& id)
{
  const Penetrometer& how = runs.front().how;
  const bool alone = runs.size() == 1, settles = alone && how.keeps_push;
  text::HtmlTable table(
      id, settles ? fmt::format("Load V by the depth z of the {}, which is the settlement of one that begins on the bed", how.level)
                  : fmt::format("By depth z of the {}", how.level));
  const auto symbol = [](const PenetrationRun& run) { return run.symbol() == nullptr ? run.how.resistance : *run.symbol(); };
  std::vector<HtmlCell> columns{{"z/D"}};
  if (settles)
    for (const HtmlCell& cell : {shown.length_columns("z")[1], shown.force_columns("V").front()}) columns.push_back(cell);
  if (alone) columns.push_back({std::string(how.resistance.html) + ", kPa", true});
  for (const PenetrationRun& run : runs)
    if (!alone || run.symbol() != nullptr)
      columns.push_back(
          {alone ? symbol(run).html
                 : fmt::format("{}{}, {}", symbol(run).html, run.symbol() == nullptr ? " (Pa)" : "", text::html_text(run.record.name)),
           true});
  table.columns(columns);
  for (const Real part : how.depths) {
    std::vector<HtmlCell> cells{{text::short_number(part)}};
    bool any = false;
    // Of a footing one number stands for the end.
    const auto before_end = [&](const PenetrationRun& run) {
      return !how.keeps_push || !(part * run.body.width > run.z_end() - run.last().travel);
    };
    const auto add = [&](Real value) {
      any = any || std::isfinite(value);
      cells.push_back({text::table_number(value), true});
    };
    if (settles) {
      const PenetrationRun& run = runs.front();
      const Real z = part * run.body.width;
      cells.push_back(shown.length_cells(run.scale, z)[1]);
      add(before_end(run) && z <= run.q_curve().end() ? shown.in_force_unit(run.V_at(z)) : nan);
    }
    if (alone) add(before_end(runs.front()) ? base::quantity_value(runs.front().record, name_at(how.resistance.plain, part)) / 1e3 : nan);
    for (const PenetrationRun& run : runs)
      if (!alone || run.symbol() != nullptr)
        add(before_end(run) ? base::quantity_value(run.record, name_at(symbol(run).plain, part)) : nan);
    if (any) table.row(cells);
  }
  if (const PenetrationRun& run = runs.front(); settles && std::isfinite(run.last().q)) {
    std::vector<HtmlCell> cells{{last_depths(run) + ", mean"},
                                {"", true},
                                {text::table_number(shown.in_force_unit(run.V_last())), true},
                                {text::table_number(run.last().q / 1e3), true}};
    if (run.symbol() != nullptr) cells.push_back({text::table_number(run.last().factor), true});
    table.row(cells);
  }
  return table.empty() ? "" : table.html();
}

/// "Pushed until the base of the footing is 0.1 D (600 mm) deep, the footing (D = 6 m, area 28.3 m²) mobilises ", where a limit of V ended the push with that and where
/// the body is then.
std::string begin_words(const PenetrationRun& run, const std::string& name, const base::DisplayUnits& shown)
{
  const std::string body = fmt::format("the {} ({}) mobilises ", name, body_words(run));
  std::string depth = fmt::format("{} ({}) deep", in_D(run.z_end(), run.body.width), text::length_words(run.z_end()));
  if (run.how.keeps_push && run.body.shoulder > 0) depth += fmt::format(", its lowest point {}", text::length_words(run.w_end()));
  if (std::isfinite(run.force_limit()))
    return fmt::format("Pushed until V = {}: the {} is then {}. There {}", shown.force_text(run.scale, run.force_limit()), run.how.level,
                       depth, body);
  return fmt::format("Pushed until the {} is {}, {}", run.how.level, depth, body);
}

}  // namespace

std::string penetration_words(const PenetrationRun& run, const base::DisplayUnits& shown)
{
  const std::string name = text::html_text(base::body_word(run.record.settings));
  if (run.z().empty() || !std::isfinite(run.area())) return fmt::format("The {} did not reach the soil, or its area is not known.", name);
  std::string words = begin_words(run, name, shown);
  if (!std::isfinite(run.last().q)) return words + fmt::format("{} = {}.", run.how.resistance.html, text::stress_words(run.q().back()));
  return words + last_words(run, shown) + ". " + steady_words(run) + cavity_words(run) + soil_words(run) + backflow_words(run) +
         surface_words(run);
}

std::string penetration_key_results(const PenetrationRuns& runs, const base::DisplayUnits& shown, const std::string& id)
{
  PenetrationRuns known;
  for (const PenetrationRun& run : runs)
    if (std::isfinite(base::quantity_value(run.record, "z_end"))) known.push_back(run);
  if (known.empty()) return "";
  const Penetrometer& how = known.front().how;
  const std::string title = fmt::format("Resistance over the depth of the {}", how.level);
  std::string html = plot::svg_of(depth_log(known, title));
  const Real half = known.front().half() / known.front().body.width;
  const char* what = known.front().body.disk       ? "V divided by the area of its largest section"
                     : known.front().knows_shaft() ? "V divided by the area, without the force on sides parallel to the axis: f is that "
                                                     "force divided by the area of the shaft in the soil, "
                                                     "its mean friction"
                                                   : "all of V divided by the area: friction on the sides of the body is included";
  html += fmt::format("<p class=\"quiet\">{} is {}.{}</p>\n", how.resistance.html, what,
                      half > 0 ? fmt::format(" Thin: rows of the history; thick, and in the tables: mean over ±{:.2g} D of travel.", half)
                               : "");
  driven::DrivenRuns driven;
  for (const PenetrationRun& run : known) driven.emplace_back(run.record, run.number);
  return html + summary_table(known, id + "-end") + depth_table(known, shown, id + "-depth") +
         (how.keeps_push ? "" : driven::converged_notes(driven));
}

std::string penetration_published(const PenetrationRuns& runs, const std::string& id)
{
  std::string html;
  int place = 0;
  for (const PenetrationRun& run : runs) {
    if (run.z().empty() || !std::isfinite(run.last().q)) continue;
    text::HtmlTable table(fmt::format("{}-published-{}", id, place++),
                          fmt::format("{}: exact and published values for its soil and depth", run.record.name));
    table.columns({{"quantity"}, {"berm", true}, {"formula", true}, {"berm/formula", true}, {"source"}, {"kind"}, {"range of validity"}});
    const bool open = cavity_is_open(run);
    for (const Comparison& c : run.how.published(run)) {
      const formulas::Source& source = c.published.source;
      if (source.label == formulas::Label::recalled || !std::isfinite(c.published.value)) continue;
      table.row({{c.quantity},
                 {text::table_number(c.berm), true},
                 {text::table_number(c.published.value), true},
                 {text::table_number(c.berm / c.published.value), true},
                 {text::html_text(citation(source)) + (c.about.empty() ? "" : "; " + c.about)},
                 {word_of(source.label)},
                 {(c.published.valid ? "" : "out of range: ") + base::printed_range(source.range) +
                  (open ? "; out of range: the cavity above is open" : "")}},
                c.published.valid && !open ? "" : "out_of_range");
    }
    if (!table.empty()) html += table.html();
  }
  const std::string remark = runs.empty() || *runs.front().how.remark == '\0' ? "" : text::html_paragraph(runs.front().how.remark, "quiet");
  if (html.empty() && (remark.empty() || place == 0)) return "";
  return "<h3>Published values</h3>\n" + html + remark;
}

}  // namespace berm::penetration
