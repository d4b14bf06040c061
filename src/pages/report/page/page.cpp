// SPDX-License-Identifier: BSD-3-Clause
#include "report/page/page.hpp"

#include "os/text_of_list.hpp"
#include "report/animation/film.hpp"
#include "report/animation/line_film.hpp"
#include "report/origin/origin_section.hpp"
#include "report/page/page_files.hpp"
#include "report/quality/quality_section.hpp"
#include "report/results/results_section.hpp"
#include "report/setup/setup_section.hpp"
#include "structures/base/invalid_answer.hpp"
#include "text/html.hpp"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <string>

namespace berm::report {
namespace {

using Json = nlohmann::ordered_json;

// Of all films together, as base64: the page of a study stays under 15 MB.
constexpr std::size_t max_film_bytes = 12'000'000;

/// JSON within a page: no "</script" or "<!--" can stand in it.
std::string script_json(const Json& json)
{
  std::string text;
  for (const char c : json.dump(-1, ' ', true, Json::error_handler_t::replace)) c == '<' ? text += "\\u003c" : text += c;
  return text;
}

Json published_json(const std::vector<record::RunRecord>& runs, const ExpectationSheets& expected)
{
  Json points = Json::array();
  for (const base::PublishedPoint& p : published_points(runs, expected))
    points.push_back({{"chart", word_of(p.chart)}, {"x", p.x ? Json(*p.x) : Json(nullptr)}, {"y", p.y}, {"label", p.label}});
  return points;
}

std::string title_of(const std::vector<record::RunRecord>& runs)
{
  const record::RunRecord& first = runs.front();
  const auto other =
      std::count_if(runs.begin(), runs.end(), [&](const record::RunRecord& run) { return run.settings.title != first.settings.title; });
  const std::string title = first.settings.title.empty() ? first.name : first.settings.title;
  return other == 0 ? title : fmt::format("{}, and {} of other titles", title, other == 1 ? "a run" : fmt::format("{} runs", other));
}

/// The rule that puts a text at the foot of each printed page. Of other letters than plain ones the numbers, so that none ends the text or the style.
std::string style_of_foot(const std::string& text)
{
  if (text.empty()) return "";
  std::string safe;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = std::isalnum(byte) != 0 || byte >= 0x80;
    safe += plain ? std::string(1, c) : fmt::format("\\{:06x}", byte);
  }
  return fmt::format("@page{{@bottom-left{{content:\"{}\";font:8pt sans-serif;color:#56606b}}}}", safe);
}

/// The title that runs have in common, in plain text; without one what they ask, else the titles.
std::string page_heading(const std::vector<record::RunRecord>& runs)
{
  const std::string& title = runs.front().settings.title;
  const bool common = std::ranges::all_of(runs, [&](const record::RunRecord& run) { return run.settings.title == title; });
  const std::string question = question_of(runs);
  return (common && !title.empty()) || question.empty() ? title_of(runs) : question;
}

/// A question as HTML. Names have no _, so that there is none but that of s_u.
std::string question_html(const std::string& question)
{
  std::string html = text::html_text(question);
  const std::string symbol = "s_u";
  if (const std::size_t place = html.find(symbol); place != std::string::npos) html.replace(place, symbol.size(), "s<sub>u</sub>");
  return html;
}

std::string header_of(const std::vector<record::RunRecord>& runs)
{
  std::vector<std::string> names;
  for (const record::RunRecord& run : runs) names.push_back(text::html_text(run.name));
  const std::string heading = page_heading(runs), question = question_of(runs), title = title_of(runs);
  const std::string below = heading == question ? text::html_text(title) : question_html(question);
  return fmt::format("<h1>{}</h1>\n{}<p class=\"quiet\">{}{}: {}; written by berm {}</p>\n",
                     heading == question ? question_html(heading) : text::html_text(heading),
                     below.empty() || title == question ? "" : fmt::format("<p class=\"subtitle\">{}</p>\n", below),
                     document_lines(runs.front()), runs.size() == 1 ? "run" : fmt::format("{} runs", runs.size()),
                     text_of_list(names, ", "), BERM_VERSION);
}

std::string navigation_of(const std::vector<std::pair<std::string, std::string>>& sections)
{
  std::vector<std::string> links;
  for (const auto& [id, word] : sections) links.push_back(fmt::format("<a href=\"#{}\">{}</a>", id, word));
  return fmt::format("<nav aria-label=\"sections\">{}</nav>\n", text_of_list(links, " "));
}

/// What a reader must know first of runs that did not end well.
std::string faults_of(const std::vector<record::RunRecord>& runs, const std::vector<std::string>& left_out)
{
  std::string items;
  for (const std::string& words : left_out) items += fmt::format("<li class=\"warning\">{}</li>\n", text::html_text(words));
  for (const record::RunRecord& run : runs) {
    std::vector<std::string> said;
    if (run.end == record::RunEnd::unfinished)
      said.emplace_back("has not finished: it was killed, crashed or is still running. The page shows what it wrote until then.");
    if (run.end == record::RunEnd::stopped)
      said.push_back(fmt::format("was stopped before its end. Its message: {}", run.last_log_line.empty() ? "nothing" : run.last_log_line));
    if (run.summary && !run.summary->invalid.empty())
      said.push_back(fmt::format("is invalid, and its numbers must not be used: {}.", base::invalid_words(run.summary->invalid)));
    said.insert(said.end(), run.faults.begin(), run.faults.end());
    for (const std::string& words : said)
      items += fmt::format("<li class=\"warning\"><strong>{}</strong> {}</li>\n", text::html_text(run.name), text::html_text(words));
  }
  return items.empty() ? "" : fmt::format("<ul class=\"warnings\" id=\"faults\">\n{}</ul>\n", items);
}

std::string licences()
{
  return fmt::format(
      "<details id=\"licences\" class=\"for_screen\"><summary>Licences of the code in this page</summary><pre>{}</pre></details>\n",
      text::html_text(std::string(page_licences)));
}

}  // namespace

