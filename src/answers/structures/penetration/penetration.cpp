// SPDX-License-Identifier: BSD-3-Clause
#include "structures/penetration/penetration.hpp"

#include "io/atomic_file.hpp"
#include "plot/gnuplot.hpp"
#include "soil_plot/panels.hpp"
#include "structures/driven/quantities.hpp"
#include "structures/driven/report.hpp"
#include "structures/penetration/depth_log.hpp"
#include "structures/penetration/penetration_page.hpp"
#include "structures/penetration/penetration_results.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::penetration {
namespace {

PenetrationRuns penetration_runs(const base::Runs& runs, const Reading& reading)
{
  PenetrationRuns all;
  for (const auto& [record, number] : runs) all.emplace_back(*record, reading, number);
  return all;
}

bool is_of_push(const std::string& name)
{
  return name.starts_with("V_at_w_") || name.starts_with("V_at_travel_");
}

}  // namespace

std::vector<run_folder::Quantity> Penetration::quantities(const record::RunRecord& run, const std::vector<Real>& held_forces) const
{
  std::vector<run_folder::Quantity> list = Driven::quantities(run, held_forces);
  if (list.empty()) return list;
  if (!reading_.keeps_push) std::erase_if(list, [](const run_folder::Quantity& q) { return is_of_push(q.name); });
  const PenetrationRun pushed(run, reading_);
  std::vector<run_folder::Quantity> own = penetration_quantities(pushed);
  if (reading_.keeps_push)
    for (run_folder::Quantity& quantity : failure_point(pushed)) own.push_back(std::move(quantity));
  list.insert(reading_.keeps_push ? list.end() : list.begin(), own.begin(), own.end());
  return list;
}

std::vector<std::string> Penetration::quantity_names(const problem::Case& c) const
{
  std::vector<std::string> names = Driven::quantity_names(c);
  if (names.empty()) return names;
  if (!reading_.keeps_push) std::erase_if(names, is_of_push);
  for (std::string& name : penetration_names(reading_)) names.push_back(std::move(name));
  return names;
}

std::string Penetration::table_of(const record::RunRecord& run) const
{
  std::vector<run_folder::Quantity> driven = run.quantities;
  std::erase_if(driven, [&](const run_folder::Quantity& q) { return is_of_reading(q.name, reading_); });
  return driven::key_results_table(driven, base::body_scale(run)) + penetration_table(run.quantities, reading_);
}

bool Penetration::draw_curves(const run_folder::RunFolder& folder, const record::RunRecord& run, const base::CurveBands& bands) const
{
  PenetrationRuns runs;
  runs.emplace_back(run, reading_);
  if (const std::string csv = log_csv(runs.front()); !csv.empty()) io::write_atomically(folder.file("log.csv"), csv);
  if (reading_.keeps_push) return Driven::draw_curves(folder, run, bands);
  const DepthLog log = depth_log(runs, run.settings.title);
  if (log.panels.empty()) return false;
  return plot::draw(folder.path(), "curves", soil_plot::panels_width, soil_plot::panels_height, script_of(log, folder.path(), "log"));
}

std::string Penetration::in_words(const record::RunRecord& run, const base::DisplayUnits& shown) const
{
  const std::string words = penetration_words(PenetrationRun(run, reading_), shown);
  if (!reading_.keeps_push) return words;
  const std::string more = driven::results_in_words(driven::DrivenRun(run), shown, false);
  return words + (more.starts_with(' ') ? "" : " ") + more;
}

std::string Penetration::key_results(const base::Runs& runs, const base::DisplayUnits& shown) const
{
  if (runs.empty()) return "";
  const std::string own = penetration_key_results(penetration_runs(runs, reading_), shown, reading_.word);
  return reading_.keeps_push ? own + driven::key_results(driven::driven_runs(runs), shown, false) : own;
}

std::string Penetration::published_values(const base::Runs& runs, const base::DisplayUnits&) const
{
  return runs.empty() ? "" : penetration_published(penetration_runs(runs, reading_), reading_.word);
}

base::TrustMeasures Penetration::measures(const problem::Case& c) const
{
  return penetration_measures(c, reading_);
}

std::string Penetration::quality_note(const base::Runs& runs) const
{
  if (reading_.keeps_push) return Driven::quality_note(runs);
  if (runs.empty()) return "";
  return "<p>The resistance depends on the mesh: the soil beside the edge of a body moves with it up to a cell beyond it, so that a body "
         "of width D acts as one of D + 2 h at most (examples/cone_in_clay); two runs with two cell sizes on one page show the "
         "effect.</p>\n";
}

std::vector<std::string> Penetration::draw_report_curves(const base::Runs& runs, const base::PublishedPoints& published,
                                                         const std::filesystem::path& folder) const
{
  std::vector<std::string> drawn = Driven::draw_report_curves(runs, published, folder);
  if (runs.empty()) return drawn;
  const DepthLog log = depth_log(penetration_runs(runs, reading_), fmt::format("Resistance over the depth of the {}", reading_.level));
  if (log.panels.empty()) return drawn;
  const std::string name = std::string(reading_.word) + "_log", script = script_of(log, folder, name);
  const bool whole = plot::draw(folder, name, soil_plot::panels_width, soil_plot::panels_height, script) &&
                     plot::draw(folder, name, soil_plot::panels_width, soil_plot::panels_height, script, plot::PlotFormat::svg);
  if (whole) drawn.push_back(name);
  return drawn;
}

}  // namespace berm::penetration
