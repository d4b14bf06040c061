// SPDX-License-Identifier: BSD-3-Clause
#include "report/quality/quality_section.hpp"

#include "report/quality/judgement.hpp"
#include "structures/base/driven_body.hpp"
#include "structures/base/general_measures.hpp"
#include "structures/generic/mechanism_cells.hpp"
#include "structures/structures.hpp"
#include "text/html.hpp"
#include "text/run_columns.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace berm::report {
namespace {

std::string reason_of(const base::TrustMeasure& measure)
{
  if (measure.limit == nullptr) return "";
  const base::Limit& limit = *measure.limit;
  const std::string good = measure.limit_words(limit.good), bad = measure.limit_words(limit.bad);
  return fmt::format("<span class=\"quiet\">good {} {}, bad {} {}: {}</span>", limit.large ? "from" : "up to", good,
                     limit.large ? "below" : "above", bad, text::html_text(limit.reason));
}

std::string content_of(const base::TrustMeasure& measure, const record::RunRecord& run)
{
  constexpr std::array words{"good", "fair", "bad", "not known"};
  const Real value = measure.value(run);
  if (std::isnan(value)) return html_badge(text::Standing::unknown, "not known");
  const std::string text = text::html_text(measure.words(run, value));
  if (measure.limit == nullptr) return text;
  const text::Standing standing = judge(*measure.limit, value);
  return fmt::format("{} {}", text, html_badge(standing, words[static_cast<std::size_t>(standing)]));
}

std::string table_of(const std::vector<record::RunRecord>& runs, problem::Method method, const std::string& id, const std::string& caption)
{
  text::RunColumns columns("", "", "judged by");
  bool any = false;
  for (const record::RunRecord& run : runs) {
    if (run.settings.method != method) continue;
    any = true;
    std::vector<text::RunEntry> entries;
    for (const base::TrustMeasure& measure : structures::structure_of(run.settings).measures(run.settings))
      if (measure.applies(run))
        entries.push_back({measure.what, text::html_text(measure.what), content_of(measure, run), true, "", reason_of(measure)});
    columns.run(run.name, entries);
  }
  return any ? columns.table(id, caption).html() : "";
}

/// Which runs have cells that no measure judges: without a driven body there is no width to compare them with.
std::string words_on_cells(const std::vector<record::RunRecord>& runs)
{
  std::vector<std::string> names;
  for (const record::RunRecord& run : runs)
    if (!base::drives_a_body(run.settings) && std::isnan(generic::cells_across_mechanism(run)))
      names.push_back("<strong>" + text::html_text(run.name) + "</strong>");
  if (names.empty()) return "";
  return fmt::format("<p class=\"cells\">Cells are not judged: {}. No body of a width is driven, and the frames show no soil that yields "
                     "in cells, so no measure tells how far the answer depends on the "
                     "mesh. Run the case again with cells half as large: coarse cells carry too much before the soil fails.</p>\n",
                     fmt::join(names, ", "));
}

std::string warning_list(const std::vector<record::RunRecord>& runs)
{
  std::string items;
  for (const record::RunRecord& run : runs)
    for (const std::string& words : judgement_of(run).warnings)
      items += fmt::format("<li class=\"warning\"><strong>{}</strong>: {}</li>\n", text::html_text(run.name), text::html_text(words));
  const std::string cells = words_on_cells(runs);
  if (!items.empty()) return fmt::format("<ul class=\"warnings\">\n{}</ul>\n", items) + cells;
  return cells.empty() ? text::html_paragraph("By these measures nothing is wrong.")
                       : text::html_paragraph("These measures find nothing, but do not tell whether the cells are fine enough.") + cells;
}

}  // namespace

std::string quality_section(const std::vector<record::RunRecord>& runs)
{
  std::string content = warning_list(runs);
  content += table_of(runs, problem::Method::mpm, "trust-mpm", "Can it be trusted? Material point method");
  content += table_of(runs, problem::Method::fem, "trust-fem", "Can it be trusted? Finite elements");
  for (const base::Structure* structure : structures::all_structures())
    content += structure->quality_note(structures::runs_of(*structure, runs));
  return text::html_section("trust", "Can it be trusted?", content);
}

}  // namespace berm::report
