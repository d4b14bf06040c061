// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/study/study_test.cpp
#include "study/study.hpp"

#include "commands/case_options.hpp"
#include "commands/command.hpp"
#include "os/error.hpp"
#include "os/interrupt.hpp"

#include <fmt/format.h>

namespace berm::commands {
namespace {

namespace fs = std::filesystem;

/// All studies are read before the first one runs. One study goes to `output` itself, several to folders in it that are named like their folders, or
/// like their files where these are not study.toml.
jobs::Outcome study_all(const std::vector<std::string>& studies, const std::string& output, const jobs::Runner& runner)
{
  std::vector<std::pair<study::StudyPlan, fs::path>> plans;
  for (const std::string& study : studies) {
    const fs::path file = fs::is_directory(study) ? fs::path(study) / "study.toml" : fs::path(study),
                   whole = fs::absolute(file).lexically_normal();
    const fs::path name = file.filename() == "study.toml" ? whole.parent_path().filename() : file.stem();
    const fs::path folder = output.empty()        ? fs::path("out/study") / name
                            : studies.size() == 1 ? fs::path(output)
                                                  : fs::path(output) / name;
    for (const auto& other : plans)
      if (other.second == folder) throw InputError(fmt::format("{} and another study would both be written to {}", study, folder.string()));
    plans.emplace_back(study::plan_study(file, folder), folder);
  }
  jobs::Outcome outcome = jobs::Outcome::done;
  for (auto& [plan, folder] : plans) {
    const jobs::Outcome of_plan = run_study(plan, folder, runner);
    if (of_plan == jobs::Outcome::unfinished) return of_plan;
    outcome = worse(outcome, of_plan);
  }
  return outcome;
}

}  // namespace

Command add_study(CLI::App& program)
{
  const auto options = std::make_shared<CaseOptions>();
  CLI::App* app = program.add_subcommand("study", "run a matrix of cases and make a table and figures of the results");
  app->add_option("STUDY", options->files, "study files, or folders that hold a study.toml")->required();
  app->add_option("-o,--output", options->output,
                  "folder for the results; of several studies: the folder that theirs go into (default: out/study)");
  options->take_jobs(*app);
  options->take_runner(*app);
  return {app, [options] {
            catch_interrupts();
            messages_to_stderr();
            return status_of(study_all(options->files, options->output, options->runner()));
          }};
}

}  // namespace berm::commands
