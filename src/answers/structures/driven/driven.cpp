// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/structures_test.cpp
#include "structures/driven/driven.hpp"

#include "io/atomic_file.hpp"
#include "structures/base/still_moving.hpp"
#include "structures/driven/curves.hpp"
#include "structures/driven/details.hpp"
#include "structures/driven/displacements.hpp"
#include "structures/driven/known_names.hpp"
#include "structures/driven/mechanism.hpp"
#include "structures/driven/quantities.hpp"
#include "structures/driven/report.hpp"
#include "structures/driven/run_charts.hpp"
#include "structures/driven/states.hpp"

#include <algorithm>

namespace berm::driven {
namespace {

/// What is said of the ends at which the body still moves, by what the quantities there are of: a stage, "push" for the way down, a state.
std::map<std::string, std::string> moving_at_ends(const record::RunRecord& run, const States& states)
{
  std::map<std::string, std::string> words;
  const Path path = path_of(run.history, stages_of(run.settings));
  for (const base::StillMoving& moving : base::still_moving(run)) {
    const std::string said = still_moving_words(moving);
    words[moving.stage] = said;
    if (!path.push.rows.empty() && run.history.stage[path.push.rows.back()] == moving.stage) words["push"] = said;
    for (const State& state : states)
      if (state.stage == moving.stage) words[state.name] = said;
  }
  return words;
}

std::vector<run_folder::Quantity> answers_of(const record::RunRecord& run, const std::vector<Real>& held_forces)
{
  if (run.history.rows() == 0) return {};
  const base::BodyScale scale = base::body_scale(run);
  Results results = results_from(run.history, scale, stages_of(run.settings, held_forces));
  take_berms(results, DrivenRun(run));
  const States states = states_of(run);
  if (has_states_between(states))
    for (const char* name : state_names)
      if (const State* state = find_state(states, name)) results.states.push_back({name, state->w, state->V, state->V_given});
  std::vector<run_folder::Quantity> list = quantities_of(results, scale, moving_at_ends(run, states));
  for (run_folder::Quantity& moment : moments_in_space(run)) list.push_back(std::move(moment));
  return list;
}

/// How drags by a force that varies were run.
std::string notes_of(const record::RunRecord& run)
{
  std::string notes;
  for (const std::string& line : time_scale_lines(run))
    notes += line + "; times above are those of the record, half_cycles.csv has each half cycle\n";
  for (const std::string& doubt : lower_estimates(run)) notes += doubt + "\n";
  return notes;
}

void write_files(const run_folder::RunFolder& folder, const record::RunRecord& run)
{
  if (run.history.rows() == 0) return;
  const std::string half_cycles = half_cycles_csv(run.history, stages_of(run.settings), base::body_scale(run).width);
  if (!half_cycles.empty()) io::write_atomically(folder.file("half_cycles.csv"), half_cycles);
}

base::Charts charts_of(const record::RunRecord& run)
{
  return run_charts(run.history, base::body_scale(run), stages_of(run.settings));
}

bool draw_curves(const run_folder::RunFolder& folder, const record::RunRecord& run, const base::CurveBands& bands)
{
  if (run.history.rows() == 0) return false;
  return draw_run_curves(folder, charts_of(run), base::body_scale(run), run.settings.title, bands);
}

std::string quality_note(const base::Runs& runs)
{
  const auto may_localise = [](const base::PageRun& run) {
    const settings::Case& c = run.record->settings;
    return c.method == settings::Method::mpm &&
           std::any_of(c.material.begin(), c.material.end(), [](const auto& soil) { return non_associated(soil.second); });
  };
  if (std::none_of(runs.begin(), runs.end(), may_localise)) return "";
  return "<p>V depends on the mesh (examples/mesh_study), since sand with psi below phi localises in bands as wide as the cells, unless "
         "its d50 is known "
         "(examples/localisation). "
         "<code>berm run --resume RUN --uncertainty</code> gives the number a band; phi* for phi shows the lower end "
         "(<code>berm study examples/mesh_study</code>).</p>\n";
}

}  // namespace

base::Reading reading()
{
  using Run = const record::RunRecord&;
  return {
      .answers = answers_of,
      .names = known_names,
      .notes = notes_of,
      .write_files = write_files,
      .draw_curves = draw_curves,
      .charts = charts_of,
      .headline = [](Run run, const base::DisplayUnits&) { return headline(DrivenRun(run)); },
      .words = [](Run run, const base::DisplayUnits& shown) { return results_in_words(DrivenRun(run), shown); },
      .key_results = [](const base::Runs& runs, const base::DisplayUnits& shown) { return key_results(driven_runs(runs), shown); },
      .measures = [](const settings::Case& c) { return driven_measures(c); },
      .quality_note = quality_note,
      .draw_report_curves = [](const base::Runs& runs, const base::PublishedPoints& published,
                               const std::filesystem::path& folder) { return draw_travel_figures(driven_runs(runs), published, folder); },
      .draw_report_soil = [](const base::Runs& runs,
                             const std::filesystem::path& folder) { return draw_soil_figures(driven_runs(runs), folder); },
      .details = details_of};
}

base::Reading reading_without_push()
{
  const auto is_of_push = [](const std::string& name) { return name.starts_with("V_at_w_") || name.starts_with("V_at_travel_"); };
  base::Reading rest = reading();
  rest.answers = [=](const record::RunRecord& run, const std::vector<Real>& held_forces) {
    std::vector<run_folder::Quantity> list = answers_of(run, held_forces);
    std::erase_if(list, [&](const run_folder::Quantity& q) { return is_of_push(q.name); });
    return list;
  };
  rest.names = [=](const settings::Case& c) {
    std::vector<std::string> names = known_names(c);
    std::erase_if(names, is_of_push);
    return names;
  };
  rest.draw_curves = {}, rest.headline = {}, rest.words = {}, rest.key_results = {}, rest.measures = {}, rest.quality_note = {};
  return rest;
}

}  // namespace berm::driven
