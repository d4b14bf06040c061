// SPDX-License-Identifier: BSD-3-Clause
#include "commands/case_options.hpp"
#include "commands/command.hpp"
#include "commands/report.hpp"
#include "commands/side_by_side.hpp"
#include "core/ranks.hpp"
#include "io/folder_lock.hpp"
#include "io/log.hpp"
#include "io/scratch_folder.hpp"
#include "io/tell.hpp"
#include "jobs/outcome.hpp"
#include "os/error.hpp"
#include "os/interrupt.hpp"
#include "os/mesh_cache.hpp"
#include "run_folder/summary_file.hpp"
#include "sandbox/sandbox.hpp"
#include "simulation/longer_mesh.hpp"
#include "simulation/run_of_ranks.hpp"
#include "simulation/run_place.hpp"
#include "structures/after_run/after_run.hpp"
#include "structures/base/invalid_answer.hpp"
#include "uncertainty/find_bands.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::commands {
namespace {

using jobs::Outcome;

/// Of a run that did not come to its end and did not fail: it was stopped, and can be resumed where it could write a checkpoint.
Outcome outcome_of_stopped(const std::filesystem::path& folder)
{
  return simulation::ends_on_any_rank_with(simulation::has_checkpoint(folder)) ? Outcome::unfinished : Outcome::failed;
}

/// Whether a signal asks the run to stop. Throws RunError where a program of the case was kept from what its sandbox does not allow.
bool stopped()
{
  sandbox::throw_if_stopped();
  return interrupted();
}

/// One case after the other, each on all threads; cases of finite elements, which hardly gain by threads, side by side after them.
Outcome run_cases(const std::vector<simulation::RunRequest>& all, const CaseOptions& options)
{
  const auto is_fem = [](const simulation::RunRequest& r) { return r.settings.method == settings::Method::fem; };
  std::vector<simulation::RunRequest> fem;
  std::copy_if(all.begin(), all.end(), std::back_inserter(fem), is_fem);
  const bool side_by_side = fem.size() > 1 && options.jobs() > 1;
  std::optional<io::ScratchFolder> scratch;
  std::optional<MeshCache> meshes;
  if (all.size() > 1) meshes.emplace(scratch.emplace().path());
  {
    simulation::Context context(options.threads, stopped, {}, after_run::answers_and_drawings());
    // A case that does not fit its mesh is refused before the first one runs.
    if (all.size() > 1)
      for (const simulation::RunRequest& request : all) check_buildable(request);
    for (const simulation::RunRequest& request : all)
      if (!(side_by_side && is_fem(request)) && !run_case(request, context)) return outcome_of_stopped(request.folder);
  }
  return side_by_side ? run_side_by_side(fem, options, false) : Outcome::done;
}

/// Says of runs that the user stopped before their bands were made how to go on.
Outcome without_bands(Outcome outcome)
{
  if (interrupted()) io::warn("the bands of the results are not computed: resume with berm run --resume FOLDER --uncertainty");
  return outcome;
}

/// The same with the bands of the results, where they are asked for, once all have run.
Outcome run_all(const std::vector<simulation::RunRequest>& all, const CaseOptions& options)
{
  if (options.uncertainty)
    for (const simulation::RunRequest& request : all) uncertainty::try_to_plan(request);
  Outcome outcome = run_cases(all, options);
  if (!options.uncertainty) return outcome;
  if (outcome != Outcome::done) return without_bands(outcome);
  for (const simulation::RunRequest& request : all) outcome = worse(outcome, uncertainty::find_bands(request, options.jobs()));
  return outcome;
}

/// A run is never lost by a second one into its folder: it is replaced where the user says so. A runner that is not local goes on with what is of the same case.
void refuse_to_overwrite(const std::vector<simulation::RunRequest>& all, const CaseOptions& options, bool both)
{
  if (const std::filesystem::path folder = all.front().folder.parent_path(); both && simulation::has_begun(folder))
    throw InputError(
        fmt::format("{} holds a run: --both writes mpm, fem and report.html there; name another folder with -o", folder.string()));
  const bool handed_over = options.has_runner() && jobs::handed_over(queue_of(all));
  for (const simulation::RunRequest& request : all) {
    if (!simulation::has_begun(request.folder)) continue;
    const jobs::Job same{request.case_file, options.overrides, request.folder};
    if (options.has_runner() && (has_result(same) || goes_on(same) || (handed_over && is_of_case(same)))) continue;
    const io::FolderLock not_in_use(request.folder);  // names another run that writes there
    const std::string folder = request.folder.string();
    if (simulation::can_be_resumed(request.folder))
      throw InputError(fmt::format(
          "{0} holds an unfinished run: continue it with berm run --resume {0}, replace it with --force, or name another folder with -o",
          folder));
    throw InputError(fmt::format("{0} holds the results of a run: replace them with --force, or name another folder with -o", folder));
  }
}

/// With --strict the outcome of runs that are done is that they failed, where the answer of one is invalid. The first rank knows.
Outcome judged(Outcome outcome, const std::vector<std::filesystem::path>& folders, const CaseOptions& options)
{
  if (!options.strict || outcome != Outcome::done) return outcome;
  bool invalid = false;
  for (const std::filesystem::path& folder : folders) {
    const std::optional<run_folder::RunSummary> summary = Ranks::of_run().is_first() ? run_folder::read_summary(folder) : std::nullopt;
    if (!summary || summary->invalid.empty()) continue;
    invalid = true;
    io::tell("berm: {}: the answer is invalid: {}\n", folder.string(), base::invalid_words(summary->invalid));
  }
  return simulation::ends_on_any_rank_with(invalid) ? Outcome::failed : Outcome::done;
}

/// The case by both methods for large deformations, into mpm and fem of its folder.
std::vector<simulation::RunRequest> by_both_methods(const CaseOptions& options)
{
  if (options.files.size() != 1) throw InputError("--both takes one case; several were given");
  const auto by = [&](const char* method, const std::vector<std::string>& settings) {
    CaseOptions one = options;
    one.overrides.insert(one.overrides.end(), settings.begin(), settings.end());
    simulation::RunRequest request = requests(one).front();
    request.folder /= method;
    return request;
  };
  return {by("mpm", {"method=mpm"}), by("fem", {"method=fem", "fem.large_deformation=true"})};
}

/// One page of runs, in the folder that holds theirs.
void write_page(const std::vector<std::filesystem::path>& folders)
{
  report::ReportRequest page;
  for (const std::filesystem::path& folder : folders) page.folders.push_back(folder.string());
  print_report(page);
}

std::vector<std::filesystem::path> folders_of(const std::vector<simulation::RunRequest>& all)
{
  std::vector<std::filesystem::path> folders;
  for (const simulation::RunRequest& request : all) folders.push_back(request.folder);
  return folders;
}

/// Several cases of which one brings a library run side by side, each in a sandbox of its own.
bool go_side_by_side(const std::vector<simulation::RunRequest>& all, const CaseOptions& options)
{
  const bool in_sandboxes = all.size() > 1 && !sandbox::is_trusted() && Ranks::of_run().count() == 1;
  return options.has_runner() || (in_sandboxes && std::any_of(all.begin(), all.end(), brings_libraries));
}

/// That of the run; of several the folders that theirs lie in, where the messages and the queue of those that go side by side lie, too.
std::vector<std::filesystem::path> written_folders(const std::vector<simulation::RunRequest>& all)
{
  if (all.size() == 1) return {all.front().folder};
  std::vector<std::filesystem::path> folders;
  for (const simulation::RunRequest& request : all) folders.push_back(std::filesystem::absolute(request.folder).parent_path());
  return folders;
}

Outcome resume(const std::filesystem::path& folder, const CaseOptions& options)
{
  std::optional<simulation::RunRequest> request = simulation::run_to_resume(folder);
  const bool finished = !request;
  if (finished && !options.overrides.empty())
    throw InputError(fmt::format("--set: the run in {} is finished: only an unfinished one goes on, on a longer mesh", folder.string()));
  if (finished) fmt::print("the run in {} is finished\n", folder.string());
  if (finished && !options.uncertainty) return Outcome::done;
  if (finished) request = simulation::finished_run(folder);
  if (!options.overrides.empty()) request = simulation::on_longer_mesh(*request, options.overrides);
  options.refuse_programs(*request);
  options.enter_sandbox(brings_libraries(*request), {folder});
  if (options.uncertainty) uncertainty::try_to_plan(*request);
  if (!finished) {
    simulation::Context context(options.threads, stopped, {}, after_run::answers_and_drawings());
    if (!run_case(*request, context)) {
      const Outcome outcome = outcome_of_stopped(folder);
      return options.uncertainty ? without_bands(outcome) : outcome;
    }
  }
  return options.uncertainty ? uncertainty::find_bands(*request, options.jobs()) : Outcome::done;
}

}  // namespace

