// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/study/study_test.cpp
#include "study/study_report.hpp"

#include "input/units.hpp"
#include "io/atomic_file.hpp"
#include "io/log.hpp"
#include "os/error.hpp"
#include "os/text_of_list.hpp"
#include "plot/figure.hpp"
#include "plot/gnuplot.hpp"
#include "record/travel_curve.hpp"
#include "run_folder/csv_line.hpp"
#include "structures/base/driven_body.hpp"
#include "study/study_rows.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::study {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

const char* state_of(const StudyRow& row)
{
  constexpr const char* words[] = {"finished", "failed", "not run", "queued"};
  return words[static_cast<int>(row.end.kind)];
}

Words headings(const Study& study)
{
  Words words = {"case"};
  for (const StudyAxis& axis : study.axis) words.push_back(axis.name);
  for (const StudyMeasure& measure : study.measure)
    words.push_back(measure.unit.empty() ? measure.name : fmt::format("{} ({})", measure.name, measure.unit));
  return words;
}

std::string csv(const StudyPlan& plan)
{
  Words words = headings(plan.study);
  words.push_back("run");
  std::string text = csv_line(words);
  for (const StudyRow& row : plan.rows) {
    words = row.names;
    for (const Real number : row.numbers) words.push_back(std::isnan(number) ? "" : fmt::format("{}", number));
    words.push_back(row.end.reason.empty() ? state_of(row) : "failed: " + row.end.reason);
    text += csv_line(words);
  }
  return text;
}

std::string file_of(const StudyFigure& figure)
{
  return as_file_name(figure.name);
}

std::string markdown(const StudyPlan& plan, const std::string& of_sample, const std::vector<std::string>& pictures)
{
  const Study& study = plan.study;
  std::string text = fmt::format("# {}\n\n", study.title.empty() ? "A study" : study.title);
  const Words head = headings(study);
  text += of_sample + markdown_line(head) + markdown_rule(head.size(), 1 + study.axis.size());
  std::string failed, skipped;
  constexpr std::size_t max = 240;
  for (const StudyRow& row : plan.rows) {
    Words cells = row.names;
    for (const Real number : row.numbers) cells.push_back(std::isnan(number) ? "" : fmt::format("{:.4g}", number));
    if (row.end.kind != jobs::JobEnd::Kind::finished) cells[row.names.size()] = state_of(row);
    text += markdown_line(cells);
    if (const std::string& reason = row.end.reason; !reason.empty())
      failed += fmt::format("- {}: {}{}\n", text_of_list(row.names, ", "), reason.substr(0, max), reason.size() > max ? " ..." : "");
  }
  for (const SkippedRow& row : plan.skipped) skipped += fmt::format("- {}: {}\n", text_of_list(row.names, ", "), row.why);
  if (!failed.empty()) text += "\nFailed:\n\n" + failed;
  if (!skipped.empty()) text += "\nLeft out:\n\n" + skipped;
  for (const std::string& picture : pictures) text += fmt::format("\n![{0}]({0}.png)\n", picture);
  return text + fmt::format("\nberm {}; all digits are in results.csv, each run in its folder under runs.\n", BERM_VERSION);
}

/// Numbers of the rows of some stages.
std::vector<Real> of_stages(const run_folder::History& history, const std::string& column, const std::vector<std::string>& stages)
{
  std::vector<Real> values;
  for (Index k = 0; k < history.rows(); ++k)
    if (stages.empty() || std::find(stages.begin(), stages.end(), history.stage[k]) != stages.end()) values.push_back(history[column][k]);
  return values;
}

/// y freed from noise over x +- half. A travel that goes down is followed as one that goes up.
void smooth(plot::FigureCurve& curve, Real half)
{
  if (!(half > 0) || curve.x.size() < 2) return;
  const Real direction = curve.x.back() < curve.x.front() ? -1 : 1;
  std::vector<Real> travel = curve.x;
  for (Real& x : travel) x *= direction;
  const record::TravelCurve line(travel, curve.y);
  curve.x.clear();
  curve.y.clear();
  for (const Real s : line.travel()) {
    curve.x.push_back(direction * s);
    curve.y.push_back(line.at(s, half));
  }
}

/// How the curve of a row is drawn, and what the key says of it.
struct RowLook {
  std::string style, title;
  bool thin = false;  ///< below the others
};

