// SPDX-License-Identifier: BSD-3-Clause
#include "commands/case_options.hpp"
#include "commands/command.hpp"
#include "commands/side_by_side.hpp"
#include "core/interrupt.hpp"
#include "core/threads.hpp"
#include "simulation/resume.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::commands {
namespace {

/// One case after the other, each on all threads; cases of finite elements, which hardly gain by threads, side by side behind them.
int run_all(const std::vector<simulation::RunRequest>& all, const std::vector<std::string>& overrides)
{
  const int threads = all.front().threads;
  catch_interrupts();
  // A case that does not fit its mesh is refused before the first one runs.
  if (all.size() > 1)
    for (const simulation::RunRequest& request : all) try_to_build(request);
  std::vector<simulation::RunRequest> fem;
  std::copy_if(all.begin(), all.end(), std::back_inserter(fem),
               [](const simulation::RunRequest& r) { return r.settings.method == problem::Method::fem; });
  const bool side_by_side = fem.size() > 1 && threads > 1;
  for (const simulation::RunRequest& request : all) {
    if (side_by_side && request.settings.method == problem::Method::fem) continue;
    if (!run_case(request)) return 1;
  }
  return !side_by_side || run_side_by_side(fem, overrides, threads) ? 0 : 1;
}

int resume(const std::filesystem::path& folder, int threads)
{
  const std::optional<simulation::RunRequest> request = simulation::run_to_resume(folder, threads);
  if (!request) return fmt::print("the run in {} is finished\n", folder.string()), 0;
  catch_interrupts();
  return run_case(*request) ? 0 : 1;
}

}  // namespace

Command add_run(CLI::App& program)
{
  struct Options : CaseOptions {
    std::string unfinished;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* app = program.add_subcommand("run", "run cases");
  CLI::Option* cases = options->take_cases(*app)->required(false);
  options->take_threads(*app);
  app->add_option("-o,--output", options->output, "run folder; of several cases: the folder that theirs go into (default: out/)");
  app->add_option("--resume", options->unfinished, "continue the run in this folder from its last checkpoint, instead of running a CASE")
      ->excludes(cases)
      ->excludes("--set")
      ->excludes("--output");
  app->callback([options] {
    if (options->files.empty() && options->unfinished.empty()) throw CLI::RequiredError("CASE or --resume");
  });
  return {app, [options] {
            if (!options->unfinished.empty()) return resume(options->unfinished, use_threads(options->threads));
            return run_all(requests(*options), options->overrides);
          }};
}

}  // namespace berm::commands
