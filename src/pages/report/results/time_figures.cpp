// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/report_test.cpp
#include "report/results/results_section.hpp"

#include "plot/figure.hpp"

#include <fmt/format.h>

namespace berm::report {
namespace {

namespace fs = std::filesystem;

constexpr int width = 1000, height = 660;  // pixels

/// Columns of a run's history over time, those that it has.
struct TimeChart {
  const char *name, *title, *y_words, *y_unit;               ///< y_unit: nullptr for that of the columns
  std::vector<std::pair<const char*, const char*>> columns;  ///< of the history, by their labels, and their words
  Real per_si;
  const char* more;
};
const TimeChart time_charts[] = {
    {"energies",
     "Energies",
     "energy since the start",
     nullptr,
     {{"kinetic", "kinetic"},
      {"internal", "internal"},
      {"damping", "damping"},
      {"filter", "velocity filter"},
      {"friction", "friction"},
      {"external", "external work"},
      {"energy error", "error"}},
     1,
     "set key below\n"},
    {"contact", "Contact", "distance", "mm", {{"gap", "gap"}, {"overlap", "deepest overlap"}}, 1000, plot::from_zero}};

bool draw_time_chart(const record::RunRecord& run, const TimeChart& chart, const fs::path& folder)
{
  if (run.history.rows() < 2) return false;
  plot::Figure figure{fmt::format("{}: {}", run.name, chart.title), "time (s)", "", {}, chart.more, width, height};
  for (const auto& [column, words] : chart.columns) {
    const std::size_t number = figure.curves.size();
    if (!run.history.has_label(column) || !(plot::largest_size(run.history.by_label(column)) > 0)) continue;
    const std::string unit = chart.y_unit != nullptr ? chart.y_unit : run.history.column_by_label(column).unit;
    figure.y_label = fmt::format("{} ({})", chart.y_words, unit);
    figure.curves.push_back(
        {words, plot::curve_style(number, number), run.history["time_s"], plot::scaled(run.history.by_label(column), chart.per_si)});
  }
  return !figure.curves.empty() && draw_png_and_svg(folder, fmt::format("{}_{}", record::file_name_of(run.name), chart.name), figure);
}

}  // namespace

std::vector<std::string> draw_time_charts(const std::vector<record::RunRecord>& runs, const fs::path& folder)
{
  std::vector<std::string> names;
  for (const record::RunRecord& run : runs)
    for (const TimeChart& chart : time_charts)
      if (draw_time_chart(run, chart, folder)) names.push_back(fmt::format("{}_{}", record::file_name_of(run.name), chart.name));
  return names;
}

}  // namespace berm::report
