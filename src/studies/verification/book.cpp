// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/verification/verify_test.cpp
#include "verification/book.hpp"

#include "io/atomic_file.hpp"
#include "run_folder/progress.hpp"
#include "text/html.hpp"
#include "text/markdown.hpp"
#include "text/plain_page.hpp"
#include "verification/book_figures.hpp"
#include "verification/book_html.hpp"
#include "verification/requirements.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::verification {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> numbers_of(const ExpectationResult& f)
{
  std::vector<std::string> cells;
  for (const std::string& text : {f.exact, f.reason.empty() ? f.berm : "", f.error, f.tolerance}) cells.push_back(text::html_text(text));
  cells.push_back(badge(f.verdict));
  return cells;
}

std::string time_of(const ProblemResult& result)
{
  return result.end.kind == jobs::JobEnd::Kind::finished ? run_folder::words_of_duration(jobs::wall_time_of(result.folder)) : "";
}

const ProblemResult* result_of(const Chapter& chapter, const std::string& run)
{
  for (std::size_t k = 0; k < chapter.results.size(); ++k)
    if (chapter.example.runs[k].first == run) return &chapter.results[k];
  return nullptr;
}

std::string summary_words(const std::vector<Chapter>& chapters)
{
  std::array<int, 4> count{};
  Real time = 0;
  std::size_t runs = 0;
  for (const Chapter& chapter : chapters) {
    for (const ExpectationResult& f : chapter.findings) ++count[static_cast<std::size_t>(f.verdict)];
    for (const ProblemResult& result : chapter.results)
      if (const Real wall = jobs::wall_time_of(result.folder); result.end.kind == jobs::JobEnd::Kind::finished && std::isfinite(wall))
        time += wall, ++runs;
  }
  std::string words = fmt::format("{} numbers met", count[0]);
  if (count[1] > 0) words += fmt::format(", {} missed", count[1]);
  if (count[2] > 0) words += fmt::format(", {} failed", count[2]);
  if (count[3] > 0) words += fmt::format(", {} not run", count[3]);
  return words + fmt::format(". {} runs, {} in all on one thread each.", runs, run_folder::words_of_duration(time));
}

std::string index_page(const std::vector<Chapter>& chapters)
{
  std::string html = "<h1>berm: verification book</h1>\n";
  html += fmt::format("<p>What berm {} gives for problems with known answers: {}</p>\n", BERM_VERSION, summary_words(chapters));
  html += "<p>" + link_to("requirements.html", "What is promised, where it is derived, and which run proves it") + "</p>\n";
  html += "<table>\n" + text::plain_row({"problem", "what", "exact", "berm", "error", "tolerance", "", "time"}, 2, 5, "th");
  for (const Chapter& chapter : chapters) {
    const std::string& name = chapter.example.name;
    html += fmt::format("<tr class=\"chapter\"><td colspan=\"8\">{}</td></tr>\n",
                        link_to(address_of(name + ".html"), title_of(chapter.example)));
    for (std::size_t k = 0; k < chapter.findings.size(); ++k) {
      const Expectation& e = chapter.example.expectations[k];
      const ExpectationResult& f = chapter.findings[k];
      const ProblemResult* result = result_of(chapter, e.run);
      const std::string problem = f.problem.substr(name.size() + 1);
      std::vector<std::string> cells = {link_to(address_of(name + ".html") + "#" + (e.runs.empty() ? e.run : convergence), problem),
                                        text::html_text(f.what)};
      for (const std::string& cell : numbers_of(f)) cells.push_back(cell);
      cells.push_back(result == nullptr ? "" : time_of(*result));
      html += text::plain_row(cells, 2, 5, "td");
    }
  }
  return text::plain_page("berm: verification book", html + "</table>\n");
}

/// The README's addresses as they are from the book: of files beside it, the way to them; pictures are copied into the book.
std::string readme(const Chapter& chapter, const fs::path& output)
{
  const fs::path& folder = chapter.example.folder;
  return text::html_of_markdown(readme_of(chapter.example), [&](const std::string& address) {
    const fs::path target = folder / address.substr(0, address.find('#'));
    std::error_code error;
    if (address.starts_with("#") || address.find(':') != std::string::npos || !fs::exists(target, error)) return address;
    if (target.extension() == ".png" || target.extension() == ".svg") {
      const fs::path copy = fs::path("figures") / (chapter.example.name + "_" + target.filename().string());
      io::make_folder(output / "figures");
      io::copy_atomically(target, output / copy);
      return address_of(copy);
    }
    return address_of(fs::proximate(fs::absolute(target).lexically_normal(), fs::absolute(output).lexically_normal(), error));
  });
}

