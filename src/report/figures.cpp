// SPDX-License-Identifier: BSD-3-Clause
#include "report/figures.hpp"

#include "core/error.hpp"
#include "output/figure.hpp"
#include "output/plots.hpp"
#include "output/travel_curve.hpp"
#include "report/mechanism.hpp"
#include "report/paper.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <spdlog/spdlog.h>

namespace berm {
namespace {

namespace fs = std::filesystem;

constexpr PlotFormat formats[] = {PlotFormat::png, PlotFormat::svg};

/// What a figure shows over what: columns of the path of a push or a drag.
struct Chart {
  const char *name, *title, *x_label, *y_label;
  std::vector<Real> PipePath::*x, PipePath::*y;
  bool force;  ///< y is a force, else a length
};
constexpr Chart charts[] = {
    {"V_w", "Vertical resistance in the push", "embedment w", "vertical resistance V", &PipePath::w, &PipePath::V, true},
    {"H_u", "Horizontal resistance in the drag", "horizontal displacement u", "horizontal resistance H", &PipePath::drag_u,
     &PipePath::drag_H, true},
    {"w_u", "Embedment in the drag", "horizontal displacement u", "embedment w", &PipePath::drag_u, &PipePath::drag_w, false}};

std::vector<Real> scaled(std::vector<Real> values, Real factor)
{
  for (Real& value : values) value *= factor;
  return values;
}

/// The rows of a run, pale, and the same freed from noise.
void add_run(Figure& figure, const Chart& chart, const RunRecord& run, std::size_t number, const PlotUnit& x_unit, const PlotUnit& y_unit)
{
  const PipePath path = pipe_path(run.history, run.stages);
  const TravelCurve curve(path.*chart.x, path.*chart.y);
  if (curve.empty()) return;
  std::vector<Real> smooth;
  for (const Real x : curve.travel()) smooth.push_back(curve.at(x, averaging_half(run.scale)));
  if (run.scale.noisy)
    figure.curves.push_back({"", curve_style(number, 0, 0.4), scaled(path.*chart.x, x_unit.per_si), scaled(path.*chart.y, y_unit.per_si)});
  figure.curves.push_back({run.name, curve_style(number, number), scaled(curve.travel(), x_unit.per_si), scaled(smooth, y_unit.per_si)});
}

/// A figure of all runs over one another, with what the paper states; false where no run has the curve.
bool draw_chart(const std::vector<RunRecord>& runs, const Chart& chart, const fs::path& folder)
{
  Real most = 0, longest = 0;
  for (const RunRecord& run : runs) {
    if (!run.has_pipe() || run.history.rows() == 0) continue;
    const PipePath path = pipe_path(run.history, run.stages);
    for (const Real y : path.*chart.y) most = std::isfinite(y) ? std::max(most, std::abs(y)) : most;
    for (const Real x : path.*chart.x) longest = std::isfinite(x) ? std::max(longest, x) : longest;
  }
  if (most == 0) return false;
  const PlotUnit x_unit = length_unit(longest), y_unit = chart.force ? force_unit(most) : length_unit(most);
  Figure figure{
      chart.title, fmt::format("{} ({})", chart.x_label, x_unit.name), fmt::format("{} ({})", chart.y_label, y_unit.name), {}, "", 1000,
      560};
  for (std::size_t k = 0; k < runs.size(); ++k)
    if (runs[k].has_pipe() && runs[k].history.rows() > 0) add_run(figure, chart, runs[k], k, x_unit, y_unit);
  for (const PaperPoint& point : paper_points(runs)) {
    if (std::string(point.chart) != chart.name) continue;
    const std::vector<Real> x = point.x ? std::vector<Real>{*point.x} : std::vector<Real>{0, longest};
    figure.curves.push_back({point.label, point.x ? "points pt 7 ps 1.4 lc rgb '#000000'" : "lines dt 3 lw 1.5 lc rgb '#000000'",
                             scaled(x, x_unit.per_si), std::vector<Real>(x.size(), point.y * y_unit.per_si)});
  }
  return draw_figure(folder, chart.name, figure, PlotFormat::png) && draw_figure(folder, chart.name, figure, PlotFormat::svg);
}

/// A frame as pictures take it, with the strain since the frame before.
Frame<2> frame_of(const SavedSoil& soil, const SavedSoil* before, const SavedRigids& rigids)
{
  Frame<2> frame;
  frame.triangles = soil.triangles;
  for (std::size_t k = 0; k < soil.x.size(); ++k) {
    FrameParticle<2> shown{};
    shown.particle.x = Vec<2>(soil.x[k], soil.y[k]);
    shown.displacement = Vec<2>::Zero();
    shown.particle.volume = soil.volume[k];
    shown.particle.deviatoric_strain = soil.deviatoric_strain[k];
    shown.strain_increment = before == nullptr ? 0 : std::max(0.f, soil.deviatoric_strain[k] - before->deviatoric_strain[k]);
    frame.particles.push_back(shown);
  }
  FrameRigid<2> all{{}, Vec<2>::Zero()};
  for (std::size_t k = 0; k < rigids.x.size(); ++k) all.surface.points.emplace_back(rigids.x[k], rigids.y[k]);
  for (const std::vector<Index>& cell : rigids.cells) all.surface.cells.push_back({VtkCell::polygon, cell});
  if (!rigids.cells.empty()) frame.rigids.push_back(all);
  return frame;
}

/// The soil of one frame in both colourings, named NAME_soil and NAME_mechanism; gives the names that were drawn.
std::vector<std::string> draw_frame(const RunRecord& run, const PipeFrames& frames, std::size_t number, const std::string& when,
                                    const fs::path& folder)
{
  const PipePlace& pipe = frames.place(number);
  const Real D = run.scale.diameter, surface = run.settings.surface;
  const SavedSoil soil = frames.soil(number);
  std::optional<SavedSoil> before;
  if (number > 0) before = frames.soil(number - 1);
  const Frame<2> frame = frame_of(soil, before ? &*before : nullptr, frames.rigids(number));
  const SoilView view = view_around_pipe(pipe.x, surface - pipe.w, D, surface);
  const std::string place = fmt::format("{}: u = {:.3g} D, w = {:.3g} D", run.name, std::abs(pipe.u - frames.place(0).u) / D, pipe.w / D);
  std::vector<std::string> drawn;
  const auto draw_one = [&](const char* what, SoilColor color) {
    const SoilPicture picture{run.name + "_" + what + when, color, view, place};
    if (std::all_of(std::begin(formats), std::end(formats), [&](PlotFormat format) { return draw_soil(folder, frame, picture, format); }))
      drawn.push_back(picture.name);
  };
  draw_one("soil", SoilColor::deviatoric_strain);
  if (before) draw_one("mechanism", SoilColor::incremental_deviatoric_strain);
  return drawn;
}

/// The largest embedment at which a run of finite elements ends; empty without one.
std::optional<Real> deepest_wished(const std::vector<RunRecord>& runs)
{
  std::optional<Real> deepest;
  for (const RunRecord& run : runs)
    if (run.settings.method == Method::fem && run.has_pipe() && run.history.rows() > 0)
      deepest = std::max(deepest.value_or(0), run.history["w_m"].back());
  return deepest;
}

}  // namespace

std::vector<std::string> draw_report_figures(const std::vector<RunRecord>& runs, const fs::path& folder)
{
  std::vector<std::string> names;
  for (const Chart& chart : charts)
    if (draw_chart(runs, chart, folder)) names.emplace_back(chart.name);
  const std::optional<Real> wished = deepest_wished(runs);
  for (const RunRecord& run : runs) {
    try {
      const PipeFrames frames(run);
      if (frames.count() == 0) continue;
      const auto add = [&](std::size_t number, const std::string& when) {
        for (const std::string& name : draw_frame(run, frames, number, when, folder)) names.push_back(name);
      };
      add(frames.count() - 1, "");
      // The mechanism at the embedment of the finite elements, to be held beside theirs.
      if (const auto same = frames.nearest(StageKind::drag, &PipePlace::w, wished.value_or(0));
          wished && same && run.settings.method == Method::mpm)
        add(*same, "_at_w_of_fem");
    } catch (const RunError& error) {
      spdlog::warn("the soil of {} is not drawn: {}", run.name, error.what());
    }
  }
  std::vector<std::string> files;
  for (const std::string& name : names)
    for (const char* ending : {".svg", ".png"}) files.push_back(name + ending);
  return files;
}

}  // namespace berm