Command add_run(CLI::App& program)
{
  struct Options : CaseOptions {
    std::string unfinished;
    bool both = false;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* app = program.add_subcommand("run", "run cases");
  CLI::Option* cases = options->take_cases(*app)->required(false);
  options->take_threads(*app);
  options->take_runner(*app);
  options->take_no_programs(*app);
  options->take_sandbox(*app);
  app->get_option("--sandbox")->excludes("--runner");
  app->add_option("-o,--output", options->output,
                  "run folder; of several cases: the folder that theirs go into (default: out/FOLDER/NAME of FOLDER/NAME.toml)");
  CLI::Option* force = app->add_flag("--force", options->force, "replace what earlier runs left in the folder");
  app->add_option("--resume", options->unfinished,
                  "continue the run in this folder from its last checkpoint, instead of running a CASE; with --set mesh.near_right=... "
                  "(near_left, left, length) on a longer mesh")
      ->excludes(cases)
      ->excludes("--runner")
      ->excludes("--output")
      ->excludes(force);
  app->add_flag(
         "--both", options->both,
         "run the case by the material point method and by remeshed finite elements (fem.large_deformation), into mpm and fem of its "
         "folder, and write the page of both")
      ->excludes("--runner")
      ->excludes("--resume");
  app->add_flag(
      "--uncertainty", options->uncertainty,
      "also run each case on other cells and at another speed, and give its results at zero cell size with 95 % bands; berm check "
      "estimates the time");
  app->add_flag("--strict", options->strict, "end with status 1 where the answer of a run is invalid, as its summary.json says");
  app->callback([options] {
    if (options->files.empty() && options->unfinished.empty()) throw CLI::RequiredError("CASE or --resume");
  });
  return {app, [options] {
            catch_interrupts();
            options->runner();  // is refused here
            if (Ranks::of_run().count() > 1 && (options->has_runner() || options->uncertainty))
              throw InputError("the ranks of an MPI launcher run one case after the other: without --runner and --uncertainty");
            if (!options->unfinished.empty())
              return status_of(judged(resume(options->unfinished, *options), {options->unfinished}, *options));
            const std::vector<simulation::RunRequest> all = options->both ? by_both_methods(*options) : requests(*options);
            if (!options->force) simulation::on_first_rank([&] { refuse_to_overwrite(all, *options, options->both); });
            for (const simulation::RunRequest& request : all) {
              run_folder::refuse_other_files(request.folder);
              if (brings_libraries(request)) options->refuse_links(request.folder);
            }
            if (!options->both && go_side_by_side(all, *options))
              return status_of(judged(run_side_by_side(all, *options, true), folders_of(all), *options));
            options->enter_sandbox(std::any_of(all.begin(), all.end(), brings_libraries), written_folders(all));
            const auto compare = [&] {
              if (options->both) simulation::on_first_rank([&] { write_page(folders_of(all)); });
            };
            try {
              const Outcome outcome = run_all(all, *options);
              if (outcome == Outcome::done) compare();
              return status_of(judged(outcome, folders_of(all), *options));
            } catch (const RunError&) {
              if (std::ranges::all_of(folders_of(all), simulation::has_begun)) compare();
              throw;
            }
          }};
}

}  // namespace berm::commands
