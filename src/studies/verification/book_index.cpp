// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/verification/verify_chapters_test.cpp
#include "verification/book_index.hpp"

#include "io/duration_text.hpp"
#include "text/html.hpp"
#include "text/plain_page.hpp"
#include "verification/book_html.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::verification {
namespace {

/// The wall times of all problems with a result.
std::vector<ProblemTime> times_of(const std::vector<ExamplePage>& pages)
{
  std::vector<ProblemTime> times;
  for (const ExamplePage& page : pages)
    for (std::size_t k = 0; k < page.results.size(); ++k)
      if (const Real wall = jobs::wall_time_of(page.results[k].folder);
          page.results[k].end.kind == jobs::JobEnd::Kind::finished && std::isfinite(wall))
        times.push_back({page.example.name + "/" + page.example.runs[k].first, wall});
  return times;
}

std::string verdict_words(const std::vector<ExamplePage>& pages)
{
  std::array<int, 4> count{};
  for (const ExamplePage& page : pages)
    for (const ExpectationResult& f : page.findings) ++count[static_cast<std::size_t>(f.verdict)];
  std::string words = fmt::format("{} numbers met", count[0]);
  if (count[1] > 0) words += fmt::format(", {} missed", count[1]);
  if (count[2] > 0) words += fmt::format(", {} failed", count[2]);
  if (count[3] > 0) words += fmt::format(", {} not run", count[3]);
  return words;
}

std::string summary_words(const std::vector<ExamplePage>& pages)
{
  Real sum = 0;
  const std::vector<ProblemTime> times = times_of(pages);
  for (const ProblemTime& time : times) sum += time.wall_s;
  return fmt::format("{}. {} runs, {} in all on one thread each.", verdict_words(pages), times.size(), io::duration_text(sum));
}

std::string example_rows(const ExamplePage& page)
{
  const std::string& name = page.example.name;
  std::string html =
      fmt::format("<tr class=\"example\"><td colspan=\"8\">{}</td></tr>\n", link_to(address_of(name + ".html"), title_of(page.example)));
  for (std::size_t k = 0; k < page.findings.size(); ++k) {
    const Expectation& e = page.example.expectations[k];
    const ExpectationResult& f = page.findings[k];
    const ProblemResult* result = result_of(page, e.run);
    const std::string problem = f.problem.substr(name.size() + 1);
    std::vector<std::string> cells = {link_to(address_of(name + ".html") + "#" + (e.runs.empty() ? e.run : convergence), problem),
                                      text::html_text(f.what)};
    for (const std::string& cell : numbers_of(f)) cells.push_back(cell);
    cells.push_back(result == nullptr ? "" : time_of(*result));
    html += text::plain_row(cells, 2, 5, "td");
  }
  return html;
}

std::string longest_html(const std::vector<ExamplePage>& pages)
{
  const std::vector<ProblemTime> longest = longest_problems(pages);
  if (longest.empty()) return "";
  std::string html = "<h2 id=\"longest\">The longest runs</h2>\n<table>\n" + text::plain_row({"problem", "time"}, 1, 1, "th");
  for (const auto& [problem, wall] : longest) {
    const std::size_t slash = problem.find('/');
    html += text::plain_row(
        {link_to(address_of(problem.substr(0, slash) + ".html") + "#" + problem.substr(slash + 1), problem), io::duration_text(wall)}, 1, 1,
        "td");
  }
  return html + "</table>\n";
}

}  // namespace

std::vector<ProblemTime> longest_problems(const std::vector<ExamplePage>& pages)
{
  std::vector<ProblemTime> times = times_of(pages);
  std::stable_sort(times.begin(), times.end(), [](const ProblemTime& a, const ProblemTime& b) { return a.wall_s > b.wall_s; });
  times.resize(std::min<std::size_t>(times.size(), 10));
  return times;
}

std::string index_page(const std::vector<ExamplePage>& pages, const std::string& trust)
{
  std::string contents, tables;
  for (std::size_t k = 0; k < expectations::chapter_words.size(); ++k) {
    std::vector<ExamplePage> of_chapter;
    std::copy_if(pages.begin(), pages.end(), std::back_inserter(of_chapter),
                 [&](const ExamplePage& page) { return page.example.chapter == static_cast<Chapter>(k); });
    if (of_chapter.empty()) continue;
    contents +=
        fmt::format("<li>{}: {}</li>\n", link_to(std::string("#") + expectations::chapter_words[k], expectations::chapter_titles[k]),
                    verdict_words(of_chapter));
    tables += fmt::format("<h2 id=\"{}\">{}</h2>\n<table>\n", expectations::chapter_words[k], expectations::chapter_titles[k]);
    tables += text::plain_row({"problem", "what", "exact", "berm", "error", "tolerance", "", "time"}, 2, 5, "th");
    for (const ExamplePage& page : of_chapter) tables += example_rows(page);
    tables += "</table>\n";
  }
  std::string html = "<h1>berm: verification book</h1>\n";
  html += fmt::format("<p>What berm {} gives for problems with known answers: {}</p>\n", BERM_VERSION, summary_words(pages));
  html += "<p>" + link_to("requirements.html", "Requirements, their derivation, and the runs that verify them") + "</p>\n";
  html += fmt::format("<p>{}: {}.</p>\n", link_to("trust.html", "Are the verdicts of the pages right?"), text::html_text(trust));
  html += "<ul>\n" + contents + "</ul>\n" + tables + longest_html(pages);
  return text::plain_page("berm: verification book", html);
}

}  // namespace berm::verification
