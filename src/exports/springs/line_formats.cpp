// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/springs/line_formats_test.cpp
#include "springs/line_formats.hpp"

#include "os/error.hpp"
#include "record/travel_curve.hpp"
#include "run_folder/csv_line.hpp"
#include "slices/line_of_case.hpp"
#include "structures/line/answers.hpp"
#include "structures/line/shapes.hpp"
#include "structures/structures.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <set>

namespace berm::springs {
namespace {

/// The stages that loaded the line of a run.
std::set<std::string> line_stages(const record::RunRecord& run)
{
  if (!run.settings.pipeline)
    throw InputError(fmt::format("{} is not a run of a pipeline: its case has no [pipeline]", run.folder.string()));
  std::set<std::string> stages;
  for (const line::StageEnd& end : line::stage_ends(run)) stages.insert(end.name);
  if (stages.empty())
    throw RunError(fmt::format("{} has not reached its line: there is no row of a stage of kind \"pipeline\"", run.folder.string()));
  return stages;
}

/// Comment lines that say from which run a file is.
std::string head_of_files(const record::RunRecord& run)
{
  std::string text;
  for (const std::string& line : head_of(run)) text += "# " + line + "\n";
  return text + fmt::format("# run {}\n", run.name);
}

/// u, w, H and V of a slice in stages that load the line.
struct SliceRows {
  std::vector<std::size_t> rows;  ///< of the history
  const std::vector<Real>&u, &w, &H, &V;

  SliceRows(const run_folder::History& history, const std::set<std::string>& stages, const std::string& slice)
      : u(history[slice + "u_m"]),
        w(history[slice + "w_m"]),
        H(history[slice + "H_N_m"]),
        V(history[slice + "V_N_m"])
  {
    for (std::size_t k = 0; k < history.stage.size(); ++k)
      if (stages.contains(history.stage[k])) rows.push_back(k);
  }
};

/// The points of one side (1: along +x of the slice, -1: against it) where the slice goes farther than before, displacements from where it was laid.
std::string backbone_of(const SliceRows& slice, const std::string& place, Real side, Real half)
{
  std::vector<Real> travel, H, V;
  const Real laid = slice.u[std::max<std::size_t>(slice.rows.front(), 1) - 1];
  for (const std::size_t k : slice.rows) {
    if (side * (slice.u[k] - laid) < 0) continue;
    travel.push_back(side * (slice.u[k] - laid));
    H.push_back(side * slice.H[k]);
    V.push_back(slice.V[k]);
  }
  const record::TravelCurve resistance(travel, H), reaction(travel, V);
  if (resistance.empty() || resistance.end() < half) return "";
  const record::TravelCurve p = resistance.smoothed(half), v = reaction.smoothed(half);
  std::string text;
  for (std::size_t k = 0; k < p.travel().size(); ++k)
    text += fmt::format("{},{},{:.6g},{:.6g},{:.6g}\n", place, side > 0 ? "+x" : "-x", p.travel()[k], p.value()[k], v.value()[k]);
  return text;
}

}  // namespace

ExportFiles shape_files(const record::RunRecord& run)
{
  const std::set<std::string> stages = line_stages(run);
  const std::vector<line::Shape> shapes = line::read_shapes(run.folder);
  if (shapes.empty()) throw RunError(fmt::format("{} has no line.csv with the shapes of its line", run.folder.string()));
  std::string text =
      head_of_files(run) +
      "# the line by node at each frame: x along it, y lateral, z upwards from where it was laid, u along it; P is compression\n"
      "time_s,stage,x_m,y_m,z_m,u_m,P_N,M_Nm\n";
  for (const line::Shape& shape : shapes)
    for (std::size_t i = 0; i < shape.x.size() && stages.contains(shape.stage); ++i)
      fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{}\n", shape.time, run_folder::csv_field(shape.stage), shape.x[i],
                     shape.y[i], shape.z[i], shape.u[i], shape.P[i], shape.M[i]);
  return {{"line.csv", std::move(text)}};
}

ExportFiles py_files(const record::RunRecord& run)
{
  if (!run.settings.pipeline) return pile_files(run);
  const std::set<std::string> stages = line_stages(run);
  const std::vector<Real> places = slices::LineOfCase(run.settings).places;
  const Real half = base::averaging_half(base::body_scale(run));
  const std::string head = head_of_files(run);
  std::string all =
      head + "# resistance H along x and reaction V of the soil in each slice, means since the row before; u and w as in history.csv\n"
             "slice,x_m,time_s,stage,u_m,w_m,H_N_m,V_N_m\n";
  std::string backbone = head + fmt::format("# H against the motion, and V, where a slice moves farther to a side from its laid position "
                                            "than ever before; means over {:.3g} m of u to either side\n"
                                            "slice,x_m,side,u_m,H_N_m,V_N_m\n",
                                            half);
  const std::vector<Real>& time = run.history["time_s"];
  for (std::size_t s = 0; s < places.size(); ++s) {
    const SliceRows slice(run.history, stages, s == 0 ? "" : fmt::format("slice_{}_", s));
    const std::string place = fmt::format("{},{:.6g}", s, places[s]);
    for (const std::size_t k : slice.rows)
      fmt::format_to(std::back_inserter(all), "{},{},{},{},{},{},{}\n", place, time[k], run_folder::csv_field(run.history.stage[k]),
                     slice.u[k], slice.w[k], slice.H[k], slice.V[k]);
    for (const Real side : {1., -1.}) backbone += backbone_of(slice, place, side, half);
  }
  return {{"py.csv", std::move(all)}, {"py_backbone.csv", std::move(backbone)}};
}

ExportFiles curve_files(const record::RunRecord& run)
{
  return {{"curves.json", structures::curves_json(run)}};
}

}  // namespace berm::springs
