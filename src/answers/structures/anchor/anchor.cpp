// SPDX-License-Identifier: BSD-3-Clause
#include "structures/anchor/anchor.hpp"

#include "plot/figure.hpp"
#include "structures/base/general_measures.hpp"
#include "structures/driven/quantities.hpp"
#include "text/html.hpp"
#include "text/quantity_words.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::anchor {
namespace {

constexpr int width = 1000, height = 520;  // pixels

bool is_of_tow(const run_folder::Quantity& quantity)
{
  return quantity.name.find("tow_") != std::string::npos;
}

}  // namespace

std::vector<run_folder::Quantity> Anchor::quantities(const record::RunRecord& run, const std::vector<Real>& held_forces) const
{
  std::vector<run_folder::Quantity> list = Driven::quantities(run, held_forces);
  if (list.empty()) return list;
  base::AnswerList own(run.settings.force_dimension());
  own.of("drags", "");
  own.add(tow_answers, tow_results(tow_path(run), base::body_scale(run)));
  list.insert(list.begin(), own.list().begin(), own.list().end());
  return list;
}

std::vector<std::string> Anchor::quantity_names(const problem::Case& c) const
{
  std::vector<std::string> names = Driven::quantity_names(c);
  if (names.empty()) return names;
  for (const auto& row : tow_answers) names.emplace_back(row.name);
  return names;
}

std::string Anchor::table_of(const record::RunRecord& run) const
{
  std::vector<run_folder::Quantity> driven = run.quantities;
  std::erase_if(driven, is_of_tow);
  std::string table = driven::key_results_table(driven, base::body_scale(run));
  for (const run_folder::Quantity& q : run.quantities)
    if (is_of_tow(q)) table += fmt::format("{:<24}{:>16} {}\n", q.name, fmt::format("{:.4g}", q.value), q.unit);
  return table;
}

std::string Anchor::in_words(const record::RunRecord& run, const base::DisplayUnits& shown) const
{
  const TowResults r = tow_results(tow_path(run), base::body_scale(run));
  if (!std::isfinite(r.travel)) return Driven::in_words(run, shown);  // pulled out, say
  const std::string name = text::html_text(base::body_word(run.settings));
  const int dimension = run.settings.force_dimension();
  const auto length = [](Real metres) { return text::length_words(metres); };
  const std::string goes_on =
      std::abs(r.depth_change) < 0.05 * std::max(std::abs(r.depth), r.last_travel)
          ? "at a constant depth"
          : fmt::format("still moving {} {}", length(std::abs(r.depth_change)), r.depth_change > 0 ? "deeper" : "up");
  return fmt::format(
      "Dragged {}, the lowest point of the {} moves from a depth of {} to {}; it was deepest, {}, after {}. The tow force is "
      "{} at most, after {}, and {} on average over the last "
      "{}, with V = {}; {}.",
      length(r.travel), name, length(r.first_depth), length(r.depth), length(r.max_depth), length(r.at_depth),
      text::force_words(r.max_force, dimension), length(r.at_force), text::force_words(r.force, dimension), length(r.last_travel),
      text::force_words(r.vertical, dimension), goes_on);
}

std::string Anchor::key_results(const base::Runs& runs, const base::DisplayUnits& shown) const
{
  if (runs.empty()) return "";
  text::HtmlTable table("anchor-tow", "Tow");
  const bool plane = runs.front().record->settings.force_dimension() == 2;
  const char *force = plane ? "kN/m" : "kN", *work = plane ? "kJ/m" : "kJ";
  struct Column {
    const char *words, *unit, *quantity;
    Real size;
  };
  const Column numbers[] = {{"travel", "m", "tow_travel", 1},        {"initial depth", "m", "tow_depth_begin", 1},
                            {"at end", "m", "tow_depth_end", 1},     {"largest", "m", "tow_depth_max", 1},
                            {"after", "m", "u_at_tow_depth_max", 1}, {"largest tow force", force, "tow_force_max", 1e3},
                            {"after", "m", "u_at_tow_force_max", 1}, {"at end", force, "tow_force_end", 1e3},
                            {"V at end", force, "tow_V_end", 1e3},   {"work", work, "tow_work", 1e3}};
  std::vector<text::HtmlCell> headings{{"run"}};
  for (const Column& c : numbers) headings.push_back({fmt::format("{}, {}", c.words, c.unit), true});
  table.columns(headings);
  for (const auto& [record, number] : runs) {
    if (!std::isfinite(base::quantity_value(*record, "tow_travel"))) continue;
    std::vector<text::HtmlCell> cells{{text::html_text(record->name)}};
    for (const Column& c : numbers) cells.push_back({text::table_number(base::quantity_value(*record, c.quantity) / c.size), true});
    table.row(cells);
  }
  return (table.empty() ? "" : table.html()) + Driven::key_results(runs, shown);
}

std::vector<std::string> Anchor::draw_report_curves(const base::Runs& runs, const base::PublishedPoints& published,
                                                    const std::filesystem::path& folder) const
{
  std::vector<std::string> drawn = Driven::draw_report_curves(runs, published, folder);
  plot::Figure depth{"Depth of the lowest point over travel",     "travel (m)", "depth (m)", {},
                     "set key below\nset yrange [*:*] reverse\n", width,        height};
  for (const auto& [record, number] : runs) {
    const TowPath path = tow_path(*record);
    if (path.travel.empty()) continue;
    depth.curves.push_back({record->name, plot::curve_style(number, number), path.travel, path.depth});
  }
  if (!depth.curves.empty() && draw_png_and_svg(folder, "anchor_depth", depth)) drawn.emplace_back("anchor_depth");
  return drawn;
}

}  // namespace berm::anchor
