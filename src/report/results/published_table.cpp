// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/report/results/results_section_test.cpp
#include "report/results/published_table.hpp"

#include "structures/pipe/published.hpp"
#include "structures/pipe/run_points.hpp"
#include "text/tex_math.hpp"

#include <cctype>
#include <fmt/format.h>

namespace berm::report {
namespace {

/// A range of src/formulas, "0 <= w/D <= 0.5", with the signs of print, HTML.
std::string printed_range(const char* range)
{
  constexpr std::pair<const char*, const char*> signs[] = {{"&lt;=", "≤"},
                                                           {"&gt;=", "≥"},
                                                           {"phi", "φ"},
                                                           {"psi", "ψ"},
                                                           {"delta", "δ"},
                                                           {" deg", "°"},
                                                           {"s_u", "s<sub>u</sub>"},
                                                           {"V_max", "V<sub>max</sub>"}};
  std::string text = text::html_text(range);
  for (const auto& [plain, sign] : signs)
    for (std::size_t at = text.find(plain); at != std::string::npos; at = text.find(plain, at + 1))
      text.replace(at, std::string(plain).size(), sign);
  return text;
}

std::string with_capital(std::string words)
{
  words[0] = static_cast<char>(std::toupper(words[0]));
  return words;
}

std::string state_words(const pipe::ComparedState& state, const pipe::RunRecord& run, const pipe::DisplayUnits& shown)
{
  const Real D = run.scale.diameter;
  const std::string w = fmt::format("w = {} D", pipe::short_number(state.w / D));
  const std::string V = fmt::format("V = {} {}", pipe::short_number(shown.in_force_unit(state.V)), shown.force_unit());
  switch (state.kind) {
  case pipe::ComparedState::Kind::push:
    return fmt::format("Pushed to {}", w);
  case pipe::ComparedState::Kind::end_of_push:
    return fmt::format("{}{} {}", with_capital(end_of_push(run).at), run.settings.method == problem::Method::fem ? " from" : ",", w);
  case pipe::ComparedState::Kind::drag:
    return fmt::format("Dragged {} D: {}, {}", pipe::short_number(state.u / D), w, V);
  case pipe::ComparedState::Kind::breakout:
    return fmt::format("Breakout of the drag from {}{}", w, std::isnan(state.u) ? ": no peak in this run" : "");
  }
  return "";
}

std::vector<text::HtmlCell> cells_of(const pipe::Comparison& c, const pipe::RunRecord& run, const pipe::DisplayUnits& shown)
{
  const bool force = c.unit == pipe::Comparison::Unit::force;
  const auto number = [&](Real value) { return pipe::table_number(force ? shown.in_force_unit(value) : value / run.scale.diameter); };
  const formulas::Source& source = c.published.source;
  const std::string range = (c.published.valid ? "" : "out of range: ") + printed_range(source.range);
  return {{c.quantity},
          {force ? shown.force_unit() : "D"},
          {number(c.berm), true},
          {number(c.published.value), true},
          {pipe::table_number(c.ratio()), true},
          {text::html_text(c.about.empty() ? source.work : fmt::format("{}; {}", source.work, c.about))},
          {word_of(source.label)},
          {range}};
}

}  // namespace

std::string published_table(const pipe::RunRecord& run, const pipe::DisplayUnits& shown, const std::string& id)
{
  const pipe::PublishedValues values = published_beside(run);
  std::string html;
  for (const std::string& remark : values.remarks) html += text::html_paragraph(remark, "quiet");
  text::HtmlTable table(id, fmt::format("{}: design codes and published formulas for its soil, pipe and states", run.name));
  table.columns(
      {{"quantity"}, {"unit"}, {"berm", true}, {"formula", true}, {"berm/formula", true}, {"source"}, {"label"}, {"range of validity"}});
  for (const pipe::ComparedState& state : values.states) {
    table.row({{state_words(state, run, shown)}}, "group");
    for (const pipe::Comparison& comparison : state.comparisons)
      table.row(cells_of(comparison, run, shown), comparison.published.valid ? "" : "out_of_range");
  }
  return table.empty() ? html : html + table.html();
}

}  // namespace berm::report
