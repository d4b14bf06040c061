// SPDX-License-Identifier: BSD-3-Clause
#include "structures/penetration/depth_log.hpp"

#include "plot/figure.hpp"
#include "plot/gnuplot.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::penetration {
namespace {

constexpr Real beginning = 0.1;       // of the way: what is averaged over little of it does not set the axis
constexpr Real margin = 1.05;         // of the axis beyond the largest mean
constexpr Real begins_deep = 1. / 3;  // of the deepest point
constexpr Real same_width = 1e-9;

using plot::Panel, record::TravelCurve;

plot::PlotUnit stress_unit(Real max)
{
  return max < 1e3 ? plot::PlotUnit{1, "Pa"} : max < 2e6 ? plot::PlotUnit{1e-3, "kPa"} : plot::PlotUnit{1e-6, "MPa"};
}

/// The largest of a mean beyond the beginning of its way.
Real largest_of(const TravelCurve& mean)
{
  Real max = 0;
  for (std::size_t k = 0; k < mean.travel().size(); ++k)
    if (mean.travel()[k] >= mean.begin() + beginning * (mean.end() - mean.begin())) max = std::max(max, mean.value()[k]);
  return max;
}

void add_run(Panel& panel, const PenetrationRun& run, const TravelCurve& rows, Real value_unit, Real depth_unit, const std::string& name)
{
  using plot::scaled;
  if (rows.empty()) return;
  const TravelCurve mean = rows.drawn(run.half());
  if (run.half() > 0)
    panel.curves.push_back({"", plot::thin_style(run.number), scaled(rows.value(), value_unit), scaled(rows.travel(), depth_unit)});
  panel.curves.push_back({name, plot::thick_style(run.number), scaled(mean.value(), value_unit), scaled(mean.travel(), depth_unit)});
  panel.right = std::max(panel.right, largest_of(mean) * value_unit);
}

/// A number of the soil from the surface to the deepest point of a log.
void add_of_soil(Panel& panel, const PenetrationRun& run, Real SoilAt::*member, Real value_unit, Real depth_unit, const std::string& name)
{
  constexpr int points = 60;
  plot::PanelCurve curve{name, plot::published_style(), {}, {}, true};
  for (int k = 0; k <= points; ++k) {
    const Real from = std::min(run.z().front(), Real(0)), z = from + (run.z_end() - from) * k / points;
    curve.y.push_back(z * depth_unit);
    curve.x.push_back(run.soil.at(z).*member * value_unit);
    if (std::isfinite(curve.x.back())) panel.right = std::max(panel.right, curve.x.back());
  }
  panel.curves.push_back(std::move(curve));
}

Panel resistance_panel(const PenetrationRuns& runs, const plot::PlotUnit& depth)
{
  Real max = 0;
  for (const PenetrationRun& run : runs)
    if (!run.q_curve().empty()) max = std::max(max, largest_of(run.q_curve().smoothed(run.half())));
  const plot::PlotUnit unit = stress_unit(max);
  Panel panel{.title = fmt::format("{} ({})", runs.front().how.resistance.plain, unit.name)};
  for (const PenetrationRun& run : runs) add_run(panel, run, run.q_curve(), unit.per_si, depth.per_si, run.record.name);
  const auto deep = std::find_if(runs.begin(), runs.end(), [](const PenetrationRun& run) { return !run.z().empty(); });
  if (deep != runs.end() && !deep->how.flows_around && deep->soil.at(deep->z_end()).overburden > 0)
    add_of_soil(panel, *deep, &SoilAt::overburden, unit.per_si, depth.per_si, "σ_v0");
  return panel;
}

Panel factor_panel(const PenetrationRuns& runs, const plot::PlotUnit& depth, Real low, Real high)
{
  Panel panel;
  const Symbol* symbol = nullptr;
  for (const PenetrationRun& run : runs) {
    if (run.symbol() == nullptr || (symbol != nullptr && symbol != run.symbol())) continue;
    symbol = run.symbol();
    panel.title = symbol->plain;
    add_run(panel, run, run.factor_curve(), 1, depth.per_si, "");
  }
  if (symbol == nullptr) return panel;
  const auto first = std::find_if(runs.begin(), runs.end(), [](const PenetrationRun& run) { return run.symbol() != nullptr; });
  for (const Comparison& c : first->how.published(*first)) {
    if (!c.level || c.published.source.label == formulas::Label::recalled || !std::isfinite(c.published.value)) continue;
    panel.curves.push_back({fmt::format("{:.4g}, {}", c.published.value, c.published.source.work),
                            plot::published_style(),
                            {c.published.value, c.published.value},
                            {low, high},
                            true});
    panel.right = std::max(panel.right, c.published.value);
  }
  return panel;
}

/// Mean friction of the shaft; no curves where no run has one that counts.
Panel friction_panel(const PenetrationRuns& runs, const plot::PlotUnit& depth)
{
  constexpr Real counts = 1e-3;  // of q
  Real max = 0, q = 0;
  for (const PenetrationRun& run : runs) {
    if (run.friction_curve().empty()) continue;
    max = std::max(max, largest_of(run.friction_curve().smoothed(run.half())));
    q = std::max(q, largest_of(run.q_curve().smoothed(run.half())));
  }
  const plot::PlotUnit unit = stress_unit(max);
  Panel panel{.title = fmt::format("f ({})", unit.name)};
  if (!(max > counts * q)) return panel;
  for (const PenetrationRun& run : runs) add_run(panel, run, run.friction_curve(), unit.per_si, depth.per_si, "");
  return panel;
}

}  // namespace

plot::Panels depth_log(const PenetrationRuns& runs, const std::string& title)
{
  plot::Panels log{.title = title, .css_class = "depth_log", .downwards = true, .width = 270, .height = 440, .second_label = "z/D"};
  Real shallowest = infinity, deepest = -infinity, width = 0;
  bool one_width = true;
  for (const PenetrationRun& run : runs) {
    if (run.z().empty() || !std::isfinite(run.area())) continue;
    deepest = std::max(deepest, run.z_end()), shallowest = std::min(shallowest, run.z().front());
    one_width = one_width && (width == 0 || std::abs(run.body.width - width) < same_width * width);
    width = run.body.width;
  }
  if (!(deepest > shallowest)) return log;
  if (shallowest > 0 && shallowest < begins_deep * deepest) shallowest = 0;
  const plot::PlotUnit depth = plot::length_unit(std::max(deepest, -shallowest));
  log.y_label = fmt::format("depth z of the {} ({})", runs.front().how.level, depth.name);
  log.second = one_width ? width * depth.per_si : 0;
  const Real low = shallowest * depth.per_si, high = deepest * depth.per_si;
  log.panels = {resistance_panel(runs, depth), friction_panel(runs, depth), factor_panel(runs, depth, low, high)};
  const auto varied = std::find_if(runs.begin(), runs.end(), [](const PenetrationRun& run) {
    return !run.z().empty() && run.measure() == Measure::strength && run.soil.varies();
  });
  if (varied != runs.end()) {
    const plot::PlotUnit unit = stress_unit(varied->soil.at(varied->z_end()).strength);
    Panel panel{.title = fmt::format("s_u ({})", unit.name)};
    add_of_soil(panel, *varied, &SoilAt::strength, unit.per_si, depth.per_si, "");
    log.panels.push_back(std::move(panel));
  }
  std::erase_if(log.panels, [](const Panel& panel) { return !(panel.right > 0); });
  for (Panel& panel : log.panels) panel.right = plot::round_up(margin * panel.right), panel.low = low, panel.high = high;
  return log;
}

}  // namespace berm::penetration
