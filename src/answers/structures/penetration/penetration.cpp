// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/penetration/penetration_test.cpp
#include "structures/penetration/penetration.hpp"

#include "io/atomic_file.hpp"
#include "plot/gnuplot.hpp"
#include "soil_plot/panels.hpp"
#include "structures/driven/driven.hpp"
#include "structures/driven/report.hpp"
#include "structures/penetration/depth_log.hpp"
#include "structures/penetration/penetration_page.hpp"
#include "structures/penetration/penetration_results.hpp"

#include <fmt/format.h>

namespace berm::penetration {
namespace {

using Run = const record::RunRecord&;

PenetrationRuns penetration_runs(const base::Runs& runs, const Penetrometer& how)
{
  PenetrationRuns all;
  for (const auto& [record, number] : runs) all.emplace_back(*record, how, number);
  return all;
}

bool draw_log(const plot::Panels& log, const std::filesystem::path& folder, const std::string& picture, const std::string& script,
              plot::PlotFormat format = plot::PlotFormat::png)
{
  return !log.panels.empty() && plot::draw(folder, picture, soil_plot::panels_width, soil_plot::panels_height, script, format);
}

std::vector<std::string> draw_report_log(const base::Runs& runs, const Penetrometer& how, const std::filesystem::path& folder)
{
  const plot::Panels log = depth_log(penetration_runs(runs, how), fmt::format("Resistance over the depth of the {}", how.level));
  const std::string name = std::string(how.word) + "_log", script = script_of(log, folder, name);
  const bool whole = draw_log(log, folder, name, script) && draw_log(log, folder, name, script, plot::PlotFormat::svg);
  return whole ? std::vector{name} : std::vector<std::string>{};
}

base::Charts charts_of(const PenetrationRun& pushed, const Penetrometer& how)
{
  base::Charts charts;
  const auto add = [&](const char* id, const base::Chart::Axis& y, const record::TravelCurve& rows) {
    if (rows.empty()) return;
    const base::Curve curve{"push", {}, rows.travel(), rows.value(), {}, rows.travel()};
    charts.push_back({id, {fmt::format("depth of the {}", how.level), "z", "m"}, y, {travelled(curve, pushed.half())}});
  };
  add("q_z", {"resistance", how.resistance.plain, "Pa"}, pushed.q_curve());
  add("f_z", {"mean friction of the shaft", "f", "Pa"}, pushed.friction_curve());
  if (pushed.symbol() != nullptr) add("N_z", {"factor of the resistance", pushed.symbol()->plain, "1"}, pushed.factor_curve());
  return charts;
}

}  // namespace

base::Reading reading(const Penetrometer& how)
{
  base::Reading reading{
      .answers =
          [&how](Run run, const std::vector<Real>&) {
            return run.history.rows() == 0 ? base::Reading::Quantities{} : penetration_quantities(PenetrationRun(run, how));
          },
      .names = [&how](const settings::Case&) { return penetration_names(how); },
      .notes = [&how](Run run) { return run.quantity("z_end") == nullptr ? "" : fmt::format("z: depth of the {}\n", how.level); },
      .write_files =
          [&how](const run_folder::RunFolder& folder, Run run) {
            if (const std::string csv = log_csv(PenetrationRun(run, how)); !csv.empty()) io::write_atomically(folder.file("log.csv"), csv);
          },
      .draw_curves =
          [&how](const run_folder::RunFolder& folder, Run run, const base::CurveBands&) {
            const plot::Panels log = depth_log(penetration_runs({{&run, 0}}, how), run.settings.title);
            return draw_log(log, folder.path(), "curves", script_of(log, folder.path(), "log"));
          },
      .charts = [&how](Run run) { return charts_of(PenetrationRun(run, how), how); },
      .headline = [&how](Run run, const base::DisplayUnits&) { return penetration_headline(PenetrationRun(run, how)); },
      .words = [&how](Run run, const base::DisplayUnits& shown) { return penetration_words(PenetrationRun(run, how), shown); },
      .key_results =
          [&how](const base::Runs& runs, const base::DisplayUnits& shown) {
            return penetration_key_results(penetration_runs(runs, how), shown, how.word);
          },
      .published = [&how](const base::Runs& runs,
                          const base::DisplayUnits&) { return penetration_published(penetration_runs(runs, how), how.word); },
      .measures = [&how](const settings::Case& c) { return penetration_measures(c, how); },
      .draw_report_curves = [&how](const base::Runs& runs, const base::PublishedPoints&,
                                   const std::filesystem::path& folder) { return draw_report_log(runs, how, folder); }};
  if (how.keeps_push) {
    reading.draw_curves = {};
    return reading;
  }
  reading.quality_note = [](const base::Runs&) {
    return "<p>The resistance depends on the mesh: the soil beside the edge of a body moves with it up to a cell beyond it, so that a body "
           "of width D acts as one of D + 2 h at most (examples/cone_in_clay); two runs with two cell sizes on one page show the "
           "effect.</p>\n";
  };
  return reading;
}

base::Reading travels_of(const Penetrometer& how)
{
  if (!how.keeps_push) return driven::reading_without_push();
  base::Reading travels = driven::reading();
  travels.words = [](Run run, const base::DisplayUnits& shown) { return driven::results_in_words(driven::DrivenRun(run), shown, false); };
  travels.key_results = [](const base::Runs& runs, const base::DisplayUnits& shown) {
    return driven::key_results(driven::driven_runs(runs), shown, false);
  };
  travels.measures = {};
  return travels;
}

base::Structure pushed_down(const Penetrometer& how)
{
  return {how.word, {reading(how), travels_of(how), how.also}};
}

}  // namespace berm::penetration
