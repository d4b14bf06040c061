// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/study/study_sample_test.cpp
#include "os/text_of_list.hpp"
#include "study/study_report.hpp"

#include "io/atomic_file.hpp"
#include "plot/gnuplot.hpp"
#include "text/quantity_words.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::study {
namespace {

constexpr const char *low_color = "#1764ab", *high_color = "#c8452f", *sample_color = "#9a9a9a";

/// Bars as gnuplot draws boxes: x y left right bottom top.
class Bars {
public:
  void add(Real y, Real from, Real to)
  {
    constexpr Real half = 0.36;
    if (std::isfinite(from) && std::isfinite(to))
      text_ += fmt::format("{0:.9g} {1} {0:.9g} {2:.9g} {3:.9g} {4:.9g}\n", std::min(from, to), y, std::max(from, to), y - half, y + half);
  }
  /// Writes them to a file beside the script; the part of the plot command for them, "" without bars.
  std::string plot(const std::filesystem::path& plots, const std::string& file, const char* color, const std::string& title) const
  {
    if (text_.empty()) return "";
    io::write_atomically(plots / file, text_);
    return fmt::format("{} using 1:2:3:4:5:6 with boxxyerror fs solid 0.85 noborder lc rgb '{}' {}", plot::gnuplot_text("./" + file), color,
                       title.empty() ? "notitle" : "title " + plot::gnuplot_text(title));
  }

private:
  std::string text_;
};

std::string upright(Real x, const char* style)
{
  return std::isfinite(x) ? fmt::format("set arrow from first {0:.9g}, graph 0 to first {0:.9g}, graph 1 nohead front {1}\n", x, style)
                          : "";
}

/// gnuplot takes labels of tics for formats.
std::string as_format(const std::string& label)
{
  std::string text;
  for (const char c : label) text += c == '%' ? "%%" : std::string(1, c);
  return text;
}

std::string label_of(const StudyAxis& axis, const Swing& swing)
{
  const AxisParameter& parameter = axis.parameter[swing.parameter];
  if (*axis.sample_from == 0) return parameter.name;
  const auto words = [&](std::size_t place) { return parameter_words(axis.value[place].number[swing.parameter], parameter); };
  return fmt::format("{}: {} to {}", parameter.name, words(1 + 2 * swing.parameter), words(2 + 2 * swing.parameter));
}

}  // namespace

std::string parameter_words(Real value, const AxisParameter& parameter)
{
  if (parameter.unit == "Pa") return text::stress_words(value);
  if (parameter.unit == "rad") return text::angle_words(value);
  if (parameter.unit == "m") return text::length_words(value);
  return fmt::format("{:.4g}{}{}", value, parameter.unit.empty() ? "" : " ", parameter.unit);
}

bool draw_tornado(const std::filesystem::path& folder, const std::string& name, const StudyPlan& plan, const Estimate& estimate)
{
  const StudyAxis& axis = *sample_of(plan.study);
  const StudyMeasure& measure = plan.study.measure[estimate.measure];
  const bool of_swings = std::isfinite(estimate.best);
  Bars low, high, sample;
  std::string tics;
  const auto add_tic = [&](Real at, const std::string& label) {
    tics += fmt::format("{}{} {}", tics.empty() ? "" : ", ", plot::gnuplot_text(as_format(label)), at);
  };
  Real y = static_cast<Real>(estimate.swing.size());
  for (const Swing& swing : estimate.swing) {
    add_tic(y, label_of(axis, swing));
    low.add(y, of_swings ? estimate.best : 0, of_swings ? swing.low : std::min<Real>(0, swing.correlation));
    high.add(y, of_swings ? estimate.best : 0, of_swings ? swing.high : std::max<Real>(0, swing.correlation));
    y -= 1;
  }
  if (of_swings && std::isfinite(estimate.low) && std::isfinite(estimate.high)) {
    sample.add(y, estimate.low, estimate.high);
    add_tic(y, fmt::format("all, 5 to 95 % of {} runs", estimate.numbers));
  }
  const std::filesystem::path plots = io::make_inner_folder(folder, "plots");
  std::string commands;
  for (const std::string& part : {low.plot(plots, name + "_low.dat", low_color, of_swings ? "at its 5 % value" : ""),
                                  high.plot(plots, name + "_high.dat", high_color, of_swings ? "at its 95 % value" : ""),
                                  sample.plot(plots, name + "_sample.dat", sample_color, "")})
    if (!part.empty()) commands += (commands.empty() ? "plot " : ", \\\n     ") + part;
  if (commands.empty()) return false;
  const std::string unit = measure.unit.empty() ? "" : fmt::format(" ({})", measure.unit);
  const bool alone = plan.study.cases.size() == 1 && estimate.names.size() == 1;
  const std::string script =
      fmt::format("set title {} font 'DejaVu Sans,14'\nset xlabel {}\nset ytics ({}) scale 0\nset yrange [{}:{}]\n",
                  plot::gnuplot_text(alone ? measure.name : fmt::format("{}: {}", measure.name, text_of_list(estimate.names, ", "))),
                  plot::gnuplot_text(of_swings ? measure.name + unit : "rank correlation with " + measure.name), tics, y - 0.6,
                  static_cast<Real>(estimate.swing.size()) + 0.6) +
      (of_swings ? upright(estimate.best, "lw 2 lc rgb '#222222'") : std::string("set xrange [-1:1]\n")) +
      "set format x '%g'\nset grid x lc rgb '#dddddd' lt 1\nset border lc rgb '#444444'\nset tics nomirror textcolor rgb '#222222'\n"
      "set key above\n" +
      commands + "\n";
  return plot::draw(folder, name, 1000, 150 + 46 * static_cast<int>(estimate.swing.size() + 1), script);
}

}  // namespace berm::study
