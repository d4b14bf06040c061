// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/study/study_sample_test.cpp
#include "os/text_of_list.hpp"
#include "study/study_report.hpp"

#include "io/atomic_file.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::study {
namespace {

using Words = std::vector<std::string>;

/// "case" and the names of the axes that are no sample.
Words other_axes(const Study& study)
{
  Words words = {"case"};
  for (const StudyAxis& axis : study.axis)
    if (!axis.sample_from) words.push_back(axis.name);
  return words;
}

std::string exact(Real value)
{
  return std::isnan(value) ? "" : fmt::format("{}", value);
}

std::string rounded(Real value)
{
  return std::isnan(value) ? "" : fmt::format("{:.4g}", value);
}

/// The names of an estimate and its measure, which begin each line.
Words begin_of(const Study& study, const Estimate& estimate)
{
  Words words = estimate.names;
  const StudyMeasure& measure = study.measure[estimate.measure];
  words.push_back(measure.unit.empty() ? measure.name : fmt::format("{} ({})", measure.name, measure.unit));
  return words;
}

Words joined(Words words, const Words& more)
{
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// Headings and lines of a table, as text; numbers are written by `number`.
using WriteNumber = std::string (*)(Real);

std::vector<Words> estimate_lines(const Study& study, const std::vector<Estimate>& estimates, WriteNumber number)
{
  std::vector<Words> lines = {joined(other_axes(study), {"measure", "best", "5 %", "50 %", "95 %", "mean", "numbers", "failed runs"})};
  for (const Estimate& e : estimates)
    lines.push_back(joined(begin_of(study, e), {number(e.best), number(e.low), number(e.middle), number(e.high), number(e.mean),
                                                fmt::format("{}", e.numbers), fmt::format("{}", e.failed)}));
  return lines;
}

/// Mean, scatter, the lognormal distribution and the probability of the limit.
std::vector<Words> spread_lines(const Study& study, const std::vector<Estimate>& estimates, WriteNumber number)
{
  const bool limits = std::any_of(study.measure.begin(), study.measure.end(), [](const StudyMeasure& m) { return m.limit.has_value(); });
  Words heads = {"measure",
                 "mean",
                 "standard error of the mean",
                 "standard deviation",
                 "coefficient of variation",
                 "lognormal median",
                 "lognormal deviation of ln"};
  if (limits) heads = joined(heads, {"limit", "probability below", "above", "standard error", "below by lognormal"});
  std::vector<Words> lines = {joined(other_axes(study), heads)};
  for (const Estimate& e : estimates) {
    const Spread& s = e.spread;
    Words line =
        joined(begin_of(study, e), {number(e.mean), number(s.deviation / std::sqrt(static_cast<Real>(e.numbers))), number(s.deviation),
                                    number(s.deviation / std::abs(e.mean)), number(std::exp(s.log_mean)), number(s.log_deviation)});
    if (limits)
      line = joined(line, {number(study.measure[e.measure].limit.value_or(nan)), number(s.below), number(1 - s.below),
                           number(s.below_error), number(s.below_by_lognormal)});
    lines.push_back(line);
  }
  return lines;
}

/// `in_words`: the parameter's own values in the unit that suits, else in SI.
std::vector<Words> sensitivity_lines(const Study& study, const std::vector<Estimate>& estimates, WriteNumber number, bool in_words)
{
  const StudyAxis& axis = *sample_of(study);
  std::vector<Words> lines = {joined(other_axes(study), {"measure", "parameter", "its 5 % value", "its 95 % value", "measure at 5 %",
                                                         "at 95 %", "swing", "rank correlation"})};
  for (const Estimate& e : estimates)
    for (const Swing& swing : e.swing) {
      const AxisParameter& parameter = axis.parameter[swing.parameter];
      const bool unit = !in_words && !parameter.unit.empty();
      Words line = joined(begin_of(study, e), {unit ? fmt::format("{} ({})", parameter.name, parameter.unit) : parameter.name});
      for (const std::size_t place : {1 + 2 * swing.parameter, 2 + 2 * swing.parameter}) {
        const Real value = *axis.sample_from > 0 ? axis.value[place].number[swing.parameter] : nan;
        line.push_back(std::isnan(value) ? "" : in_words ? parameter_words(value, parameter) : number(value));
      }
      const std::string correlation =
          !in_words || std::isnan(swing.correlation) ? number(swing.correlation) : fmt::format("{:.2f}", swing.correlation);
      lines.push_back(joined(line, {number(swing.low), number(swing.high), number(swing.width()), correlation}));
    }
  return lines;
}

std::string csv_of(const std::vector<Words>& lines)
{
  std::string text;
  for (const Words& line : lines) text += csv_line(line);
  return text;
}

/// `texts`: columns at the left that hold text.
std::string markdown_of(const std::vector<Words>& lines, std::size_t texts)
{
  std::string text = markdown_line(lines[0]) + markdown_rule(lines[0].size(), texts);
  for (std::size_t k = 1; k < lines.size(); ++k) text += markdown_line(lines[k]);
  return text + '\n';
}

/// The name of the picture of an estimate, as a file.
std::string picture_name(const StudyPlan& plan, const Estimate& estimate)
{
  Words parts = {"tornado", as_file_name(plan.study.measure[estimate.measure].name)};
  const bool alone = plan.study.cases.size() == 1 && estimate.names.size() == 1;
  if (!alone)
    for (const std::string& each : estimate.names) parts.push_back(as_file_name(each));
  return text_of_list(parts, ".");
}

}  // namespace

std::string write_sample_report(const StudyPlan& plan, const std::filesystem::path& output)
{
  const Study& study = plan.study;
  const StudyAxis* axis = sample_of(study);
  if (axis == nullptr) return "";
  const std::vector<Estimate> estimates = estimates_of(plan);
  io::write_atomically(output / "estimates.csv", csv_of(estimate_lines(study, estimates, exact)));
  io::write_atomically(output / "distribution.csv", csv_of(spread_lines(study, estimates, exact)));
  if (!axis->parameter.empty()) io::write_atomically(output / "sensitivity.csv", csv_of(sensitivity_lines(study, estimates, exact, false)));
  const std::size_t texts = other_axes(study).size() + 1;
  const bool drawn = *axis->sample_from > 0;
  std::string text = "## Low, best and high\n\n";
  text += markdown_of(estimate_lines(study, estimates, rounded), texts);
  text += fmt::format(
      "5, 50 and 95 % of a sample of {} rows: the k-th of n numbers in order stands for (k - 1/2) / n, and between two it is linear.{}\n",
      axis->value.size() - *axis->sample_from,
      fmt::format("{}{}", drawn ? " best: the run with all parameters at their medians." : "",
                  study.sample ? " The sample is samples.csv." : ""));
  if (std::any_of(estimates.begin(), estimates.end(), [](const Estimate& e) { return e.failed > 0; }))
    text += "Failed runs are not included: where they are at one end of the sample, that end is missing.\n";
  Words pictures;
  for (const Estimate& estimate : estimates) {
    std::string name = picture_name(plan, estimate);
    while (std::find(pictures.begin(), pictures.end(), name) != pictures.end()) name += "_";  // "a b" and "a_b" are one name of a file
    if (draw_tornado(output, name, plan, estimate)) pictures.push_back(name);
  }
  for (const std::string& picture : pictures) text += fmt::format("\n![{0}]({0}.png)\n", picture);
  text += "\n## Distribution\n\n" + markdown_of(spread_lines(study, estimates, rounded), texts);
  text += "Of the same numbers. Lognormal: median and standard deviation of ln. Standard error of a probability: sqrt(p (1 - p)/n), p = (k "
          "+ 1)/(n + 2) of k "
          "numbers below the limit.\n";
  if (!axis->parameter.empty()) {
    text += "\n## Effect of each parameter\n\n";
    text += markdown_of(sensitivity_lines(study, estimates, rounded, true), texts + 1);
    if (drawn) text += "Swing: one parameter at its 5 % and 95 % value, all others at their medians. ";
    text += "Rank correlation: over the sample, from -1 to 1 (Spearman).\n";
  }
  return text + "\n## All runs\n\n";
}

}  // namespace berm::study
