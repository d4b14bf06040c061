// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/lateral/p_y_test.cpp
#include "structures/lateral/p_y.hpp"

#include "plot/figure.hpp"
#include "text/html.hpp"
#include "text/quantity_words.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::lateral {
namespace {

constexpr int points = 20;             // of a curve, but for its start
constexpr std::size_t max_curves = 8;  // of a picture

int slices_of(const LateralRun& run)
{
  return run.record.settings.rigid[main_rigid(run.record.settings)].second.depth_slices;
}

/// A slice of the shaft by row of the path: displacement of its axis at its middle along the load (m), resistance per metre (N/m).
struct SliceRows {
  Real z;  ///< m below the seabed
  std::vector<Real> y, p;
};

/// Those from the bed down; none without slices, or where the load goes across the direction in which H counts.
std::vector<SliceRows> slice_rows(const LateralRun& run)
{
  std::vector<SliceRows> slices;
  if (run.empty() || run.H_curve().empty() || run.path.direction == 0) return slices;
  const run_folder::History& history = run.record.history;
  const int count = slices_of(run);
  const Real thickness = history["w_m"].front() / count;
  for (int k = 0; k < count; ++k) {
    const std::string column = fmt::format("H{}_N", k + 1);
    if (!history.has(column)) return {};
    SliceRows slice{(k + 0.5) * thickness, {}, {}};
    for (std::size_t row = 0; row < run.path.rows.size(); ++row) {
      slice.y.push_back(run.path.u[row] - slice.z * std::sin(run.path.tilt[row]));
      slice.p.push_back(run.path.direction * history[column][run.path.rows[row]] / thickness);
    }
    slices.push_back(std::move(slice));
  }
  return slices;
}

/// Every so many of them are in a picture.
std::size_t step_of(std::size_t count)
{
  return std::max<std::size_t>(1, (count + max_curves - 1) / max_curves);
}

}  // namespace

std::vector<PyCurve> py_curves(const LateralRun& run)
{
  std::vector<PyCurve> curves;
  for (const SliceRows& slice : slice_rows(run)) {
    PyCurve curve{slice.z, {}, {}, {}};
    const record::TravelCurve y_curve(run.path.u, slice.y), p_curve(run.path.u, slice.p);
    for (int n = 0; n <= points; ++n) {
      const Real u = std::lerp(p_curve.begin(), run.H_curve().end(), Real(n) / points);
      const Real half = std::min(run.half(), u - p_curve.begin());  // the first point is that of the start
      curve.u.push_back(u), curve.y.push_back(y_curve.at(u, half)), curve.p.push_back(p_curve.at(u, half));
    }
    curves.push_back(std::move(curve));
  }
  return curves;
}

base::Chart py_chart(const LateralRun& run)
{
  base::Chart chart{"p_y", {"displacement of the axis at that depth", "y", "m"}, {"resistance", "p", "N/m"}};
  const std::vector<SliceRows> slices = slice_rows(run);
  for (std::size_t k = 0; k < slices.size(); k += step_of(slices.size())) {
    chart.curves.push_back(
        base::travelled({text::length_words(slices[k].z), run.path.rows, slices[k].y, slices[k].p, {}, run.path.u}, run.half()));
  }
  chart.title = "p-y curves by depth below the seabed";
  return chart;
}

std::string py_csv(const LateralRun& run)
{
  std::string text;
  for (const PyCurve& curve : py_curves(run))
    for (std::size_t k = 0; k < curve.u.size(); ++k)
      text += fmt::format("{:.6g},{:.6g},{:.6g},{:.6g}\n", curve.z, curve.u[k], curve.y[k], curve.p[k]);
  return text.empty() ? "" : "z_m,u_at_bed_m,y_m,p_N_m\n" + text;
}

std::string py_table(const LateralRun& run, const std::string& id)
{
  text::HtmlTable table(id, fmt::format("{}: resistance p per metre of depth at the end", run.record.name));
  table.columns({{"depth below the seabed, m"}, {"y, mm", true}, {"p, kN/m", true}, {"p/(s<sub>u</sub> D)", true}});
  const auto number = [](Real value) { return text::HtmlCell{text::table_number(value), true}; };
  for (const PyCurve& curve : py_curves(run))
    table.row({{text::table_number(curve.z)},
               number(1e3 * curve.y.back()),
               number(curve.p.back() / 1e3),
               number(curve.p.back() / (run.strength_at(curve.z) * run.width))});
  return table.empty() ? "" : table.html();
}

std::vector<std::string> draw_py_figure(const LateralRun& run, const std::string& name, const std::filesystem::path& folder)
{
  const std::vector<PyCurve> curves = py_curves(run);
  if (curves.empty()) return {};
  plot::Figure figure{fmt::format("{}: p-y curves by depth", run.record.name), "y (mm)", "p (kN/m)", {}, plot::from_zero};
  for (std::size_t k = 0; k < curves.size(); k += step_of(curves.size())) {
    const std::size_t number = figure.curves.size();
    figure.curves.push_back({text::length_words(curves[k].z), plot::curve_style(number, number), plot::scaled(curves[k].y, 1e3),
                             plot::scaled(curves[k].p, 1e-3)});
  }
  return draw_png_and_svg(folder, name, figure) ? std::vector{name} : std::vector<std::string>{};
}

}  // namespace berm::lateral
