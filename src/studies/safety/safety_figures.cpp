// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/safety/find_safety_test.cpp
#include "safety/safety_report.hpp"

#include "os/error.hpp"
#include "plot/figure.hpp"
#include "run_folder/history.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::safety {
namespace {

constexpr const char* of_end[] = {"points pt 7 ps 1.6 lc rgb '#1764ab'", "points pt 5 ps 1.6 lc rgb '#c8452f'",
                                  "points pt 8 ps 1.8 lc rgb '#777777'"};
constexpr const char* of_all = "lines lw 1.5 lc rgb '#999999'";
constexpr const char* of_limit = "lines lw 1.5 lc rgb '#c8452f' dt '-'";
constexpr const char* logarithmic = "set key below\nset logscale y\nset format y '%g'\n";

bool has_movement(const Trial& trial)
{
  return trial.movement > 0;
}

bool draw_over_factor(const std::vector<Trial>& trials, const std::filesystem::path& folder, const std::string& title, Real limit,
                      const plot::PlotUnit& unit)
{
  plot::Figure figure;
  figure.title = title;
  figure.x_label = "factor F that the strength is divided by";
  figure.y_label = fmt::format("largest displacement of the soil ({})", unit.name);
  figure.more = logarithmic;
  plot::FigureCurve all{"", of_all, {}, {}};
  for (const Trial& trial : trials) {
    if (!has_movement(trial)) continue;
    all.x.push_back(trial.factor);
    all.y.push_back(trial.movement * unit.per_si);
  }
  if (all.x.empty()) return false;
  figure.curves.push_back(all);
  for (const TrialEnd end : {TrialEnd::stands, TrialEnd::fails, TrialEnd::undecided}) {
    plot::FigureCurve points{word_of(end), of_end[static_cast<std::size_t>(end)], {}, {}};
    for (const Trial& trial : trials) {
      if (trial.end != end || !has_movement(trial)) continue;
      points.x.push_back(trial.factor);
      points.y.push_back(trial.movement * unit.per_si);
    }
    if (!points.x.empty()) figure.curves.push_back(points);
  }
  if (limit > 0)
    figure.curves.push_back({"has failed", of_limit, {all.x.front(), all.x.back()}, {limit * unit.per_si, limit * unit.per_si}});
  figure.height = 560;
  return draw_figure(folder, "movement", figure);
}

/// The trials at the ends of the bracket, and the next on either side.
std::vector<Trial> beside_the_answer(const std::vector<Trial>& trials)
{
  const Bracket bracket = bracket_of(trials);
  const Real factor = bracket.stands ? *bracket.stands : bracket.fails.value_or(1);
  const auto at = std::find_if(trials.begin(), trials.end(), [&](const Trial& t) { return t.factor == factor; });
  const std::ptrdiff_t here = at - trials.begin(), count = static_cast<std::ptrdiff_t>(trials.size());
  return {trials.begin() + std::max<std::ptrdiff_t>(0, here - 1), trials.begin() + std::min(count, here + 3)};
}

bool draw_over_time(const std::vector<Trial>& trials, const std::filesystem::path& folder, const std::string& title, Real limit,
                    const plot::PlotUnit& unit)
{
  plot::Figure figure;
  figure.title = title;
  figure.x_label = "time of the run (s)";
  figure.y_label = fmt::format("largest displacement of the soil ({})", unit.name);
  figure.more = "set key below\n";
  Real last = 0;
  std::size_t color = 0;
  for (const Trial& trial : beside_the_answer(trials)) {
    try {
      const run_folder::History history = run_folder::read_history(folder / "runs" / trial_name(trial.factor) / "history.csv");
      if (!history.has("movement_m") || history.rows() == 0) continue;
      last = std::max(last, history["time_s"].back());
      figure.curves.push_back({fmt::format("F = {:.4f}, {}", trial.factor, word_of(trial.end)), plot::curve_style(color++, 0),
                               history["time_s"], plot::scaled(history["movement_m"], unit.per_si)});
    } catch (const RunError&) {  // of a run that failed before its first row
    }
  }
  if (figure.curves.empty()) return false;
  if (limit > 0) figure.curves.push_back({"has failed", of_limit, {0, last}, {limit * unit.per_si, limit * unit.per_si}});
  return draw_figure(folder, "movement_in_time", figure);
}

}  // namespace

std::vector<std::string> draw_safety(const std::vector<Trial>& trials, const std::filesystem::path& folder, const std::string& title)
{
  Real limit = 0, largest = 0;
  for (const Trial& trial : trials) {
    limit = std::fmax(limit, trial.limit);
    largest = std::fmax(largest, trial.movement);
  }
  const plot::PlotUnit unit = plot::length_unit(largest);
  std::vector<std::string> drawn;
  if (draw_over_factor(trials, folder, title, limit, unit)) drawn.emplace_back("movement");
  if (draw_over_time(trials, folder, title, limit, unit)) drawn.emplace_back("movement_in_time");
  return drawn;
}

}  // namespace berm::safety
