// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/lateral/lateral_run_test.cpp
#include "structures/lateral/shaft.hpp"

#include "io/atomic_file.hpp"
#include "structures/driven/report.hpp"
#include "structures/lateral/lateral_page.hpp"
#include "structures/lateral/lateral_results.hpp"
#include "structures/lateral/p_y.hpp"

#include <algorithm>

namespace berm::lateral {
namespace {

bool is_pushed(const record::RunRecord& run)
{
  return base::is_pushed_down(run.settings);
}

/// Those that are pushed down.
base::Runs pushed(base::Runs runs)
{
  std::erase_if(runs, [](const base::PageRun& run) { return !is_pushed(*run.record); });
  return runs;
}

LateralRuns lateral_runs(const base::Runs& runs)
{
  LateralRuns all;
  for (const auto& [record, number] : runs)
    if (base::is_loaded_sideways(record->settings)) all.emplace_back(*record, number);
  return all;
}

}  // namespace

std::vector<run_folder::Quantity> Shaft::quantities(const record::RunRecord& run, const std::vector<Real>& held_forces) const
{
  std::vector<run_folder::Quantity> list;
  if (is_pushed(run)) list = Penetration::quantities(run, held_forces);
  for (run_folder::Quantity& quantity : lateral_quantities(LateralRun(run))) list.push_back(std::move(quantity));
  return list;
}

std::vector<std::string> Shaft::quantity_names(const problem::Case& c) const
{
  std::vector<std::string> names = base::is_pushed_down(c) ? Penetration::quantity_names(c) : std::vector<std::string>{};
  if (!base::is_loaded_sideways(c)) return names;
  for (std::string& name : lateral_names()) names.push_back(std::move(name));
  return names;
}

std::string Shaft::table_of(const record::RunRecord& run) const
{
  if (!is_pushed(run)) return lateral_table(run.quantities);
  const std::string sideways = lateral_table(run.quantities);
  if (sideways.empty()) return Penetration::table_of(run);
  record::RunRecord down;
  down.settings = run.settings, down.ground = run.ground, down.quantities = run.quantities;
  std::erase_if(down.quantities, is_lateral);
  return Penetration::table_of(down) + sideways;
}

bool Shaft::draw_curves(const run_folder::RunFolder& folder, const record::RunRecord& run, const base::CurveBands& bands) const
{
  if (const std::string csv = py_csv(LateralRun(run)); !csv.empty()) io::write_atomically(folder.file("py.csv"), csv);
  return is_pushed(run) ? Penetration::draw_curves(folder, run, bands) : draw_lateral_curves(folder, LateralRun(run));
}

base::ChartCurves Shaft::chart_curves(const record::RunRecord& run) const
{
  return is_pushed(run) ? Penetration::chart_curves(run) : base::ChartCurves{};
}

std::string Shaft::in_words(const record::RunRecord& run, const base::DisplayUnits& shown) const
{
  const std::string down = is_pushed(run) ? Penetration::in_words(run, shown) : "", sideways = lateral_words(LateralRun(run));
  if (down.empty() && sideways.empty()) return "It was not loaded far enough for a result.";
  return down + (down.empty() || sideways.empty() ? "" : " ") + sideways;
}

std::string Shaft::key_results(const base::Runs& runs, const base::DisplayUnits& shown) const
{
  return Penetration::key_results(pushed(runs), shown) + lateral_key_results(lateral_runs(runs), word());
}

std::string Shaft::published_values(const base::Runs& runs, const base::DisplayUnits& shown) const
{
  return Penetration::published_values(pushed(runs), shown);
}

base::TrustMeasures Shaft::measures(const problem::Case& c) const
{
  return base::is_pushed_down(c) ? Penetration::measures(c) : driven::driven_measures(c, own_reading().cells);
}

base::StagePaths Shaft::paths(const record::RunRecord& run) const
{
  if (is_pushed(run)) return Penetration::paths(run);
  const LateralPath path = lateral_path(run);
  return path.empty() ? base::StagePaths{} : base::StagePaths{{}, {{path.rows, path.u}}, {}};
}

std::vector<base::OwnChart> Shaft::own_charts(const record::RunRecord& run) const
{
  base::OwnChart chart = py_chart(LateralRun(run));
  return chart.curves.empty() ? std::vector<base::OwnChart>{} : std::vector{std::move(chart)};
}

/// That at the bed, as in the answer; before the load 0, after it what it came to.
std::optional<base::PointTravel> Shaft::point_travel(const record::RunRecord& run) const
{
  const LateralPath path = lateral_path(run);
  if (path.empty() || path.direction == 0) return {};
  base::PointTravel travel{"displacement at the bed", std::vector<Real>(run.history.stage.size(), 0)};
  for (std::size_t k = 0; k < path.rows.size(); ++k) std::fill(travel.u.begin() + path.rows[k], travel.u.end(), path.direction * path.u[k]);
  return travel;
}

std::vector<std::string> Shaft::draw_report_curves(const base::Runs& runs, const base::PublishedPoints& published,
                                                   const std::filesystem::path& folder) const
{
  std::vector<std::string> drawn;
  if (const base::Runs down = pushed(runs); !down.empty()) drawn = Penetration::draw_report_curves(down, published, folder);
  if (const LateralRuns sideways = lateral_runs(runs); !sideways.empty())
    for (std::string& name : draw_lateral_figures(sideways, word(), folder)) drawn.push_back(std::move(name));
  return drawn;
}

std::unique_ptr<base::RunDetails> Shaft::details(const record::RunRecord& run) const
{
  return is_pushed(run) ? Penetration::details(run) : nullptr;
}

}  // namespace berm::lateral
