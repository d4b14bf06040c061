// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/report/results/results_section_test.cpp
#include "structures/pipe/pipe_report.hpp"

#include "structures/base/display_units.hpp"
#include "structures/driven/run_points.hpp"
#include "structures/pipe/published.hpp"
#include "text/html.hpp"
#include "text/quantity_words.hpp"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>

namespace berm::pipe {
namespace {

std::string with_capital(std::string words)
{
  words[0] = static_cast<char>(std::toupper(words[0]));
  return words;
}

/// What of the end of a drag has no number in the run.
std::string not_reached_words(const ComparedState& state)
{
  const auto missing =
      std::ranges::find_if(state.comparisons, [](const Comparison& c) { return c.unit == Comparison::Unit::force && std::isnan(c.berm); });
  return missing == state.comparisons.end() ? "" : fmt::format("; no {} was reached", missing->quantity);
}

std::string state_words(const ComparedState& state, const driven::DrivenRun& run, const base::DisplayUnits& shown)
{
  const Real D = run.scale.width;
  std::string w = fmt::format("w = {} D", text::short_number(state.w / D));
  if (std::isfinite(state.strength)) w += fmt::format(" (s<sub>u</sub> = {} kPa at the invert)", text::short_number(state.strength / 1e3));
  const std::string V = fmt::format("V = {} {}", text::short_number(shown.in_force_unit(state.V)), shown.force_unit(run.scale));
  switch (state.kind) {
  case ComparedState::Kind::push:
    return fmt::format("Pushed to {}", w);
  case ComparedState::Kind::end_of_push:
    return fmt::format("{}{} {}", with_capital(driven::end_of_push(run).at), run.settings.small_strain() ? " from" : ",", w);
  case ComparedState::Kind::drag:
    return fmt::format("Dragged {} D: {}, {}", text::short_number(state.u / D), w, V);
  case ComparedState::Kind::peak:
    if (state.point == ComparedState::Point::onset) return fmt::format("No peak in this drag: H at which it begins to slide: {}, {}", w, V);
    return fmt::format("{} at u = {} D: {}, {}",
                       state.point == ComparedState::Point::peak ? "Breakout of the drag" : "No peak in this drag: largest H,",
                       text::short_number(state.u / D), w, V);
  case ComparedState::Kind::end_of_drag:
    return fmt::format("End of {}, u = {} D from w = {} D: {}, {}{}", text::html_text(state.stage), text::short_number(state.u / D),
                       text::short_number(state.w_begin / D), w, V, not_reached_words(state));
  case ComparedState::Kind::uplift:
    return fmt::format("{}, lifted from {}: {} after {} D", text::html_text(state.stage), w,
                       state.point == ComparedState::Point::peak ? "peak" : "largest resistance", text::short_number(state.u / D));
  case ComparedState::Kind::breakout:
    return fmt::format("Displacement at breakout of the drag from {}{}", w, std::isnan(state.u) ? ": no peak in this run" : "");
  }
  return "";
}

std::vector<text::HtmlCell> cells_of(const Comparison& c, const driven::DrivenRun& run, const base::DisplayUnits& shown)
{
  const bool force = c.unit == Comparison::Unit::force;
  const auto number = [&](Real value) { return text::table_number(force ? shown.in_force_unit(value) : value / run.scale.width); };
  const formulas::Source& source = c.published.source;
  const std::string range = (c.published.valid ? "" : "out of range: ") + base::printed_range(source.range);
  return {{c.quantity},
          {force ? shown.force_unit(run.scale) : "D"},
          {force && std::isnan(c.berm) ? "not reached" : number(c.berm), true},
          {number(c.published.value), true},
          {text::table_number(c.ratio()), true},
          {text::html_text(c.about.empty() ? citation(source) : fmt::format("{}; {}", citation(source), c.about))},
          {word_of(source.label)},
          {range}};
}

bool is_confirmed(const Comparison& comparison)
{
  return comparison.published.source.label != formulas::Label::recalled;
}

/// A table with the run's states as groups, then remarks. `id` names the table. Formulas that are only recalled are not shown: nobody is to take them for
/// quotations.
std::string published_table(const driven::DrivenRun& run, const base::DisplayUnits& shown, const std::string& id)
{
  const PublishedValues values = published_beside(run);
  std::string html;
  for (const std::string& remark : values.remarks) html += text::html_paragraph(remark, "quiet");
  text::HtmlTable table(id, fmt::format("{}: design codes and published formulas for its soil, pipe and states", run.name));
  table.columns(
      {{"quantity"}, {"unit"}, {"berm", true}, {"formula", true}, {"berm/formula", true}, {"source"}, {"kind"}, {"range of validity"}});
  for (const ComparedState& state : values.states) {
    if (std::none_of(state.comparisons.begin(), state.comparisons.end(), is_confirmed)) continue;
    table.row({{state_words(state, run, shown)}}, "group");
    for (const Comparison& comparison : state.comparisons)
      if (is_confirmed(comparison)) table.row(cells_of(comparison, run, shown), comparison.published.valid ? "" : "out_of_range");
  }
  return (table.empty() ? "" : table.html()) + html;
}

}  // namespace

std::string published_values(const driven::DrivenRuns& runs, const base::DisplayUnits& shown)
{
  std::string html;
  int place = 0;
  for (const driven::DrivenRun& run : runs) {
    const std::string table = published_table(run, shown, fmt::format("published-{}", place));
    if (table.empty()) continue;
    html += runs.size() == 1 ? table
                             : fmt::format("<details{}>\n<summary>{}</summary>\n{}</details>\n", place == 0 ? " open" : "",
                                           text::html_text(run.name), table);
    ++place;
  }
  if (html.empty()) return "";
  const std::string heading = "<h3>Design codes and published formulas</h3>\n";
  if (html.find("<table") == std::string::npos) return heading + html;
  return heading + html +
         text::html_paragraph(
             "What they give for the same soil, pipe and state, with the embedment and the vertical load of the run. Kinds: exact is a "
             "closed form or computed to convergence; lower bound is the least that the soil carries, so that berm may be above it; fit is "
             "an empirical fit as implemented in public programs. Editions and clauses are those that these programs name "
             "(docs/formulas.md): they were not compared with the printed texts. Low (LE), best (BE) and high (HE) estimates are "
             "those "
             "of the source.",
             "quiet");
}

}  // namespace berm::pipe
