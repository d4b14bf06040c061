// SPDX-License-Identifier: BSD-3-Clause
#include "report/quality/quality_section.hpp"
#include "structures/base/driven_body.hpp"
#include "structures/base/general_measures.hpp"
#include "structures/structures.hpp"
#include "text/html.hpp"
#include "text/run_columns.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace berm::report {
namespace {

constexpr Real max_work_of_contact = 0.01;   // of all work: round-off and the contact's springs give less
constexpr std::size_t max_log_warnings = 5;  // of a run; a finite element run may warn at every increment

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

/// What is wrong with a run or not known of it, in words.
std::vector<std::string> warnings_of(const record::RunRecord& run)
{
  std::vector<std::string> found, not_known;
  const std::vector<std::string> spoiled = run.summary ? run.summary->spoiled : std::vector<std::string>();
  for (const std::string& why : spoiled)
    found.push_back("the answer is spoiled, and its numbers, which have the mark (!), are not to be used: " + why + ".");
  for (const base::TrustMeasure& measure : structures::structure_of(run.settings).measures(run.settings)) {
    if (!measure.applies(run)) continue;
    const Real value = measure.value(run);
    if (std::isnan(value))
      not_known.emplace_back(measure.what);
    else if (measure.limit != nullptr && judge(*measure.limit, value) != text::Standing::good &&
             std::find(spoiled.begin(), spoiled.end(), measure.warning(run, value)) == spoiled.end())
      found.push_back(measure.warning(run, value) + ".");
  }
  if (run.settings.method == problem::Method::mpm && !run.settings.mpm.volumetric_projection)
    found.emplace_back("plain triangles lock: mpm.volumetric_projection is off, and resistance is too large.");
  if (const Real given = base::work_of_contact(run); given > max_work_of_contact)
    found.push_back(fmt::format("contact gave {:.2g} % of the work instead of taking energy.", 100 * given));
  if (!run.summary && !not_known.empty())
    found.push_back(fmt::format("there is no summary of the run, so this is not known: {}.", fmt::join(not_known, "; ")));
  const std::vector<std::string> of_the_case = run.summary ? run.summary->warnings : std::vector<std::string>();
  for (const std::string& warning : of_the_case) found.push_back("the case is doubtful: " + warning);
  std::size_t in_log = 0;
  for (const std::string& warning : run.warnings)
    if (!warning.starts_with("the answer is spoiled: ") &&
        std::find(of_the_case.begin(), of_the_case.end(), warning) == of_the_case.end() && ++in_log <= max_log_warnings)
      found.push_back("run.log: " + warning);
  if (in_log > max_log_warnings) found.push_back(fmt::format("run.log has {} more warnings.", in_log - max_log_warnings));
  return found;
}

/// Which runs have cells that no measure judges: without a driven body there is no width to compare them with.
std::string words_on_cells(const std::vector<record::RunRecord>& runs)
{
  std::vector<std::string> names;
  for (const record::RunRecord& run : runs)
    if (!base::drives_a_body(run.settings)) names.push_back("<strong>" + text::html_text(run.name) + "</strong>");
  if (names.empty()) return "";
  return fmt::format(
      "<p class=\"cells\">Cells are not judged: {}. No body of a width is driven, so no measure tells how far the answer depends on the "
      "mesh. Run the case again with cells half as large: coarse cells carry too much before the soil fails.</p>\n",
      fmt::join(names, ", "));
}

std::string warning_list(const std::vector<record::RunRecord>& runs)
{
  std::string items;
  for (const record::RunRecord& run : runs)
    for (const std::string& words : warnings_of(run))
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
