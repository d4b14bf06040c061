// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/verification/verify_test.cpp
#include "verification/book.hpp"

#include "io/atomic_file.hpp"
#include "run_folder/progress.hpp"
#include "text/markdown.hpp"
#include "text/tex_math.hpp"
#include "verification/book_figures.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <sstream>

namespace berm::verification {
namespace {

namespace fs = std::filesystem;

constexpr const char* style = R"(
:root { --line: #d9dee4; --quiet: #5b6570; --link: #1764ab; }
body { font: 15px/1.5 system-ui, 'DejaVu Sans', sans-serif; color: #1d232a; margin: 0; }
main { max-width: 1180px; margin: 0 auto; padding: 24px 28px 64px; }
h1 { font-size: 1.7em; margin: .4em 0 .5em; } h2 { font-size: 1.3em; margin: 2em 0 .5em; } h3 { font-size: 1.08em; margin: 1.8em 0 .4em; }
a { color: var(--link); text-decoration: none; } a:hover { text-decoration: underline; }
nav { color: var(--quiet); font-size: .9em; }
p.quiet, .quiet { color: var(--quiet); }
table { border-collapse: collapse; margin: .8em 0 1.2em; font-size: .92em; }
th, td { text-align: left; padding: 5px 14px 5px 0; border-bottom: 1px solid var(--line); vertical-align: top; }
th { color: var(--quiet); font-weight: 600; } td.number, th.number { text-align: right; white-space: nowrap; }
tr.chapter td { padding-top: 1.3em; font-weight: 600; font-size: 1.05em; }
code, pre { font: .9em/1.45 'DejaVu Sans Mono', monospace; } pre { background: #f5f7f9; padding: 12px 14px; overflow-x: auto; }
pre, .tex { border-radius: 4px; } .tex { background: #f5f7f9; padding: 1px 5px; }
math[display=block] { margin: 1em 0; font-size: 1.1em; }
img { max-width: 100%; height: auto; display: block; margin: .6em 0; }
.pictures { display: flex; flex-wrap: wrap; align-items: flex-start; gap: 12px; } .pictures img { width: 49%; min-width: 320px; border: 1px solid var(--line); }
.verdict { padding: 1px 9px; border-radius: 9px; font-size: .9em; white-space: nowrap; color: #fff; }
.met { background: #23813f; } .missed, .failed { background: #bf3425; } .not_run { background: #77818c; }
)";

std::string page(const std::string& title, const std::string& content)
{
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
      "content=\"width=device-width\">\n<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n<main>\n{}</main>\n</body>\n</html>\n",
      text::html_text(title), style, content);
}

std::string link_to(const std::string& address, const std::string& text)
{
  return fmt::format("<a href=\"{}\">{}</a>", text::html_text(address), text::html_text(text));
}

/// Addresses have no spaces; everything that is no plain character is written as %XX.
std::string address_of(const fs::path& path)
{
  std::string address;
  for (const char c : path.generic_string()) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = std::isalnum(byte) != 0 || std::string("/._-+=~").find(c) != std::string::npos;
    address += plain ? std::string(1, c) : fmt::format("%{:02X}", byte);
  }
  return address;
}

std::string badge(Verdict verdict)
{
  constexpr std::array classes{"met", "missed", "failed", "not_run"};
  return fmt::format("<span class=\"verdict {}\">{}</span>", classes[static_cast<std::size_t>(verdict)], word_of(verdict));
}

std::string row(const std::vector<std::string>& cells, std::size_t first_number, std::size_t last_number, const char* tag)
{
  std::string html = "<tr>";
  for (std::size_t k = 0; k < cells.size(); ++k)
    html += fmt::format("<{0}{1}>{2}</{0}>", tag, k >= first_number && k <= last_number ? " class=\"number\"" : "", cells[k]);
  return html + "</tr>\n";
}

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

constexpr const char* convergence = "convergence";  // the section of the orders, which belong to no one run

std::string readme_of(const Example& example)
{
  return io::read_text_file(example.folder / "README.md");
}

/// Its name and the first heading of its README.
std::string title_of(const Example& example)
{
  std::istringstream lines(readme_of(example));
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("# ")) return example.name + ": " + line.substr(2);
  return example.name;
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
  html += "<table>\n" + row({"problem", "what", "exact", "berm", "error", "tolerance", "", "time"}, 2, 5, "th");
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
      html += row(cells, 2, 5, "td");
    }
  }
  return page("berm: verification book", html + "</table>\n");
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
    rows += row(cells, 1, 4, "td");
    const std::string name = fmt::format("{}_{}_{}", chapter.example.name, run.empty() ? convergence : run, k + 1);
    const ProblemResult* result = result_of(chapter, e.run);
    if (draw_finding(output / "figures", name, e, f, result == nullptr ? "" : result->folder))
      figures += fmt::format("<img src=\"{}\" alt=\"{}\">\n", address_of("figures/" + name + ".png"), text::html_text(f.what));
  }
  if (rows.empty()) return "";
  if (!figures.empty()) figures = fmt::format("<div class=\"pictures\">\n{}</div>\n", figures);
  return "<table>\n" + row({"what", "exact", "berm", "error", "tolerance", "", "source, and why the tolerance is what it is"}, 1, 4, "th") +
         rows + "</table>\n" + figures;
}

std::string command_of(const Chapter& chapter, const VerificationRun& run)
{
  std::string command = "berm run " + (chapter.example.folder / run.case_file).lexically_normal().string();
  for (const std::string& set : run.set)
    command += set.find('\'') == std::string::npos ? fmt::format(" --set '{}'", set) : fmt::format(" --set \"{}\"", set);
  return command;
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
  for (const char* picture : {"curves.png", "soil.png"})
    if (fs::exists(result.folder / picture)) pictures += fmt::format("<img src=\"{}\" alt=\"{}\">", address_of(folder / picture), picture);
  if (!pictures.empty()) html += fmt::format("<div class=\"pictures\">{}</div>\n", pictures);
  for (const char* file : {"resolved.toml", "history.csv", "summary.json", "run.log", "frames/frames.pvd"})
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
  return page("berm: " + chapter.example.name, html);
}

}  // namespace

void write_book(const fs::path& output, const std::vector<Chapter>& chapters)
{
  io::make_folder(output);
  for (const Chapter& chapter : chapters) io::write_atomically(output / (chapter.example.name + ".html"), chapter_page(chapter, output));
  io::write_atomically(output / "index.html", index_page(chapters));
}

}  // namespace berm::verification
