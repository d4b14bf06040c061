// SPDX-License-Identifier: BSD-3-Clause
#include "report/origin/origin_section.hpp"

#include "os/text_of_list.hpp"
#include "structures/base/driven_body.hpp"
#include "text/html.hpp"
#include "text/run_columns.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::report {
namespace {

using Runs = std::vector<record::RunRecord>;

/// The entries of [report] that are given, by their names on the page.
std::vector<std::pair<std::string, std::string>> document_of(const settings::ReportSettings& report)
{
  std::vector<std::pair<std::string, std::string>> entries = {
      {"Project", report.project}, {"Client", report.client}, {"Document", report.document},  {"Revision", report.revision},
      {"Date", report.date},       {"Author", report.author}, {"Checked by", report.checker}, {"Note", report.note}};
  std::erase_if(entries, [](const auto& entry) { return entry.second.empty(); });
  return entries;
}

text::RunEntry entry(const std::string& heading, const std::string& html)
{
  return {heading, text::html_text(heading), html, false, "", ""};
}

std::string code(const std::string& hash)
{
  return fmt::format("<code class=\"hash\">{}</code>", text::html_text(hash));
}

std::string not_recorded(const std::string& words)
{
  return words.empty() ? "not recorded" : text::html_text(words);
}

std::string documents_table(const Runs& runs)
{
  text::RunColumns columns("");
  bool any = false;
  for (const record::RunRecord& run : runs) {
    std::vector<text::RunEntry> entries;
    for (const auto& [name, words] : document_of(run.settings.report)) entries.push_back(entry(name, text::html_text(words)));
    any = any || !entries.empty();
    columns.run(run.name, entries);
  }
  return any ? columns.table("documents", "Documents: [report] of each case").html() : "";
}

std::vector<text::RunEntry> entries_of(const record::RunRecord& run)
{
  const auto summary = [&](const std::string& name) {
    const auto found = run.summary ? run.summary->text.find(name) : std::map<std::string, std::string>::const_iterator();
    return run.summary && found != run.summary->text.end() ? found->second : std::string();
  };
  std::vector<text::RunEntry> entries;
  entries.push_back(entry("begun (UTC)", run.begun.empty()                    ? "not recorded"
                                         : run.origin && run.origin->begins() ? text::html_text(run.begun)
                                                                              : text::html_text(run.begun + " (local time)")));
  entries.push_back(entry("ended (UTC)", not_recorded(summary("date"))));
  if (!run.origin) {
    entries.push_back(entry("program", "berm " + not_recorded(summary("version"))));
    entries.push_back(entry("SHA-256", "not recorded: the run was made by an earlier version"));
    return entries;
  }
  int resumptions = 0;
  for (const run_folder::RunSession& session : run.origin->sessions)
    if (session.resumption && ++resumptions > 0)
      entries.push_back(
          entry(fmt::format("resumed (UTC){}", resumptions == 1 ? "" : fmt::format(", {}", resumptions)), text::html_text(session.begun)));
  if (!run.origin->begins())
    entries.push_back(entry("SHA-256", "not recorded: origin.json was missing or damaged when the run was resumed"));
  for (const auto& [name, hash] : run.origin->input) {
    const bool changed = std::find(run.changed.begin(), run.changed.end(), name) != run.changed.end();
    entries.push_back(entry("SHA-256 of " + name, code(hash) + (changed ? " when the run began; the file was changed after that" : "")));
  }
  for (std::size_t k = 0; k < run.origin->sessions.size(); ++k) {
    const run_folder::RunSession& session = run.origin->sessions[k];
    const run_folder::RunSession& first = run.origin->sessions.front();
    if (k > 0 && session.program == first.program && session.build == first.build) continue;
    const std::string when = session.resumption ? fmt::format(", resumed {}", session.begun) : "";
    entries.push_back(entry("program" + when, text::html_text(fmt::format("berm {}, {}", session.version, session.build))));
    for (const auto& [name, hash] : session.program) entries.push_back(entry("SHA-256 of " + name + when, code(hash)));
  }
  return entries;
}

std::string units_words(const Runs& runs)
{
  const auto some = [&](settings::Geometry geometry) {
    return std::any_of(runs.begin(), runs.end(), [&](const record::RunRecord& run) { return run.settings.geometry == geometry; });
  };
  const bool models =
      std::any_of(runs.begin(), runs.end(), [](const record::RunRecord& run) { return has_prototype(base::body_scale(run.settings)); });
  const bool uneven = std::any_of(runs.begin(), runs.end(), [](const record::RunRecord& run) {
    return run.ground.embedment_counts_from_it && !run.ground.line.level();
  });
  return fmt::format(
      "SI units. {}{}{}u is along x, w the depth of the lowest point below the surface at the start{}, H the force of the body on the soil "
      "along x, V the upward reaction of the soil. {}",
      some(settings::Geometry::plane_strain) ? "Plane strain: forces are per metre run of the pipe or body. " : "",
      some(settings::Geometry::space) ? "In space forces are those of the whole body. " : "",
      some(settings::Geometry::axisymmetric) ? "Axisymmetric: x is the radius, and forces are those of the whole body, all around. " : "",
      uneven ? " (on ground that is not level: the surface under the axis)" : "",
      models ? "Values \"in the prototype\" are lengths and forces per metre times the gravity level; all others are of the model. " : "");
}

}  // namespace

std::string document_lines(const record::RunRecord& run)
{
  std::string html;
  for (const auto& [name, words] : document_of(run.settings.report))
    html += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>", name, text::html_text(words));
  return html.empty() ? "" : fmt::format("<dl id=\"document\">{}</dl>\n", html);
}

std::string document_foot(const record::RunRecord& run)
{
  const settings::ReportSettings& report = run.settings.report;
  std::vector<std::string> parts;
  for (const std::string& part : {report.project, report.document, report.revision.empty() ? "" : "revision " + report.revision})
    if (!part.empty()) parts.push_back(part);
  return text_of_list(parts, ", ");
}

std::string origin_section(const Runs& runs)
{
  text::RunColumns columns("");
  for (const record::RunRecord& run : runs) columns.run(run.name, entries_of(run));
  std::string html = columns.table("origin", "Input and program of each run").html();
  if (std::any_of(runs.begin(), runs.end(), [](const record::RunRecord& run) { return run.origin.has_value(); }))
    html += text::html_paragraph(
        "The hashes were noted in origin.json of each run folder when the run began and have been compared with the files in the folder: a "
        "file that was changed is named. case.toml is the input as given, resolved.toml the complete input with overrides and defaults.",
        "quiet");
  html = documents_table(runs) + text::html_beside(html);
  std::string words = "<div><h3>Units and signs</h3>\n" + text::html_paragraph(units_words(runs)) + "</div>\n";
  if (std::any_of(runs.begin(), runs.end(), [](const record::RunRecord& run) { return base::drives_a_body(run.settings); }))
    words += "<div><h3>Codes and papers</h3>\n" +
             text::html_paragraph(
                 "The source of each formula stands beside its value. berm has the formulas of design codes as public programs implement "
                 "them, with the editions and clauses that these programs name: they were not compared with the text of the code. They do "
                 "not replace a check against the edition that governs the project.") +
             "</div>\n";
  return text::html_section("record", "Record", html + text::html_beside(words));
}

}  // namespace berm::report
