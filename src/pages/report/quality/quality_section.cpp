// SPDX-License-Identifier: BSD-3-Clause
#include "report/quality/quality_section.hpp"

#include "os/text_of_list.hpp"
#include "structures/base/driven_body.hpp"
#include "structures/structures.hpp"
#include "text/html.hpp"
#include "text/run_columns.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace berm::report {
namespace {

using Runs = std::vector<record::RunRecord>;
using Judgements = std::vector<Judgement>;

std::string reason_of(const base::TrustMeasure& measure)
{
  if (measure.limit == nullptr) return "";
  const base::Limit& limit = *measure.limit;
  const std::string good = measure.limit_words(limit.good), bad = measure.limit_words(limit.bad);
  return fmt::format("<span class=\"quiet\">good {} {}, bad {} {}: {}. See <cite>{}</cite></span>", limit.large ? "from" : "up to", good,
                     limit.large ? "below" : "above", bad, text::html_text(limit.reason), heading_of(limit.effect));
}

std::string content_of(const JudgedMeasure& judged, const record::RunRecord& run)
{
  constexpr std::array words{"good", "fair", "bad", "not known"};
  if (judged.standing == text::Standing::unknown) return html_badge(judged.standing, "not known");
  const std::string text = text::html_text(judged.measure.words(run, judged.value));
  if (judged.measure.limit == nullptr) return text;
  return fmt::format("{} {}", text, html_badge(judged.standing, words[static_cast<std::size_t>(judged.standing)]));
}

std::string table_of(const Runs& runs, const Judgements& judgements, settings::Method method, const std::string& id,
                     const std::string& caption)
{
  text::RunColumns columns("", "", "judged by");
  bool any = false;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    if (runs[k].settings.method != method) continue;
    any = true;
    std::vector<text::RunEntry> entries;
    for (const JudgedMeasure& judged : judgements[k].measures)
      entries.push_back(
          {judged.measure.what, text::html_text(judged.measure.what), content_of(judged, runs[k]), true, "", reason_of(judged.measure)});
    columns.run(runs[k].name, entries);
  }
  return any ? columns.table(id, caption).html() : "";
}

bool judges_cells(const Judgement& judgement)
{
  return std::any_of(judgement.measures.begin(), judgement.measures.end(),
                     [](const JudgedMeasure& judged) { return judged.measure.of_cells && judged.standing != text::Standing::unknown; });
}

/// Which runs have cells that no measure judges: without a driven body there is no width to compare them with.
std::string words_on_cells(const Runs& runs, const Judgements& judgements)
{
  std::vector<std::string> names;
  for (std::size_t k = 0; k < runs.size(); ++k)
    if (!base::drives_a_body(runs[k].settings) && !judges_cells(judgements[k]))
      names.push_back("<strong>" + text::html_text(runs[k].name) + "</strong>");
  if (names.empty()) return "";
  return fmt::format("<p class=\"cells\">Cells are not judged: {}. No body with a width is driven, and the frames show no yielding soil, "
                     "so no measure shows how far the result depends on the mesh. Run the case again with cells half as large: with coarse "
                     "cells the resistance before failure is too large.</p>\n",
                     text_of_list(names, ", "));
}

std::string warning_list(const Runs& runs, const Judgements& judgements)
{
  std::string items;
  for (std::size_t k = 0; k < runs.size(); ++k)
    for (const std::string& words : judgements[k].warnings)
      items += fmt::format("<li class=\"warning\"><strong>{}</strong>: {}</li>\n", text::html_text(runs[k].name), text::html_text(words));
  const std::string cells = words_on_cells(runs, judgements);
  if (!items.empty()) return fmt::format("<ul class=\"warnings\">\n{}</ul>\n", items) + cells;
  return cells.empty()
             ? text::html_paragraph("By these measures nothing is wrong.")
             : text::html_paragraph("These measures find nothing wrong, but do not show whether the cells are fine enough.") + cells;
}

}  // namespace

std::string quality_section(const Runs& runs, const Judgements& judgements)
{
  std::string content = warning_list(runs, judgements);
  content += table_of(runs, judgements, settings::Method::mpm, "trust-mpm", "Reliability: material point method");
  content += table_of(runs, judgements, settings::Method::fem, "trust-fem", "Reliability: finite elements");
  content += "<p class=\"quiet\">See: sections of <cite>Common pitfalls</cite> in the documentation of berm "
             "(docs/how_to/what_will_catch_you.md), which say how large each effect is and what to do.</p>\n";
  for (const base::Structure& structure : structures::all_structures())
    content += structure.quality_note(structures::runs_of(structure, runs));
  return text::html_section("trust", "Reliability", content);
}

}  // namespace berm::report
