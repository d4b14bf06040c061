// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/lateral/lateral_run_test.cpp
#include "structures/lateral/shaft.hpp"

#include "io/atomic_file.hpp"
#include "plot/figure.hpp"
#include "structures/driven/report.hpp"
#include "structures/lateral/code_page.hpp"
#include "structures/lateral/lateral_page.hpp"
#include "structures/lateral/lateral_results.hpp"
#include "structures/lateral/p_y.hpp"
#include "structures/penetration/penetration.hpp"

#include <algorithm>

namespace berm::lateral {
namespace {

using Run = const record::RunRecord&;

LateralRuns lateral_runs(const base::Runs& runs)
{
  LateralRuns all;
  for (const auto& [record, number] : runs) all.emplace_back(*record, number);
  return all;
}

/// Of a body that nothing pushes: H, w and V over the displacement at the seabed, all along x.
base::Charts load_charts(const LateralRun& run)
{
  if (run.empty()) return {};
  const LateralPath& path = run.path;
  const Real direction = path.direction < 0 ? -1 : 1;
  const base::Chart::Axis u{"displacement at the seabed", "u", "m"}, w{"embedment", "w", "m"}, V{"vertical reaction", "V", "N"};
  base::Charts charts{{"V_w", w, V}, {"H_u", u, {"horizontal reaction along x", "H", "N"}}, {"w_u", u, w}, {"V_u", u, V}};
  for (std::size_t k = 1; k < charts.size(); ++k) {
    base::Curve curve{"load", path.rows, plot::scaled(path.u, direction), {}, {}, path.u, 0, direction};
    for (const Index row : path.rows) curve.y.push_back(run.record.history.by_label(charts[k].y.symbol)[row]);
    charts[k].curves.push_back(travelled(std::move(curve), averaging_half(base::body_scale(run.record))));
  }
  return charts;
}

/// That at the seabed, as in the answer; before the load 0, after it what it came to.
std::optional<base::PointTravel> point_at_the_bed(Run run)
{
  const LateralPath path = lateral_path(run);
  if (path.empty() || path.direction == 0) return {};
  base::PointTravel travel{"displacement at the seabed", std::vector<Real>(run.history.stage.size(), 0)};
  for (std::size_t k = 0; k < path.rows.size(); ++k) std::fill(travel.u.begin() + path.rows[k], travel.u.end(), path.direction * path.u[k]);
  return travel;
}

/// Of a body that is loaded sideways.
base::Reading load_of(const penetration::Penetrometer& how)
{
  return {.applies = base::is_loaded_sideways,
          .answers = [](Run run, const std::vector<Real>&) { return lateral_quantities(LateralRun(run)); },
          .names = [](const settings::Case&) { return lateral_names(); },
          .notes = [](Run run) -> std::string {
            return run.quantity("lateral_H_end_over_DLsu") == nullptr
                       ? ""
                       : "lateral_H_end: over D, the length in the seabed and the mean s_u\n";
          },
          .write_files =
              [](const run_folder::RunFolder& folder, Run run) {
                if (const std::string csv = py_csv(LateralRun(run)); !csv.empty()) io::write_atomically(folder.file("py.csv"), csv);
              },
          .draw_curves = [](const run_folder::RunFolder& folder, Run run,
                            const base::CurveBands&) { return draw_lateral_curves(folder, LateralRun(run)); },
          .charts =
              [](Run run) {
                const LateralRun lateral(run);
                base::Charts charts = base::is_pushed_down(run.settings) ? base::Charts{} : load_charts(lateral);
                if (base::Chart py = py_chart(lateral); !py.curves.empty()) charts.push_back(std::move(py));
                return charts;
              },
          .headline =
              [](Run, const base::DisplayUnits&) {
                return base::Headline{{"lateral_H_end", "Lateral load"},
                                      {"lateral_u_end", "Displacement at the seabed"},
                                      {"lateral_tilt_end", "Tilt"},
                                      {"lateral_M_end", "Moment at the seabed"},
                                      {"lateral_pivot_end", "Depth of the pivot"}};
              },
          .words = [](Run run, const base::DisplayUnits&) { return lateral_words(LateralRun(run)); },
          .key_results = [&how](const base::Runs& runs,
                                const base::DisplayUnits&) { return lateral_key_results(lateral_runs(runs), how.word); },
          .published = [&how](const base::Runs& runs, const base::DisplayUnits&) { return code_values(lateral_runs(runs), how.word); },
          .draw_report_curves =
              [&how](const base::Runs& runs, const base::PublishedPoints&, const std::filesystem::path& folder) {
                return draw_lateral_figures(lateral_runs(runs), how.word, folder);
              },
          .point_travel = point_at_the_bed};
}

/// Of one that nothing pushes down.
base::Reading at_rest(const penetration::Penetrometer& how)
{
  return {.applies = [](const settings::Case& c) { return !base::is_pushed_down(c); },
          .words = [](Run run, const base::DisplayUnits&) -> std::string {
            return LateralRun(run).H_curve().empty() ? "It was not loaded far enough for a result." : "";
          },
          .measures = [&how](const settings::Case& c) { return driven::driven_measures(c, how.cells); }};
}

}  // namespace

base::Structure shaft(const penetration::Penetrometer& how)
{
  base::Structure structure = penetration::pushed_down(how);
  for (base::Reading& reading : structure.readings) reading.applies = base::is_pushed_down;
  structure.readings.insert(structure.readings.end() - 1, {load_of(how), at_rest(how)});
  structure.readings.back().applies = {};
  return structure;
}

}  // namespace berm::lateral