std::string report_page(std::vector<record::RunRecord> runs, const ExpectationSheets& expected, const std::vector<std::string>& left_out)
{
  Json data = {{"version", BERM_VERSION}, {"runs", Json::array()}, {"published", published_json(runs, expected)}};
  std::string blocks;
  std::size_t left = max_film_bytes;
  const bool with_line =
      std::any_of(runs.begin(), runs.end(), [](const record::RunRecord& run) { return run.settings.pipeline.has_value(); });
  for (std::size_t k = runs.size(); k-- > 0;) {  // the smaller runs first: what they leave is the larger ones'
    Json run = run_data(runs[k]);
    run["of_test"] = is_of_a_test(runs[k], expected);
    const auto add = [&](const char* name, const Film& film) {
      runs[k].faults.insert(runs[k].faults.end(), film.faults.begin(), film.faults.end());
      run[name] = film.json;
      for (const FilmBlock& block : film.blocks) {
        blocks += fmt::format("<script type=\"text/plain\" id=\"{}\">{}</script>\n", block.id, block.base64);
        left -= std::min(left, block.base64.size());
      }
    };
    if (runs[k].settings.pipeline) add("line", make_line_film(runs[k], fmt::format("line-{}", k)));
    add("film", make_film(runs[k], fmt::format("film-{}", k), left / (k + 1)));
    data["runs"].insert(data["runs"].begin(), run);
  }

  const std::string what_is_expected = expectations_section(runs, expected), what_is_claimed = claims_section(runs, expected);
  std::vector<std::pair<std::string, std::string>> sections = {
      {"answer", "Answer"}, {"soil", "Soil"}, {"curves", "Curves"}, {"model", "Model"}, {"trust", "Reliability"}};
  if (with_line) sections.insert(sections.begin() + 1, {"line", "Line"});
  if (!what_is_expected.empty()) sections.emplace_back("expected", "Expected");
  if (!what_is_claimed.empty()) sections.emplace_back("claims", "Claims");
  sections.emplace_back("record", "Record");

  std::string page =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n" + text::content_policy(std::string(page_script_source));
  page += "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n";
  page += fmt::format("<title>{}</title>\n<style>{}{}</style>\n</head>\n<body>\n<main>\n", text::html_text(page_heading(runs)), page_style,
                      style_of_foot(document_foot(runs.front())));
  const std::vector<Judgement> judgements = judgements_of(runs);
  page += "<header>\n" + header_of(runs) + navigation_of(sections) + "</header>\n" + faults_of(runs, left_out) +
          results_section(runs, judgements, first_look(runs.front()));
  if (with_line)
    page += text::html_section("line", "Animation: the line in plan",
                               "<noscript><p>The moving line needs scripts, which this browser does not run.</p></noscript>\n");
  page += text::html_section("soil", "Animation: the soil",
                             "<noscript><p>The moving soil needs scripts, which this browser does not run.</p></noscript>\n");
  page += text::html_section("curves", "Curves", "<noscript><p>The curves need scripts, which this browser does not run.</p></noscript>\n");
  page += setup_section(runs) + quality_section(runs, judgements) + what_is_expected + what_is_claimed + origin_section(runs) + licences() +
          "</main>\n";
  page += blocks;
  page += fmt::format("<script type=\"application/json\" id=\"berm-data\">{}</script>\n<script>", script_json(data));
  page += page_script;
  return page + "</script>\n</body>\n</html>\n";
}

std::string word_page(const std::vector<record::RunRecord>& runs, const ExpectationSheets& expected,
                      const std::vector<std::string>& left_out, const std::vector<std::string>& pictures)
{
  const std::vector<Judgement> judgements = judgements_of(runs);
  std::string curves;
  for (const std::string& name : pictures) curves += fmt::format("<p><img src=\"{}\" alt=\"\"></p>\n", name);
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n</head>\n<body>\n" + header_of(runs) +
         faults_of(runs, left_out) + results_section(runs, judgements, first_look(runs.front())) +
         text::html_section("curves", "Curves", curves) + setup_section(runs) + quality_section(runs, judgements) +
         expectations_section(runs, expected) + claims_section(runs, expected) + origin_section(runs) + "</body>\n</html>\n";
}

}  // namespace berm::report
