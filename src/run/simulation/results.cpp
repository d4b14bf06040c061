// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/run_test.cpp
#include "simulation/results.hpp"

#include "fem/blas.hpp"
#include "io/atomic_file.hpp"
#include "io/host_info.hpp"
#include "problem/cells_at_body.hpp"
#include "record/soil_plot.hpp"
#include "run_folder/build.hpp"
#include "run_folder/progress.hpp"
#include "structures/base/soil_words.hpp"
#include "structures/base/spoiled.hpp"
#include "structures/base/still_moving.hpp"
#include "structures/base/support_reactions.hpp"
#include "structures/depth/profile_page.hpp"
#include "structures/driven/results/displacements.hpp"
#include "structures/structures.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <spdlog/spdlog.h>
#include <sstream>

namespace berm::simulation {
namespace {

void draw_soil(const problem::Case& settings, const run_folder::RunFolder& folder, const problem::Model<2>& model,
               const std::vector<bodies::RigidState<2>>& rigid_bodies, const run_folder::Frame<2>& last)
{
  record::SoilView view{model.mesh.lower, model.mesh.upper, model.surface};
  if (const Real width = base::body_scale(settings).width; width > 0) {
    const bodies::RigidBody<2>& body = model.rigid_bodies[model.main_rigid];
    const bodies::RigidState<2>& now = rigid_bodies[model.main_rigid];
    view = record::view_around(center_now<2>(body, now)[0], lowest_level<2>(placed<2>(body, now), model.axes.up_vector()), width,
                               model.surface, last.points);
  }
  if (model.mesh.metric == mesh::Metric::axisymmetric) view.mirror();
  view.show(model.ground.line);
  const auto draw_one = [&](const std::string& name, const std::string& field) {
    record::draw_soil(folder.path(), last, {name, field, view, settings.title});
  };
  draw_one("soil", "deviatoric_strain");
  draw_one("soil_increment", "incremental_deviatoric_strain");
  for (const std::string& field : own_fields(last)) draw_one("soil_" + field, field);
}
void draw_soil(const problem::Case& settings, const run_folder::RunFolder& folder, const problem::Model<3>& model,
               const std::vector<bodies::RigidState<3>>&, const run_folder::Frame<3>& last)
{
  const bool mirrored = std::find(settings.symmetry.begin(), settings.symmetry.end(), "z") != settings.symmetry.end();
  const Vec<3>&lower = model.mesh.lower, &upper = model.mesh.upper;
  const Real width = base::body_scale(settings).width;
  const record::SpaceView view = width > 0 ? record::view_around(last.rigid_bodies[model.main_rigid].surface, width, lower, upper, mirrored)
                                           : record::view_of_all(lower, upper, mirrored);
  for (const auto& [name, field] : {std::pair{"soil", "deviatoric_strain"}, {"soil_increment", "incremental_deviatoric_strain"}})
    record::draw_soil(folder.path(), last, {name, field, view, settings.title});
}

std::string words_of(const run_folder::RunTiming& timing, const run_folder::MpmCounts& counts)
{
  return fmt::format("{} steps of {} particles, {:.1f} million particle-steps/s", timing.steps, counts.particles,
                     particle_steps_per_s(timing, counts) / 1e6);
}
std::string words_of(const run_folder::RunTiming& timing, const run_folder::FemCounts& counts)
{
  return fmt::format("{} steps of {} nodes, {} iterations", timing.steps, counts.nodes, counts.iterations);
}

/// Ranks have about the same, but for the first, which makes the frames.
std::string words_of_memory(const std::vector<Real>& ranks)
{
  const auto mebibytes = [](Real bytes) { return fmt::format("{:.0f}", bytes / (1 << 20)); };
  if (ranks.size() == 1) return mebibytes(ranks[0]) + " MiB";
  const auto [least, most] = std::minmax_element(ranks.begin() + 1, ranks.end());
  return fmt::format("{} MiB on the first rank, {} to {} on the {} other{}", mebibytes(ranks[0]), mebibytes(*least), mebibytes(*most),
                     ranks.size() - 1, ranks.size() == 2 ? "" : "s");
}

void print_timings(const run_folder::RunTiming& timing)
{
  std::string table = fmt::format("{:<32} {:>10} {:>8}\n", "time by loop", "s", "part");
  for (const Timing& loop : timing.loops)
    table += fmt::format("{:<32} {:>10.3f} {:>7.1f}%\n", loop.label, loop.seconds, 100 * loop.seconds / timing.wall_s);
  const auto line = [&](const char* what, Real seconds) {
    table += fmt::format("{:<32} {:>10.3f} {:>7.1f}%\n", what, seconds, 100 * seconds / timing.wall_s);
  };
  table += fmt::format("{:<32} {:>10} {:>8}\n", "time by part", "s", "part");
  line("steps", timing.parts.steps);
  line("rows of the history", timing.parts.rows);
  line("frames", timing.parts.frames);
  line("checkpoints", timing.parts.checkpoints);
  line("files, beside the steps", timing.parts.beside);
  line("processor time", timing.processors_s);
  const std::string all = std::visit([&](const auto& counts) { return words_of(timing, counts); }, timing.counts);
  table += fmt::format("{:<32} {:>10.3f}          {} on {} thread{}\n", "all", timing.wall_s, all, timing.threads,
                       timing.threads == 1 ? "" : "s");
  table += fmt::format("{:<32} {}", "memory at most", words_of_memory(timing.memory));
  spdlog::info("{}", table);
}

/// Gives a record the checks of its summary.
void take_checks(const run_folder::Summary::Checks& checks, record::RunRecord& run)
{
  if (!run.summary) run.summary.emplace();
  for (const auto& [name, check] : checks) run.summary->checks[name] = std::visit([](auto value) -> Real { return value; }, check);
}

}  // namespace

std::string key_results(const std::string& table, const std::vector<std::string>& spoiled)
{
  if (table.empty() || spoiled.empty()) return table.empty() ? "" : "key results\n" + table;
  std::string marked = fmt::format("key results; (!) the answer is spoiled: {}\n", base::spoiled_words(spoiled));
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);)
    marked += (marked.back() == '\n' ? "" : "\n") + line + base::spoiled_mark(spoiled) + "\n";
  if (table.back() != '\n') marked.pop_back();
  return marked;
}