/// The values of an axis that occur, in their order; axis 0 is that of the cases.
std::vector<std::size_t> values_of(const std::vector<const StudyRow*>& rows, std::size_t axis)
{
  std::vector<std::size_t> values;
  for (const StudyRow* row : rows)
    if (std::find(values.begin(), values.end(), row->choice[axis]) == values.end()) values.push_back(row->choice[axis]);
  return values;
}

std::size_t place_of(std::size_t value, const std::vector<std::size_t>& values)
{
  return static_cast<std::size_t>(std::find(values.begin(), values.end(), value) - values.begin());
}

/// Of few curves: colours tell the values of what varies most, dashes all others; with too many for that each gets its own.
std::vector<RowLook> looks_of_few(const std::vector<const StudyRow*>& rows)
{
  std::vector<std::vector<std::size_t>> values;
  for (std::size_t k = 0; k < rows[0]->choice.size(); ++k) values.push_back(values_of(rows, k));
  std::size_t colored = 0, dashes = 1;
  for (std::size_t k = 0; k < values.size(); ++k)
    if (values[k].size() > values[colored].size()) colored = k;
  for (std::size_t k = 0; k < values.size(); ++k) dashes *= k == colored ? 1 : values[k].size();
  const bool fits = dashes <= plot::curve_dashes && values[colored].size() <= plot::curve_colors;
  std::vector<RowLook> looks;
  for (const StudyRow* row : rows) {
    std::size_t dash = 0;
    for (std::size_t k = 0; k < values.size(); ++k)
      if (k != colored) dash = dash * values[k].size() + place_of(row->choice[k], values[k]);
    const std::size_t own = looks.size();
    looks.push_back({fits ? plot::curve_style(place_of(row->choice[colored], values[colored]), dash)
                          : plot::curve_style(own % plot::curve_colors, own / plot::curve_colors),
                     ""});
  }
  return looks;
}

/// Of many: one colour for each value of the first that varies, its first row thick and all others of it thin.
std::vector<RowLook> looks_of_many(const std::vector<const StudyRow*>& rows)
{
  std::size_t grouped = 0;
  while (grouped + 1 < rows[0]->choice.size() && values_of(rows, grouped).size() < 2) ++grouped;
  const std::vector<std::size_t> values = values_of(rows, grouped);
  std::vector<RowLook> looks;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const auto same = [&](const StudyRow* other) { return other->choice[grouped] == rows[r]->choice[grouped]; };
    const std::size_t color = place_of(rows[r]->choice[grouped], values);
    const bool thin = std::any_of(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(r), same);
    const auto others = std::count_if(rows.begin(), rows.end(), same) - 1;
    Words rest;
    for (std::size_t k = 0; k < rows[r]->names.size(); ++k)
      if (k != grouped && values_of(rows, k).size() > 1) rest.push_back(rows[r]->names[k]);
    std::string title = rows[r]->names[grouped];
    if (!rest.empty()) title += fmt::format(": {}", text_of_list(rest, ", "));
    if (others > 0) title += fmt::format(" (thin: {} more)", others);
    looks.push_back({plot::curve_style(color % plot::curve_colors, color / plot::curve_colors, thin ? 0.7 : 2.8), thin ? "" : title, thin});
  }
  return looks;
}

std::string curve_name(const StudyPlan& plan, const StudyRow& row, bool one_case)
{
  const bool names_case = !one_case && plan.study.cases.size() > 1;
  const Words names(row.names.begin() + (names_case || row.names.size() == 1 ? 0 : 1), row.names.end());
  return text_of_list(names, ", ");
}

/// What scales a column for the plot, and its unit.
plot::PlotUnit unit_for(const std::string& unit, const std::vector<plot::FigureCurve>& curves, std::vector<Real> plot::FigureCurve::*values)
{
  Real max = 0;
  for (const plot::FigureCurve& curve : curves)
    for (const Real value : curve.*values) max = std::isfinite(value) ? std::max(max, std::abs(value)) : max;
  if (unit == "m") return plot::length_unit(max);
  if (unit == "N/m" || unit == "N") return plot::force_unit(max, unit == "N" ? 3 : 2);
  return {1, ""};
}

