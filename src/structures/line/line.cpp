// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/library/library_pipeline_test.cpp
#include "structures/line/line.hpp"

#include "record/panels.hpp"
#include "text/html.hpp"
#include "text/quantity_words.hpp"

#include <array>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace berm::line {
namespace {

/// A number of the line at the end of a stage, and its column of the history.
struct Answer {
  const char *name, *column, *unit, *meaning;
};
constexpr std::array<Answer, 9> answers = {{
    {"y", "line_y_m", "m", "largest lateral displacement of the line, from its straight axis"},
    {"x_of_y", "line_x_m", "m", "where it is, along the line"},
    {"crossing", "line_crossing_m", "m", "place beyond it where the line crosses its axis"},
    {"z", "line_z_m", "m", "height of the line there, from where it was laid"},
    {"P", "line_P_N", "N", "effective compression at x = 0"},
    {"M", "line_M_Nm", "N m", "largest lateral bending moment"},
    {"strain_max", "line_strain_max", "1", "largest longitudinal strain"},
    {"strain_min", "line_strain_min", "1", "smallest longitudinal strain: the largest in compression"},
    {"feed_in", "line_feed_in_m", "m", "axial displacement at the last slice, towards x = 0"},
}};

/// The last row of a stage, or none.
Index last_row_of(const run_folder::History& history, const std::string& stage)
{
  for (Index row = history.rows(); row-- > 0;)
    if (history.stage[static_cast<std::size_t>(row)] == stage) return row;
  return none;
}

/// act(name of a stage, of) for each stage that has loaded the line; of(NAME) is its answer of that name, or NaN.
template <class Act>
void for_loaded_stages(const record::RunRecord& run, const Act& act)
{
  for (const problem::StageSettings& stage : run.settings.stage) {
    const auto of = [&](const char* name) {
      const run_folder::Quantity* found = run.quantity(fmt::format("{}.{}", stage.name, name));
      return found == nullptr ? nan : found->value;
    };
    if (stage.kind == problem::StageKind::pipeline && !std::isnan(of("y"))) act(stage.name, of);
  }
}

}  // namespace

std::vector<run_folder::Quantity> Line::quantities(const record::RunRecord& run, const std::vector<Real>&) const
{
  std::vector<run_folder::Quantity> list;
  for (const problem::StageSettings& stage : run.settings.stage) {
    const Index row = last_row_of(run.history, stage.name);
    if (stage.kind != problem::StageKind::pipeline || row == none) continue;
    for (const Answer& answer : answers)
      if (run.history.has(answer.column))
        if (const Real value = run.history[answer.column][static_cast<std::size_t>(row)]; std::isfinite(value))
          list.push_back({fmt::format("{}.{}", stage.name, answer.name), value, answer.unit,
                          fmt::format("{} at the end of the stage", answer.meaning), run_folder::QuantityKind::answer, stage.name});
  }
  return list;
}

std::vector<std::string> Line::quantity_names(const problem::Case& c) const
{
  std::vector<std::string> names;
  for (const problem::StageSettings& stage : c.stage)
    if (stage.kind == problem::StageKind::pipeline)
      for (const Answer& answer : answers) names.push_back(fmt::format("{}.{}", stage.name, answer.name));
  return names;
}

std::string Line::table_of(const record::RunRecord& run) const
{
  std::string rows;
  for_loaded_stages(run, [&](const std::string& stage, const auto& of) {
    rows += fmt::format("{:<16}{:>9.3f}{:>10.1f}{:>10.1f}{:>11.1f}{:>12.3f}%{:>12.3f}%{:>11.4f}\n", stage, of("y"), 1e3 * of("z"),
                        of("P") / 1e3, of("M") / 1e3, 100 * of("strain_max"), 100 * of("strain_min"), of("feed_in"));
  });
  if (rows.empty()) return "";
  return fmt::format("{:<16}{:>9}{:>10}{:>10}{:>11}{:>13}{:>13}{:>11}\n", "", "y, m", "z, mm", "P, kN", "M, kN m", "max strain",
                     "min strain", "feed-in, m") +
         rows;
}

bool Line::draw_curves(const run_folder::RunFolder& folder, const record::RunRecord& run, const base::CurveBands&) const
{
  return record::draw_columns(
      folder, run.history, {"line_y_m", "line_z_m", "line_P0_N", "line_P_N", "line_M_Nm", "line_strain_max", "line_strain_min", "line_T_K"},
      run.settings.title);
}

std::string Line::in_words(const record::RunRecord& run, const base::DisplayUnits&) const
{
  std::string words;
  for_loaded_stages(run, [&](const std::string& stage, const auto& of) {
    words += fmt::format("At the end of {} the line stands {:.3g} m from its axis at x = {:.3g} m, with {:.4g} kN of effective "
                         "compression, a bending moment of {:.4g} kN m and strains of {:.2g} and {:.2g} %. ",
                         text::html_text(stage), of("y"), of("x_of_y"), of("P") / 1e3, of("M") / 1e3, 100 * of("strain_max"),
                         100 * of("strain_min"));
  });
  return words.empty() ? "The line has not been loaded yet." : words;
}

std::string Line::other_results(const record::RunRecord& run, const std::string& id) const
{
  text::HtmlTable table(id + "-line", fmt::format("{}: the line at the end of each of its stages", run.name));
  table.columns({{"stage"},
                 {"y, m", true},
                 {"z, mm", true},
                 {"P, kN", true},
                 {"M, kN m", true},
                 {"largest strain, %", true},
                 {"smallest strain, %", true},
                 {"feed-in, m", true}});
  for_loaded_stages(run, [&](const std::string& stage, const auto& of) {
    std::vector<text::HtmlCell> row = {{text::html_text(stage)}};
    for (const auto& [name, scale] :
         {std::pair{"y", 1.}, {"z", 1e3}, {"P", 1e-3}, {"M", 1e-3}, {"strain_max", 100.}, {"strain_min", 100.}, {"feed_in", 1.}})
      row.push_back({text::table_number(scale * of(name)), true});
    table.row(row);
  });
  return table.empty() ? "" : table.html();
}

}  // namespace berm::line
