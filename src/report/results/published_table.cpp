// SPDX-License-Identifier: BSD-3-Clause
#include "report/results/published_table.hpp"

#include "text/tex_math.hpp"
#include "structures/pipe/published.hpp"
#include "structures/pipe/run_points.hpp"

#include <cctype>
#include <fmt/format.h>

namespace berm {
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
  std::string text = html_text(range);
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

std::string state_words(const ComparedState& state, const RunRecord& run, const Shown& shown)
{
  const Real D = run.scale.diameter;
  const std::string w = fmt::format("w = {} D", said_number(state.w / D));
  const std::string V = fmt::format("V = {} {}", said_number(shown.in_force_unit(state.V)), shown.force_unit());
  switch (state.kind) {
  case ComparedState::Kind::push:
    return fmt::format("Pushed to {}", w);
  case ComparedState::Kind::end_of_push:
    return fmt::format("{}{} {}", with_capital(end_of_push(run).at), run.settings.method == Method::fem ? " from" : ",", w);
  case ComparedState::Kind::drag:
    return fmt::format("Dragged {} D: {}, {}", said_number(state.u / D), w, V);
  case ComparedState::Kind::breakout:
    return fmt::format("Breakout of the drag from {}{}", w, std::isnan(state.u) ? ": no peak in this run" : "");
  }
  return "";
}

std::vector<HtmlCell> cells_of(const Comparison& c, const RunRecord& run, const Shown& shown)
{
  const bool force = c.unit == Comparison::Unit::force;
  const auto number = [&](Real value) { return table_number(force ? shown.in_force_unit(value) : value / run.scale.diameter); };
  const Source& source = c.published.source;
  const std::string range = (c.published.valid ? "" : "out of range: ") + printed_range(source.range);
  return {{c.quantity},
          {force ? shown.force_unit() : "D"},
          {number(c.berm), true},
          {number(c.published.value), true},
          {table_number(c.ratio()), true},
          {html_text(c.about.empty() ? source.work : fmt::format("{}; {}", source.work, c.about))},
          {word_of(source.label)},
          {range}};
}

}  // namespace

std::string published_table(const RunRecord& run, const Shown& shown, const std::string& id)
{
  const PublishedValues values = published_beside(run);
  std::string html;
  for (const std::string& remark : values.remarks) html += html_paragraph(remark, "quiet");
  HtmlTable table(id, fmt::format("{}: design codes and published formulas for its soil, pipe and states", run.name));
  table.columns(
      {{"quantity"}, {"unit"}, {"berm", true}, {"formula", true}, {"berm/formula", true}, {"source"}, {"label"}, {"range of validity"}});
  for (const ComparedState& state : values.states) {
    table.row({{state_words(state, run, shown)}}, "group");
    for (const Comparison& comparison : state.comparisons)
      table.row(cells_of(comparison, run, shown), comparison.published.valid ? "" : "out_of_range");
  }
  return table.empty() ? html : html + table.html();
}

}  // namespace berm
