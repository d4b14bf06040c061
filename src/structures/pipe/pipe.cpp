// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/structures_test.cpp
#include "structures/pipe/pipe.hpp"

#include "plot/figure.hpp"
#include "structures/pipe/pipe_curves.hpp"
#include "structures/pipe/published/published.hpp"
#include "structures/pipe/report/pipe_report.hpp"
#include "structures/pipe/results/axial_results.hpp"
#include "structures/pipe/results/mechanism.hpp"
#include "structures/pipe/results/pipe_details.hpp"
#include "structures/pipe/results/pipe_quantities.hpp"

#include <algorithm>

namespace berm::pipe {
namespace {

PipeRuns pipe_runs(const base::Runs& runs)
{
  PipeRuns all;
  for (const auto& [record, number] : runs) all.emplace_back(*record, number);
  return all;
}

}  // namespace

std::vector<run_folder::Quantity> Pipe::quantities(const record::RunRecord& run, const std::vector<Real>& held_forces) const
{
  if (run.history.rows() == 0) return {};
  const base::BodyScale scale = base::body_scale(run);
  PipeResults results = pipe_results(run.history, scale, pipe_stages(run.settings, held_forces));
  take_berms(results, PipeRun(run));
  std::vector<run_folder::Quantity> list = quantities_of(results, scale);
  for (run_folder::Quantity& moment : moments_in_space(run)) list.push_back(std::move(moment));
  for (run_folder::Quantity& axial : axial_quantities(run)) list.push_back(std::move(axial));
  return list;
}

std::string Pipe::table_of(const record::RunRecord& run) const
{
  return key_results_table(run.quantities, base::body_scale(run));
}

bool Pipe::is_answer(const record::RunRecord& run, const run_folder::Quantity& quantity) const
{
  const auto ends_with_any = [&](std::initializer_list<const char*> ends) {
    return std::any_of(ends.begin(), ends.end(), [&](const char* end) { return quantity.name.ends_with(end); });
  };
  return !is_prescribed(run, quantity) &&
         !ends_with_any({"_over_gammaD2", "_over_D", "_noise", "V_rms_error_in_drag", "second_impulse_over_V", "overlap_max", "gap_mean"});
}

bool Pipe::draw_curves(const run_folder::RunFolder& folder, const record::RunRecord& run, const base::CurveBands& bands) const
{
  return run.history.rows() > 0 &&
         draw_pipe_curves(folder, run.history, base::body_scale(run), pipe_stages(run.settings), run.settings.title, bands);
}

base::ChartCurves Pipe::chart_curves(const record::RunRecord& run) const
{
  if (run.history.rows() == 0) return {};
  const PipePath path = pipe_path(run.history, pipe_stages(run.settings));
  std::vector<Real> w, V;
  for (std::size_t k = 0; k < path.push.w.size(); ++k)
    if (path.push.w[k] >= 0) w.push_back(path.push.w[k]), V.push_back(path.push.V[k]);
  base::ChartCurves curves{{"V_w", 0, 1, {w, V}}};
  for (const DragPath& drag : path.drags) {
    const Real begin = drag.u_begin - path.drag().u_begin, direction = drag.stage.direction;
    curves.push_back({"H_u", begin, direction, {drag.travel, plot::scaled(drag.H, direction)}});
    curves.push_back({"w_u", begin, direction, {drag.travel, drag.w}});
  }
  return curves;
}

std::string Pipe::in_words(const record::RunRecord& run, const base::DisplayUnits& shown) const
{
  return results_in_words(PipeRun(run), shown);
}

std::string Pipe::key_results(const base::Runs& runs, const base::DisplayUnits& shown) const
{
  return pipe::key_results(pipe_runs(runs), shown) + axial_table(pipe_runs(runs), shown);
}

std::string Pipe::published_values(const base::Runs& runs, const base::DisplayUnits& shown) const
{
  return pipe::published_values(pipe_runs(runs), shown);
}

base::TrustMeasures Pipe::measures(const problem::Case& c) const
{
  return pipe_measures(c);
}

std::string Pipe::quality_note(const base::Runs& runs) const
{
  if (std::none_of(runs.begin(), runs.end(), [](const auto& run) { return run.record->settings.method == problem::Method::mpm; }))
    return "";
  return "<p>V depends on the mesh (examples/mesh_study), since sand with psi below phi localises in bands as wide as the cells "
         "(examples/localisation). "
         "<code>berm run --resume RUN --uncertainty</code> gives the number a band; phi* for phi shows the lower end "
         "(<code>berm study examples/mesh_study</code>).</p>\n";
}

base::StagePaths Pipe::paths(const record::RunRecord& run) const
{
  if (run.history.rows() == 0) return {};
  const PipePath path = pipe_path(run.history, pipe_stages(run.settings));
  base::StagePaths paths{{path.push.rows, path.push.w}, {}};
  for (const DragPath& drag : path.drags) paths.drags.push_back({drag.rows, drag.travel});
  return paths;
}

std::vector<std::string> Pipe::draw_report_curves(const base::Runs& runs, const base::PublishedPoints& published,
                                                  const std::filesystem::path& folder) const
{
  return pipe::draw_curves(pipe_runs(runs), published, folder);
}

std::vector<std::string> Pipe::draw_report_soil(const base::Runs& runs, const std::filesystem::path& folder) const
{
  return draw_soil_figures(pipe_runs(runs), folder);
}

std::unique_ptr<base::RunDetails> Pipe::details(const record::RunRecord& run) const
{
  return pipe_details(run);
}

base::EmbeddedBody Pipe::embedded(const problem::Case& c) const
{
  return embedded_pipe(c);
}

base::PublishedEnvelope Pipe::published_envelope(const problem::Case& c, const base::EnvelopeEnds& ends) const
{
  return pipe_envelope(c, ends);
}

}  // namespace berm::pipe
