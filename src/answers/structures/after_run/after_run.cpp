// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/run_test.cpp
#include "structures/after_run/after_run.hpp"

#include "io/log.hpp"
#include "problem/cells_at_body.hpp"
#include "run_folder/summary_file.hpp"
#include "soil_plot/soil_plot.hpp"
#include "structures/base/invalid_answer.hpp"
#include "structures/base/soil_words.hpp"
#include "structures/base/still_moving.hpp"
#include "structures/base/support_reactions.hpp"
#include "structures/driven/displacements.hpp"
#include "structures/other_bodies.hpp"
#include "structures/structures.hpp"
#include "text/html.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <sstream>

namespace berm::after_run {
namespace {

void draw_soil(const settings::Case& settings, const run_folder::RunFolder& folder, const simulation::LastState<2>& at_end)
{
  const auto& [model, rigid_bodies, last] = at_end;
  soil_plot::SoilView view{model.mesh.lower, model.mesh.upper, model.surface};
  if (const Real width = base::body_scale(settings).width; width > 0) {
    const bodies::RigidBody<2>& body = model.rigid_bodies[model.main_rigid];
    const bodies::RigidState<2>& now = rigid_bodies[model.main_rigid];
    view = soil_plot::view_around(center_now<2>(body, now)[0], lowest_level<2>(placed<2>(body, now), model.axes.up_vector()), width,
                                  model.surface, last.points);
  }
  if (model.mesh.metric == mesh::Metric::axisymmetric) view.mirror();
  view.show(model.ground.line);
  const auto draw_one = [&, &frame = at_end.frame](const std::string& name, const std::string& field) {
    soil_plot::draw_soil(folder.path(), frame, {name, field, view, settings.title});
  };
  draw_one("soil", "deviatoric_strain");
  draw_one("soil_increment", "incremental_deviatoric_strain");
  for (const std::string& field : own_fields(last)) draw_one("soil_" + field, field);
}
void draw_soil(const settings::Case& settings, const run_folder::RunFolder& folder, const simulation::LastState<3>& at_end)
{
  const auto& [model, rigid_bodies, last] = at_end;
  const bool mirrored = std::find(settings.symmetry.begin(), settings.symmetry.end(), "z") != settings.symmetry.end();
  const Vec<3>&lower = model.mesh.lower, &upper = model.mesh.upper;
  const Real width = base::body_scale(settings).width;
  const soil_plot::SpaceView view = width > 0
                                        ? soil_plot::view_around(last.rigid_bodies[model.main_rigid].surface, width, lower, upper, mirrored)
                                        : soil_plot::view_of_all(lower, upper, mirrored);
  for (const auto& [name, field] : {std::pair{"soil", "deviatoric_strain"}, {"soil_increment", "incremental_deviatoric_strain"}})
    soil_plot::draw_soil(folder.path(), last, {name, field, view, settings.title});
}

/// Gives a record the checks of its summary.
void take_checks(const run_folder::Summary::Checks& checks, record::RunRecord& run)
{
  if (!run.summary) run.summary.emplace();
  for (const auto& [name, check] : checks) run.summary->checks[name] = std::visit([](auto value) -> Real { return value; }, check);
}

/// The table under a heading, "" where it is empty; of a run whose answer is invalid with why, and a mark behind every line.
std::string key_results(const std::string& table, const std::vector<std::string>& invalid)
{
  if (table.empty() || invalid.empty()) return table.empty() ? "" : "key results\n" + table;
  std::string marked = fmt::format("key results; (!) the answer is invalid: {}\n", base::invalid_words(invalid));
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);)
    marked += (marked.back() == '\n' ? "" : "\n") + line + base::invalid_mark(invalid) + "\n";
  if (table.back() != '\n') marked.pop_back();
  return marked;
}

/// Forces are measured by the soil below the body, as in the report, which reads the region in the summary.
template <int dim>
std::string region_below_body(const settings::Case& c, const simulation::LastState<dim>& last)
{
  const Index main = last.model.main_rigid;
  return main == none ? ""
                      : region_below<dim>(last.model, last.model.rigid_bodies[main].shape, base::reference_depth(c, last.model.ground));
}

simulation::Answers answers_of(simulation::EndedRun& ended)
{
  record::RunRecord& run = ended.run;
  const base::Structure& structure = structures::structure_of(run.settings);
  simulation::Answers answers;
  if (const std::string region = std::visit([&](const auto& last) { return region_below_body(run.settings, last); }, ended.last);
      !region.empty()) {
    run.summary.emplace().text[base::region_entry] = region;
    answers.text.emplace_back(base::region_entry, region);
  }
  run.quantities = structures::quantities_of(run, ended.held_forces);
  for (const auto& quantities : {base::dissipation_quantities, base::support_quantities, base::fill_quantities})
    for (run_folder::Quantity& quantity : quantities(run)) run.quantities.push_back(std::move(quantity));
  answers.quantities = run.quantities;
  answers.force_measure = base::measure_quantity(base::body_scale(run));
  take_checks(ended.checks, run);
  const base::DisplayUnits shown({{base::body_scale(run), &run.quantities}});
  answers.text.emplace_back("answer", text::text_of_html(structure.in_words(run, shown)));
  if (const base::Headline numbers = structure.headline(run, shown); !numbers.empty())
    answers.text.emplace_back("key_number", numbers.front().quantity);
  answers.invalid = base::invalid_because(run);
  for (const std::string& why : answers.invalid) io::warn("the answer is invalid: {}", why);
  for (const std::string& doubt : driven::lower_estimates(run)) io::warn("{}", doubt);
  answers.key_results = key_results(structure.table_of(run) + base::still_moving_lines(run), answers.invalid);
  return answers;
}

}  // namespace

simulation::AfterRun answers_and_drawings()
{
  using simulation::EndedRun;
  return {answers_of,
          {[](const EndedRun& ended) {
             const base::Structure& structure = structures::structure_of(ended.run.settings);
             structures::write_curves(ended.folder, ended.run);
             structure.write_files(ended.folder, ended.run);
             structure.draw_curves(ended.folder, ended.run, {});
           },
           [](const EndedRun& ended) {
             std::visit([&](const auto& last) { draw_soil(ended.run.settings, ended.folder, last); }, ended.last);
           }}};
}

std::string key_results_in(const simulation::RunRequest& request)
{
  record::RunRecord run;
  run.settings = request.settings;
  run.summary = run_folder::read_summary(request.folder);
  if (run.summary) run.quantities = run.summary->quantities;
  const std::string table = run.summary ? structures::structure_of(request.settings).table_of(run) : "";
  return table.empty() ? "" : fmt::format("{}: {}", request.folder.string(), key_results(table, run.summary->invalid));
}

}  // namespace berm::after_run
