// SPDX-License-Identifier: BSD-3-Clause
#include "report/results/results_section.hpp"

#include "os/text_of_list.hpp"
#include "structures/base/still_moving.hpp"
#include "structures/other_bodies.hpp"
#include "structures/structures.hpp"
#include "text/html.hpp"
#include "text/quantity_words.hpp"

#include <fmt/format.h>

namespace berm::report {
namespace {

using Runs = std::vector<record::RunRecord>;

/// Which of the measures of trust are bad, in a sentence with a link to them, HTML; "" where none is.
std::string doubts_in_words(const record::RunRecord& run, const Judgement& judgement)
{
  std::vector<std::string> bad;
  for (const auto& [measure, value, standing] : judgement.measures)
    if (standing == text::Standing::bad) bad.push_back(text::html_text(fmt::format("{} – {}", measure.what, measure.words(run, value))));
  return bad.empty() ? "" : fmt::format("<a href=\"#trust\">Reliability</a> low: {}.", text_of_list(bad, "; "));
}

bool is_invalid(const record::RunRecord& run)
{
  return run.summary && !run.summary->invalid.empty();
}

std::string words_of(const record::RunRecord& run, const Judgement& judgement, const base::DisplayUnits& shown, bool several)
{
  const std::string name = several ? fmt::format("<strong>{}</strong> ", text::html_text(run.name)) : "";
  const std::string results = structures::structure_of(run.settings).in_words(run, shown);
  std::string doubts = doubts_in_words(run, judgement);
  for (const base::StillMoving& moving : base::still_moving(run))
    doubts += fmt::format("{}\"{}\" was {}.", doubts.empty() ? "" : " ", text::html_text(moving.stage), still_moving_words(moving));
  return fmt::format("<p>{}{}{}{}{}</p>\n", name, run.end == record::RunEnd::finished ? "" : "(not finished) ",
                     is_invalid(run) ? "(!) <strong>The answer is invalid; do not use these numbers.</strong> " : "", results,
                     doubts.empty() ? "" : " <span class=\"doubts\">" + doubts + "</span>");
}

/// The sentences of the first run with its first look, and folded those of the others.
std::string words_of(const Runs& runs, const std::vector<Judgement>& judgements, const base::DisplayUnits& shown, const FirstLook& look)
{
  std::string html = fmt::format("<div id=\"first-look\">\n<div>\n{}{}</div>\n{}</div>\n",
                                 words_of(runs.front(), judgements.front(), shown, runs.size() > 1), look.stages, look.picture);
  if (runs.size() == 1) return html;
  std::vector<std::string> names;
  std::string others;
  for (std::size_t k = 1; k < runs.size(); ++k) {
    names.push_back(text::html_text(runs[k].name));
    others += words_of(runs[k], judgements[k], shown, true);
  }
  return html + fmt::format("<details id=\"other-runs\"><summary>Results of the other {}: {}</summary>\n{}</details>\n",
                            runs.size() == 2 ? "run" : "runs", text_of_list(names, ", "), others);
}

/// The key results of the rigid bodies that stages drive besides the main one; "" where there is none.
std::string other_bodies(const record::RunRecord& run, const std::string& id)
{
  text::HtmlTable table(id, fmt::format("{}: other bodies", run.name));
  table.columns({{"result"}, {"value", true}, {"unit"}});
  for (const std::string& rigid : structures::other_driven_bodies(run.settings))
    for (const run_folder::Quantity& q : run.quantities)
      if (q.kind == run_folder::QuantityKind::answer && q.name.starts_with(rigid + '.'))
        table.row({{fmt::format("<code>{}</code> <span class=\"quiet\">{}</span>", text::html_text(q.name), text::html_text(q.meaning))},
                   {text::table_number(q.value), true},
                   {q.unit == "1" ? "" : text::html_text(q.unit)}});
  return table.empty() ? "" : table.html();
}

base::DisplayUnits units_of(const Runs& runs)
{
  std::vector<base::ScaledRun> scaled;
  for (const record::RunRecord& run : runs) scaled.push_back({base::body_scale(run), &run.quantities});
  return base::DisplayUnits(scaled);
}

}  // namespace

std::string results_section(const Runs& runs, const std::vector<Judgement>& judgements, const FirstLook& first_look)
{
  const base::DisplayUnits shown = units_of(runs);
  std::string html = two_methods(runs, judgements), key, published;
  for (const base::Structure& structure : structures::all_structures()) {
    const base::Runs of_structure = structures::runs_of(structure, runs);
    key += structure.key_results(of_structure, shown);
    published += structure.published_values(of_structure, shown);
  }
  for (std::size_t k = 0; k < runs.size(); ++k) key += other_bodies(runs[k], fmt::format("other-bodies-{}", k));
  if (!key.empty()) html += "<h3>Key results</h3>\n" + key;
  html += consolidation_table(runs) + support_table(runs) + published;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const std::string id = fmt::format("results-{}", k);
    html += structures::structure_of(runs[k].settings).other_results(runs[k], id);
  }
  html = reliable_method(runs, judgements) + (runs.size() == 1 ? headline_of(runs.front(), shown) : "") +
         words_of(runs, judgements, shown, first_look) + text::html_beside(html);
  // Tables of several runs name the run, with its mark, in each row; of one run the style of the class puts the mark behind each number.
  if (runs.size() == 1 && is_invalid(runs.front())) html = "<div class=\"invalid\">\n" + html + "</div>\n";
  return text::html_section("answer", "Answer", html);
}

}  // namespace berm::report