template <int dim>
std::string write_results(const RunRequest& request, const run_folder::RunFolder& folder, const problem::Model<dim>& model,
                          const std::vector<bodies::RigidState<dim>>& rigid_bodies, const run_folder::Frame<dim>& last,
                          const RunOutcome& outcome, const run_folder::RunTiming& timing)
{
  io::sync_file(folder.file("history.csv"));  // a summary that says "finished" must not outlive it
  const problem::Case& settings = request.settings;
  record::RunRecord run;
  run.folder = folder.path();
  run.settings = settings;
  run.ground = model.ground;
  run.history = outcome.history;
  const base::Structure& structure = structures::structure_of(settings);

  // Forces are measured by the soil below the body, as in the report, which reads the region in the summary.
  if (const Index main = model.main_rigid; main != none)
    if (const std::string region = region_below<dim>(model, model.rigid_bodies[main].shape, base::reference_depth(settings, model.ground));
        !region.empty())
      run.summary.emplace().text[base::region_entry] = region;

  run_folder::Summary summary;
  run.quantities = structure.quantities(run, outcome.held_forces);
  for (run_folder::Quantity& quantity : base::dissipation_quantities(run)) run.quantities.push_back(std::move(quantity));
  for (run_folder::Quantity& quantity : base::support_quantities(run)) run.quantities.push_back(std::move(quantity));
  for (run_folder::Quantity& quantity : base::fill_quantities(run)) run.quantities.push_back(std::move(quantity));
  summary.quantities = run.quantities;
  summary.force_measure = base::measure_quantity(base::body_scale(run));
  summary.timing = timing;
  summary.text = {{"title", settings.title},
                  {"case", request.case_file.filename().string()},
                  {"version", BERM_VERSION},
                  {"machine", io::host_description()},
                  {"date", io::utc_date(std::chrono::system_clock::now())}};
  for (auto& entry : run_folder::this_build()) summary.text.push_back(std::move(entry));
  if (request.settings.method == problem::Method::fem) summary.text.emplace_back("blas_kernel", fem::blas_kernel());
  if (run.summary) summary.text.emplace_back(base::region_entry, run.summary->text.at(base::region_entry));
  summary.checks = {{"finished", outcome.finished}};
  summary.checks.insert(summary.checks.end(), outcome.checks.begin(), outcome.checks.end());
  summary.warnings = outcome.warnings;
  take_checks(summary.checks, run);
  summary.spoiled = base::spoiled_by(run);
  for (const std::string& why : summary.spoiled) spdlog::warn("the answer is spoiled: {}", why);
  for (const std::string& doubt : driven::lower_estimates(run)) spdlog::warn("{}", doubt);
  summary.write(folder.file("summary.json"));
  for (const std::filesystem::path& names : {folder.path(), folder.file("frames")}) io::sync_file(names);  // before the checkpoints go

  structure.draw_curves(folder, run, {});
  depth::write_files(folder, run);
  draw_soil(settings, folder, model, rigid_bodies, last);
  print_timings(timing);
  return key_results(structure.table_of(run) + base::still_moving_lines(run), summary.spoiled);
}

template std::string write_results(const RunRequest&, const run_folder::RunFolder&, const problem::Model<2>&,
                                   const std::vector<bodies::RigidState<2>>&, const run_folder::Frame<2>&, const RunOutcome&,
                                   const run_folder::RunTiming&);
template std::string write_results(const RunRequest&, const run_folder::RunFolder&, const problem::Model<3>&,
                                   const std::vector<bodies::RigidState<3>>&, const run_folder::Frame<3>&, const RunOutcome&,
                                   const run_folder::RunTiming&);

}  // namespace berm::simulation
