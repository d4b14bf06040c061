// SPDX-License-Identifier: BSD-3-Clause
#include "report/results/results_section.hpp"
#include "report/results/generic_results.hpp"
#include "report/results/key_results.hpp"
#include "report/results/published_table.hpp"
#include "report/results/summary_text.hpp"
#include "text/html.hpp"
#include "text/tex_math.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::report {
namespace {

std::string words_of(const std::vector<pipe::RunRecord>& runs, const pipe::DisplayUnits& shown)
{
  std::string html;
  for (const pipe::RunRecord& run : runs) {
    const std::string name = runs.size() > 1 ? fmt::format("<strong>{}</strong> ", text::html_text(run.name)) : "";
    const std::string results =
        run.has_pipe() ? results_in_words(run, shown) : "There is no pipe in this run: no body that a push or drag drives.";
    const std::string doubts = doubts_in_words(run);
    html += fmt::format("<p>{}{}{}{}</p>\n", name, run.end == pipe::RunEnd::finished ? "" : "(not finished) ", results,
                        doubts.empty() ? "" : " <span class=\"doubts\">" + doubts + "</span>");
  }
  return html;
}

/// Of several runs each can be folded away; the first stands open.
std::string formulas_beside(const std::vector<pipe::RunRecord>& runs, const pipe::DisplayUnits& shown)
{
  std::string html;
  int place = 0;
  for (const pipe::RunRecord& run : runs) {
    if (!run.has_pipe()) continue;
    const std::string table = published_table(run, shown, fmt::format("published-{}", place));
    html += runs.size() == 1 ? table
                             : fmt::format("<details{}>\n<summary>{}</summary>\n{}</details>\n", place == 0 ? " open" : "",
                                           text::html_text(run.name), table);
    ++place;
  }
  if (html.empty()) return "";
  const std::string heading = "<h3>Design codes and published formulas</h3>\n";
  if (html.find("<table") == std::string::npos) return heading + html;
  return heading +
         text::html_paragraph(
             "What they give for the same soil, pipe and state: the embedment and the vertical load are those that the run found. Labels: "
             "exact is a closed "
             "form or computed to convergence, fit a published fit, recalled: quoted from memory; check the source.",
             "quiet") +
         html;
}

}  // namespace

std::string results_section(const std::vector<pipe::RunRecord>& runs)
{
  const pipe::DisplayUnits shown(runs);
  std::string html = words_of(runs, shown);
  const std::string key = key_results(runs, shown);
  if (!key.empty()) html += "<h3>Key results</h3>\n" + key;
  html += formulas_beside(runs, shown);
  for (std::size_t k = 0; k < runs.size(); ++k)
    if (!runs[k].has_pipe()) html += other_results(runs[k], fmt::format("results-{}", k));
  return text::html_section("answer", "Answer", html);
}

}  // namespace berm::report