bool draw_study_figure(const StudyPlan& plan, const StudyFigure& wanted, const fs::path& output)
{
  plot::Figure figure;
  figure.title = wanted.case_name.empty() ? wanted.name : fmt::format("{}: {}", wanted.case_name, wanted.name);
  const bool one_case = !wanted.case_name.empty();
  run_folder::Column x_column, y_column;
  std::vector<const StudyRow*> rows;
  for (const StudyRow& row : plan.rows)
    if (row.end.kind == jobs::JobEnd::Kind::finished && (!one_case || row.names[0] == wanted.case_name)) rows.push_back(&row);
  if (rows.empty()) return false;
  constexpr std::size_t few = 8;
  std::vector<RowLook> looks = rows.size() <= few ? looks_of_few(rows) : looks_of_many(rows);
  std::vector<plot::FigureCurve> thin;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const StudyRow& row = *rows[k];
    const run_folder::History history = run_folder::read_history(row.job.folder / "history.csv");
    if (!history.has(wanted.x) || !history.has(wanted.y)) {
      io::warn("{}: figure \"{}\": the history has not both of {} and {}", text_of_list(row.names, ", "), wanted.name, wanted.x, wanted.y);
      continue;
    }
    x_column = history.column(wanted.x);
    y_column = history.column(wanted.y);
    if (!wanted.smooth_unit.empty() && !input::same_dimension(wanted.smooth_unit, x_column.unit))
      throw InputError(
          fmt::format("figure \"{}\": smooth is in {}, but {} in {}", wanted.name, wanted.smooth_unit, wanted.x, x_column.unit));
    plot::FigureCurve curve{rows.size() <= few ? curve_name(plan, row, one_case) : looks[k].title, looks[k].style,
                            of_stages(history, wanted.x, wanted.stage), of_stages(history, wanted.y, wanted.stage)};
    smooth(curve, wanted.smooth                              ? *wanted.smooth
                  : x_column.unit == run_folder::metres.name ? base::averaging_half_width * row.diameter
                                                             : 0);
    (looks[k].thin ? thin : figure.curves).push_back(curve);
  }
  figure.curves.insert(figure.curves.begin(), thin.begin(), thin.end());
  const plot::PlotUnit x = unit_for(x_column.unit, figure.curves, &plot::FigureCurve::x),
                       y = unit_for(y_column.unit, figure.curves, &plot::FigureCurve::y);
  for (plot::FigureCurve& curve : figure.curves) {
    for (Real& value : curve.x) value *= x.per_si;
    for (Real& value : curve.y) value *= y.per_si;
  }
  const auto label = [](const run_folder::Column& column, const plot::PlotUnit& shown) {
    const std::string words = *shown.name != '\0' ? shown.name : column.unit == run_folder::bare.name ? "" : column.unit;
    return words.empty() ? column.label : fmt::format("{} ({})", column.label, words);
  };
  figure.x_label = label(x_column, x);
  figure.y_label = label(y_column, y);
  figure.height = std::clamp(static_cast<int>(figure.curves.size() - thin.size()) * 26 + 120, 560, 1400);
  figure.width = 1150;
  return draw_figure(output, file_of(wanted), figure);
}

}  // namespace

void write_study_report(const StudyPlan& plan, const fs::path& output)
{
  io::make_folder(output);
  io::write_atomically(output / "results.csv", csv(plan));
  write_rows(plan, output);
  std::vector<std::string> pictures;
  for (const StudyFigure& figure : plan.study.figure)
    if (draw_study_figure(plan, figure, output)) pictures.push_back(file_of(figure));
  io::write_atomically(output / "results.md", markdown(plan, write_sample_report(plan, output), pictures));
}

std::string csv_line(const std::vector<std::string>& fields)
{
  std::string line;
  for (const std::string& field : fields) {
    line += run_folder::csv_field(field);
    line += ',';
  }
  line.back() = '\n';
  return line;
}

std::string markdown_line(const std::vector<std::string>& cells)
{
  std::string line = "|";
  for (const std::string& cell : cells) {
    line += ' ';
    for (const char c : cell) line += c == '|' ? std::string("\\|") : std::string(1, c);
    line += " |";
  }
  return line + '\n';
}

std::string markdown_rule(std::size_t columns, std::size_t columns_of_text)
{
  std::string line = "|";
  for (std::size_t k = 0; k < columns; ++k) line += k < columns_of_text ? "---|" : "---:|";
  return line + '\n';
}

}  // namespace berm::study
