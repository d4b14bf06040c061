// SPDX-License-Identifier: BSD-3-Clause
#include "element/element_report.hpp"

#include "element/element_table.hpp"
#include "io/atomic_file.hpp"
#include "os/error.hpp"
#include "plot/figure.hpp"
#include "run_folder/build.hpp"
#include "text/html.hpp"
#include "text/plain_page.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace berm::element {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* rows_file = "element.csv";
constexpr const char* page_file = "element.html";

std::string title_of(const ElementResults& results)
{
  return results.settings.title.empty() ? "Element tests" : results.settings.title;
}

/// As summary.json of a run: quantities TEST.NAME; a number that is not finite is null.
std::string summary_json(const ElementResults& results)
{
  Json quantities = Json::object(), checks = {{"finished", true}}, failures = Json::object();
  std::size_t steps = 0;
  for (const TestRecord& record : results.records) {
    for (const KeyResult& result : key_results(record))
      quantities[record.settings.name + "." + result.name] = {{"value", result.value}, {"unit", result.unit}, {"meaning", result.meaning}};
    checks[record.settings.name + ".failed"] = !record.failure.empty();
    if (!record.failure.empty()) failures[record.settings.name + ".failure"] = record.failure;
    steps += record.rows.size() - 1;
  }
  Json all = {{"quantities", quantities}, {"timing", {{"wall_s", results.wall_s}, {"steps", steps}}}, {"checks", checks}};
  all["text"] = {{"title", results.settings.title}, {"version", BERM_VERSION}};
  for (const auto& [name, words] : run_folder::this_build()) all["text"][name] = words;
  all["text"].update(failures);
  return all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string table_html(const ResultTable& table)
{
  const auto escaped = [](std::vector<std::string> cells) {
    for (std::string& cell : cells) cell = text::html_text(cell);
    return cells;
  };
  std::vector<std::string> head = escaped(table.tests);
  head.insert(head.begin(), "");
  std::string html = fmt::format("<div><h3>{}</h3>\n<table>\n", text::html_text(table.title)) + text::plain_row(head, 1, head.size(), "th");
  for (const std::vector<std::string>& row : table.rows) html += text::plain_row(escaped(row), 1, row.size(), "td");
  return html + "</table></div>\n";
}

std::string tests_html(const std::vector<TestRecord>& records)
{
  std::string html = "<table>\n" + text::plain_row({"test", "what", "rows", ""}, 9, 9, "th");
  for (const TestRecord& record : records) {
    const std::string name = text::html_text(record.settings.name);
    html += text::plain_row({name, text::html_text(words_of_test(record)), fmt::format("<a href=\"{0}/{1}\">{0}/{1}</a>", name, rows_file),
                             record.failure.empty() ? "" : text::html_text(record.failure)},
                            9, 9, "td");
  }
  return html + "</table>\n";
}

std::string page_html(const ElementResults& results, const std::vector<std::string>& figures, const fs::path& folder)
{
  std::string html = fmt::format("<h1>{}</h1>\n", text::html_text(title_of(results)));
  html += "<p>Laboratory tests of a soil element, computed by berm's soil laws. Compression is positive; p' is the mean effective stress, "
          "q the vertical minus the lateral stress, s1 and s3 are the largest and the smallest principal stress.</p>\n";
  html += tests_html(results.records) + "<h2>Results</h2>\n<div class=\"tables\">\n";
  for (const ResultTable& table : result_tables(results.records)) html += table_html(table);
  html += "</div>\n";
  std::string pictures;
  for (const std::string& figure : figures) pictures += plot::html_image(folder, figure, figure);
  if (!pictures.empty()) html += fmt::format("<h2>Curves</h2>\n<div class=\"pictures\">\n{}</div>\n", pictures);
  html += fmt::format("<h2>Input</h2>\n<pre>{}</pre>\n", text::html_text(io::read_text_file(folder / "case.toml")));
  html += fmt::format(
      "<p class=\"quiet\">berm {}; every default and all materials are in <a href=\"resolved.toml\">resolved.toml</a>, all digits in "
      "<a href=\"summary.json\">summary.json</a>.</p>\n",
      BERM_VERSION);
  return text::plain_page("berm: " + title_of(results), html);
}

/// Removes what earlier tests left: their folders, their pictures and what these were drawn from.
void remove_results(const fs::path& folder)
{
  std::error_code error;
  std::vector<fs::path> gone = {folder / "plots"};
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
    if (fs::exists(entry.path() / rows_file, error) || (entry.path().extension() == ".png" && fs::exists(folder / "plots", error)))
      gone.push_back(entry.path());
  for (const fs::path& path : gone) fs::remove_all(path, error);
}

}  // namespace

bool holds_results(const fs::path& folder)
{
  std::error_code error;
  if (fs::exists(folder / page_file, error)) return true;
  if (fs::exists(folder / "summary.json", error) || fs::exists(folder / "history.csv", error))
    throw InputError(fmt::format("{} holds the results of a run: name another folder with -o", folder.string()));
  return false;
}

void refuse_other_files(const fs::path& folder)
{
  std::error_code error;
  if (!holds_results(folder) && fs::is_directory(folder, error) && !fs::is_empty(folder, error) &&
      !fs::exists(folder / "resolved.toml", error))
    throw InputError(fmt::format("{} holds files that are not of element tests: name another folder with -o", folder.string()));
}

bool has_result(const ElementCase& settings, const fs::path& folder)
{
  try {
    const std::optional<run_folder::RunSummary> summary = run_folder::read_summary(folder);
    return summary && summary->finished() && run_folder::by_this_build(*summary, settings::Method::fem) &&
           io::read_text_file(folder / "resolved.toml") == resolved_toml(settings);
  } catch (const RunError&) {
    return false;
  }
}

void write_results(const ElementResults& results, const fs::path& folder)
{
  if (holds_results(folder)) remove_results(folder);
  io::make_folder(folder);
  io::copy_atomically(results.case_file, folder / "case.toml");
  io::write_atomically(folder / "resolved.toml", resolved_toml(results.settings));
  for (const TestRecord& record : results.records) {
    io::make_folder(folder / record.settings.name);
    write_rows(record, folder / record.settings.name / rows_file);
  }
  const std::vector<std::string> figures = draw_figures(results.records, folder);
  io::write_atomically(folder / page_file, page_html(results, figures, folder));  // by which the folder is known as one of tests
  io::write_atomically(folder / "summary.json", summary_json(results));
}

std::string words_of_results(const std::vector<TestRecord>& records)
{
  std::string words;
  constexpr std::size_t width = 38, least = 10;
  for (const ResultTable& table : result_tables(records)) {
    const auto add_line = [&](const std::string& first, auto begin) {
      words += fmt::format("  {:<{}}", first, width);
      for (const std::string& test : table.tests) words += fmt::format(" {:>{}}", *begin++, std::max(least, test.size()));
      words += '\n';
    };
    words += fmt::format("{}{}\n", words.empty() ? "" : "\n", table.title);
    add_line("", table.tests.begin());
    for (const std::vector<std::string>& row : table.rows) add_line(row[0], row.begin() + 1);
  }
  for (const TestRecord& record : records)
    if (!record.failure.empty()) words += fmt::format("{}: {}\n", record.settings.name, record.failure);
  return words;
}

}  // namespace berm::element
