// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/verification/verify_test.cpp
#include "verification/book.hpp"

#include "io/atomic_file.hpp"
#include "text/html.hpp"
#include "text/markdown.hpp"
#include "text/plain_page.hpp"
#include "verification/book_figures.hpp"
#include "verification/book_html.hpp"
#include "verification/book_index.hpp"
#include "verification/requirements.hpp"
#include "verification/trust_page.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::verification {
namespace {

namespace fs = std::filesystem;

/// The README's addresses as they are from the book: of files beside it, the way to them; pictures are copied into the book.
std::string readme(const ExamplePage& page, const fs::path& output)
{
  const fs::path& folder = page.example.folder;
  return text::html_of_markdown(readme_of(page.example), [&](const std::string& address) {
    const fs::path target = folder / address.substr(0, address.find('#'));
    std::error_code error;
    if (address.starts_with("#") || address.find(':') != std::string::npos || !fs::exists(target, error)) return address;
    if (target.extension() == ".png" || target.extension() == ".svg") {
      const fs::path copy = fs::path("figures") / (page.example.name + "_" + target.filename().string());
      io::make_folder(output / "figures");
      io::copy_atomically(target, output / copy);
      return address_of(copy);
    }
    return address_of(fs::proximate(fs::absolute(target).lexically_normal(), fs::absolute(output).lexically_normal(), error));
  });
}

/// Table and figures of what is expected of one run, or of the orders of convergence ("").
std::string findings_html(const ExamplePage& page, const std::string& run, const fs::path& output)
{
  std::string rows, figures;
  for (std::size_t k = 0; k < page.findings.size(); ++k) {
    const Expectation& e = page.example.expectations[k];
    const ExpectationResult& f = page.findings[k];
    if (e.run != run) continue;
    std::vector<std::string> cells = {text::html_text(f.what)};
    for (const std::string& cell : numbers_of(f)) cells.push_back(cell);
    cells.push_back(text::html_text(e.source) + fmt::format("<br><span class=\"quiet\">{}</span>", text::html_text(e.why)));
    rows += text::plain_row(cells, 1, 4, "td");
    const std::string name = fmt::format("{}_{}_{}", page.example.name, run.empty() ? convergence : run, k + 1);
    const ProblemResult* result = result_of(page, e.run);
    if (draw_finding(output / "figures", name, e, f, result == nullptr ? "" : result->folder))
      figures += fmt::format("<img src=\"{}\" alt=\"{}\">\n", address_of("figures/" + name + ".png"), text::html_text(f.what));
  }
  if (rows.empty()) return "";
  if (!figures.empty()) figures = fmt::format("<div class=\"pictures\">\n{}</div>\n", figures);
  return "<table>\n" +
         text::plain_row({"what", "exact", "berm", "error", "tolerance", "", "source, and reason for the tolerance"}, 1, 4, "th") + rows +
         "</table>\n" + figures;
}

std::string command_of(const ExamplePage& page, const VerificationRun& run)
{
  std::string command = fmt::format("berm {} {}", run.command(), (page.example.folder / run.case_file).lexically_normal().string());
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
    if (!run.is_run() ? name.ends_with(".png") : name == "curves.png" || name == "soil.png") names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string problem_html(const ExamplePage& page, std::size_t k, const fs::path& output)
{
  const auto& [name, run] = page.example.runs[k];
  const ProblemResult& result = page.results[k];
  const fs::path folder = fs::path(page.example.name) / name;
  std::string html =
      fmt::format("<h3 id=\"{0}\">{0}{1}</h3>\n", text::html_text(name), run.title.empty() ? "" : text::html_text(": " + run.title));
  html += fmt::format("<pre>{}</pre>\n", text::html_text(command_of(page, run)));
  if (result.end.kind == jobs::JobEnd::Kind::failed)
    html += fmt::format("<p>{} {}</p>\n", badge(Verdict::failed), text::html_text(result.end.reason));
  html += findings_html(page, name, output);
  std::string pictures, files;
  for (const std::string& picture : pictures_in(result.folder, run))
    pictures += fmt::format("<img src=\"{}\" alt=\"{}\">", address_of(folder / picture), picture);
  if (!pictures.empty()) html += fmt::format("<div class=\"pictures\">{}</div>\n", pictures);
  for (const char* file : {"element.html", "resolved.toml", "history.csv", "summary.json", "run.log", "frames/frames.pvd"})
    if (fs::exists(result.folder / file)) files += (files.empty() ? "" : ", ") + link_to(address_of(folder / file), file);
  if (const std::string time = time_of(result); !time.empty()) files += (files.empty() ? "" : "; ") + time;
  return html + (files.empty() ? "" : fmt::format("<p class=\"quiet\">{}</p>\n", files));
}

std::string example_page(const ExamplePage& page, const fs::path& output)
{
  std::string html = "<nav>" + link_to("index.html", "verification book") + "</nav>\n" + readme(page, output) + "<h2>Problems</h2>\n";
  for (std::size_t k = 0; k < page.example.runs.size(); ++k) html += problem_html(page, k, output);
  if (const std::string orders = findings_html(page, "", output); !orders.empty())
    html += fmt::format("<h2 id=\"{}\">Convergence</h2>\n{}", convergence, orders);
  return text::plain_page("berm: " + page.example.name, html);
}

}  // namespace

void write_book(const fs::path& output, const std::vector<ExamplePage>& pages, const std::vector<TrustQuestion>& questions)
{
  io::make_folder(output);
  for (const ExamplePage& page : pages) io::write_atomically(output / (page.example.name + ".html"), example_page(page, output));
  io::write_atomically(output / "requirements.html", requirements_page(pages));
  io::write_atomically(output / "trust.html", trust_page(questions));
  io::write_atomically(output / "index.html", index_page(pages, words_of(questions)));
}

}  // namespace berm::verification