/// Table and figures of what is expected of one run, or of the orders of convergence ("").
std::string findings_html(const Chapter& chapter, const std::string& run, const fs::path& output)
{
  std::string rows, figures;
  for (std::size_t k = 0; k < chapter.findings.size(); ++k) {
    const Expectation& e = chapter.example.expectations[k];
    const ExpectationResult& f = chapter.findings[k];
    if (e.run != run) continue;
    std::vector<std::string> cells = {text::html_text(f.what)};
    for (const std::string& cell : numbers_of(f)) cells.push_back(cell);
    cells.push_back(text::html_text(e.source) + fmt::format("<br><span class=\"quiet\">{}</span>", text::html_text(e.why)));
    rows += text::plain_row(cells, 1, 4, "td");
    const std::string name = fmt::format("{}_{}_{}", chapter.example.name, run.empty() ? convergence : run, k + 1);
    const ProblemResult* result = result_of(chapter, e.run);
    if (draw_finding(output / "figures", name, e, f, result == nullptr ? "" : result->folder))
      figures += fmt::format("<img src=\"{}\" alt=\"{}\">\n", address_of("figures/" + name + ".png"), text::html_text(f.what));
  }
  if (rows.empty()) return "";
  if (!figures.empty()) figures = fmt::format("<div class=\"pictures\">\n{}</div>\n", figures);
  return "<table>\n" +
         text::plain_row({"what", "exact", "berm", "error", "tolerance", "", "source, and why the tolerance is what it is"}, 1, 4, "th") +
         rows + "</table>\n" + figures;
}

std::string command_of(const Chapter& chapter, const VerificationRun& run)
{
  std::string command =
      (run.element ? "berm element " : "berm run ") + (chapter.example.folder / run.case_file).lexically_normal().string();
  for (const std::string& set : run.set)
    command += set.find('\'') == std::string::npos ? fmt::format(" --set '{}'", set) : fmt::format(" --set \"{}\"", set);
  return command;
}

/// Those of a run, or all of element tests.
std::vector<std::string> pictures_in(const fs::path& folder, const VerificationRun& run)
{
  std::vector<std::string> names;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (run.element ? name.ends_with(".png") : name == "curves.png" || name == "soil.png") names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string problem_html(const Chapter& chapter, std::size_t k, const fs::path& output)
{
  const auto& [name, run] = chapter.example.runs[k];
  const ProblemResult& result = chapter.results[k];
  const fs::path folder = fs::path(chapter.example.name) / name;
  std::string html =
      fmt::format("<h3 id=\"{0}\">{0}{1}</h3>\n", text::html_text(name), run.title.empty() ? "" : text::html_text(": " + run.title));
  html += fmt::format("<pre>{}</pre>\n", text::html_text(command_of(chapter, run)));
  if (result.end.kind == jobs::JobEnd::Kind::failed)
    html += fmt::format("<p>{} {}</p>\n", badge(Verdict::failed), text::html_text(result.end.reason));
  html += findings_html(chapter, name, output);
  std::string pictures, files;
  for (const std::string& picture : pictures_in(result.folder, run))
    pictures += fmt::format("<img src=\"{}\" alt=\"{}\">", address_of(folder / picture), picture);
  if (!pictures.empty()) html += fmt::format("<div class=\"pictures\">{}</div>\n", pictures);
  for (const char* file : {"element.html", "resolved.toml", "history.csv", "summary.json", "run.log", "frames/frames.pvd"})
    if (fs::exists(result.folder / file)) files += (files.empty() ? "" : ", ") + link_to(address_of(folder / file), file);
  if (const std::string time = time_of(result); !time.empty()) files += (files.empty() ? "" : "; ") + time;
  return html + (files.empty() ? "" : fmt::format("<p class=\"quiet\">{}</p>\n", files));
}

std::string chapter_page(const Chapter& chapter, const fs::path& output)
{
  std::string html = "<nav>" + link_to("index.html", "verification book") + "</nav>\n" + readme(chapter, output) + "<h2>Problems</h2>\n";
  for (std::size_t k = 0; k < chapter.example.runs.size(); ++k) html += problem_html(chapter, k, output);
  if (const std::string orders = findings_html(chapter, "", output); !orders.empty())
    html += fmt::format("<h2 id=\"{}\">Convergence</h2>\n{}", convergence, orders);
  return text::plain_page("berm: " + chapter.example.name, html);
}

}  // namespace

void write_book(const fs::path& output, const std::vector<Chapter>& chapters)
{
  io::make_folder(output);
  for (const Chapter& chapter : chapters) io::write_atomically(output / (chapter.example.name + ".html"), chapter_page(chapter, output));
  io::write_atomically(output / "requirements.html", requirements_page(chapters));
  io::write_atomically(output / "index.html", index_page(chapters));
}

}  // namespace berm::verification
