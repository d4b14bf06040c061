// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/report_test.cpp
#include "io/log.hpp"
#include "structures/driven/report.hpp"

#include "os/error.hpp"
#include "soil_plot/soil_plot.hpp"
#include "structures/driven/mechanism.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::driven {
namespace {

namespace fs = std::filesystem;

constexpr plot::PlotFormat formats[] = {plot::PlotFormat::png, plot::PlotFormat::svg};

/// A frame as pictures take it.
run_folder::Frame<2> frame_of(const run_folder::SavedSoil& soil, const run_folder::SavedRigids& rigid_bodies)
{
  run_folder::Frame<2> frame;
  frame.triangles = soil.triangles;
  for (std::size_t k = 0; k < soil.x.size(); ++k) frame.points.emplace_back(soil.x[k], soil.y[k]);
  frame.volume.assign(soil.volume.begin(), soil.volume.end());
  frame.body = soil.body;
  frame.id = soil.id;
  for (const run_folder::FieldValues<float>& field : soil.fields)
    if (field.info.components == 1 || field.info.name == "displacement")
      frame.fields.push_back({field.info, std::vector<Real>(field.values.begin(), field.values.end())});
  run_folder::FrameRigid<2> all{{}, Vec<2>::Zero()};
  for (std::size_t k = 0; k < rigid_bodies.x.size(); ++k) all.surface.points.emplace_back(rigid_bodies.x[k], rigid_bodies.y[k]);
  for (const std::vector<Index>& cell : rigid_bodies.cells) all.surface.add(bodies::SurfaceMesh<2>::Kind::polygon, cell);
  if (!rigid_bodies.cells.empty()) frame.rigid_bodies.push_back(all);
  return frame;
}

/// The soil of one frame, named NAME_soil, NAME_mechanism, and NAME_FIELD of a field that not every frame has; gives the names that were drawn.
std::vector<std::string> draw_frame(const DrivenRun& run, const BodyFrames& frames, std::size_t number, const std::string& when,
                                    const fs::path& folder)
{
  const BodyPlace& pipe = frames.place(number);
  const Real D = run.scale.width, surface = run.record.surface_at(pipe.x);
  const run_folder::Frame<2> frame = frame_of(frames.soil(number), frames.rigid_bodies(number));
  soil_plot::SoilView view = soil_plot::view_around(pipe.x, surface - pipe.w, D, surface, frame.points);
  if (run.settings.geometry == settings::Geometry::axisymmetric) view.mirror();
  view.show(run.record.ground.line);
  const std::string place = fmt::format("{}: u = {:.3g} D, w = {:.3g} D", run.name, std::abs(pipe.u - frames.place(0).u) / D, pipe.w / D);
  std::vector<std::string> drawn;
  const auto draw_one = [&](const std::string& what, const std::string& field) {
    if (find_field(frame.fields, field) == nullptr) return;
    const soil_plot::SoilPicture picture{record::file_name_of(run.name) + "_" + what + when, field, view, place};
    if (std::all_of(std::begin(formats), std::end(formats),
                    [&](plot::PlotFormat format) { return soil_plot::draw_soil(folder, frame, picture, format); }))
      drawn.push_back(picture.name);
  };
  draw_one("soil", "deviatoric_strain");
  if (number > 0) draw_one("mechanism", "incremental_deviatoric_strain");
  for (const std::string& field : own_fields(frame)) draw_one(field, field);
  return drawn;
}

/// The largest embedment at which a run of small strain ends; empty without one.
std::optional<Real> max_fem_embedment(const DrivenRuns& runs)
{
  std::optional<Real> deepest;
  for (const DrivenRun& run : runs)
    if (run.settings.small_strain() && run.history.rows() > 0) deepest = std::max(deepest.value_or(0), run.history["w_m"].back());
  return deepest;
}

}  // namespace

std::vector<std::string> draw_soil_figures(const DrivenRuns& runs, const fs::path& folder)
{
  std::vector<std::string> names;
  const std::optional<Real> fem_embedment = max_fem_embedment(runs);
  for (const DrivenRun& run : runs) {
    try {
      const BodyFrames frames(run);
      if (frames.count() == 0) continue;
      const auto add = [&](std::size_t number, const std::string& when) {
        for (const std::string& name : draw_frame(run, frames, number, when, folder)) names.push_back(name);
      };
      add(frames.count() - 1, "");
      // The mechanism at the embedment of the finite elements, to be held beside theirs.
      if (const auto same = frames.nearest(settings::StageKind::drag, &BodyPlace::w, fem_embedment.value_or(0));
          fem_embedment && same && run.settings.method == settings::Method::mpm)
        add(*same, "_at_w_of_fem");
    } catch (const RunError& error) {
      io::warn("the soil of {} is not drawn: {}", run.name, error.what());
    }
  }
  return names;
}

}  // namespace berm::driven
