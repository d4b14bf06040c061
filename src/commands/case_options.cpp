// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/run_test.cpp
#include "commands/case_options.hpp"
#include "commands/option_values.hpp"

#include "core/ranks.hpp"
#include "input/read_case.hpp"
#include "os/error.hpp"
#include "os/threads.hpp"
#include "sandbox/sandbox.hpp"
#include "user_law/load.hpp"

#include <algorithm>
#include <cstdlib>
#include <fmt/format.h>
#include <iostream>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

namespace berm::commands {

namespace fs = std::filesystem;

namespace {

/// What a case names that is a program: the key, and what stands there.
std::vector<std::pair<std::string, const char*>> programs_of(const settings::Case& settings)
{
  std::vector<std::pair<std::string, const char*>> found;
  if (const auto* mesh = std::get_if<mesh::GmshFile>(&settings.mesh); mesh != nullptr && fs::path(mesh->file).extension() == ".geo")
    found.emplace_back("mesh.file", "a geometry that gmsh runs");
  for (const auto& soil : settings.material)
    if (user_law::names_library({soil})) found.emplace_back(fmt::format("material.{}.library", soil.first), "a library with a law");
  return found;
}

/// One byte more than a case may have tells that it has too many.
std::string text_of_stdin()
{
  std::string text(input::max_case_bytes + 1, '\0');
  std::cin.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(std::cin.gcount()));
  return text;
}

}  // namespace

CLI::Option* CaseOptions::take_cases(CLI::App& command)
{
  command
      .add_option("--set", overrides, "set a parameter: material.sand.friction_angle=\"40 deg\"; stages by their names; * for every name")
      ->take_all()
      ->allow_extra_args(false);
  return command.add_option("CASE", files, "case files (TOML)")->required();
}

void CaseOptions::take_stdin(CLI::App& command)
{
  command.add_flag("--stdin", text_from_stdin, "take the text of the one CASE from the standard input, as if it lay in that file");
}

void CaseOptions::take_threads(CLI::App& command)
{
  command.add_option("--threads", threads, "threads to use (default: OMP_NUM_THREADS, else all processors)")
      ->check(whole_number_within(1, 1024));
}

void CaseOptions::take_jobs(CLI::App& command)
{
  command.add_option("--threads", threads, "runs at a time, each on one thread (default: all processors)")
      ->check(whole_number_within(1, 1024));
}

int CaseOptions::jobs() const
{
  return threads > 0 ? threads : processor_count();
}

void CaseOptions::take_no_programs(CLI::App& command)
{
  command.add_flag("--no-programs", no_programs,
                   "refuse a case that brings programs: a geometry (.geo) that gmsh runs, a library with a law");
}

void CaseOptions::refuse_programs(const simulation::RunRequest& request) const
{
  if (!no_programs) return;
  for (const auto& [key, what] : programs_of(request.settings))
    throw input::LocatedError(request.places.located(key, fmt::format("names {}, a program, and --no-programs allows none", what)));
}

void CaseOptions::take_sandbox(CLI::App& command)
{
  CLI::Option* with =
      command.add_flag("--sandbox", sandbox,
                       "prevent writing outside the run folder, opening sockets and starting programs: the default where a case "
                       "brings a library; an error where the system has no sandbox");
  command
      .add_flag_callback(
          "--no-sandbox", [] { ::setenv(sandbox::trust_variable, "1", 1); },
          "give a geometry (.geo) or a library all of your rights; so does BERM_NO_SANDBOX=1 in the environment, for studies too")
      ->excludes(with);
}

void CaseOptions::enter_sandbox(bool brings_libraries, const std::vector<fs::path>& folders) const
{
  if (!sandbox && (!brings_libraries || sandbox::is_trusted())) return;
  const std::string why = Ranks::of_run().count() > 1 ? "ranks talk by sockets" : sandbox::why_there_is_none();
  if (why.empty()) return sandbox::enter(folders);  // what goes wrong there is an error: a case may have brought it about
  if (sandbox) throw RunError(fmt::format("--sandbox: there is none here: {}", why));
  sandbox::do_without(why);
}

void CaseOptions::refuse_links(const fs::path& folder) const
{
  if (!output.empty() || sandbox::is_trusted()) return;
  std::error_code error;
  for (fs::path part = folder; !part.empty() && part != part.root_path(); part = part.parent_path())
    if (fs::is_symlink(fs::symlink_status(part, error)))
      throw InputError(fmt::format(
          "{} is a link, and the case brings a library, which writes below its run folder: name the folder with -o", part.string()));
}

void CaseOptions::take_runner(CLI::App& command)
{
  command.add_option(
      "--runner", runner_words,
      "how the cases run: slurm, or a command with {jobs}, the file with one command per line (default: processes on this machine)");
  command.add_option("--sbatch", sbatch, "options for sbatch: \"--partition=long --time=8:00:00\"");
  command.add_option("--pack", pack, "number of runs per Slurm task (default: 1)")->check(whole_number_within(1, 1000000));
  command.add_flag("--no-wait", no_wait, "submit the runs and exit; the same command collects their results later");
}

jobs::Runner CaseOptions::runner() const
{
  jobs::Runner runner{jobs::LocalProcesses{jobs()}, !no_wait};
  if (runner_words == "slurm")
    runner.by = jobs::Slurm{sbatch, std::max(pack, 1), threads};
  else if (!runner_words.empty())
    runner.by = jobs::ShellCommand{runner_words};
  if (runner_words != "slurm" && (!sbatch.empty() || pack > 0))
    throw InputError(fmt::format("{} goes with --runner slurm", sbatch.empty() ? "--pack" : "--sbatch"));
  check_runner(runner);
  return runner;
}

fs::path default_folder(const fs::path& file)
{
  const fs::path folder = file.lexically_normal().parent_path().filename();
  const bool named = !folder.empty() && folder != "." && folder != "..";
  return named ? fs::path("out") / folder / file.stem() : fs::path("out") / file.stem();
}

std::vector<simulation::RunRequest> requests(const CaseOptions& options)
{
  if (options.text_from_stdin && options.files.size() > 1) throw InputError("--stdin gives the text of one case, and several are named");
  std::vector<simulation::RunRequest> all;
  for (const std::string& file : options.files) {
    const fs::path name = fs::path(file).stem();
    const fs::path output = fs::path(options.output) / "";  // whether a slash ends it or not
    const fs::path folder = options.output.empty()      ? default_folder(file)
                            : options.files.size() == 1 ? output.parent_path()
                                                        : output / name;
    for (const simulation::RunRequest& other : all)
      if (other.folder == folder)
        throw InputError(fmt::format("{} and {} would both be written to {}", other.case_file.string(), file, folder.string()));
    input::Document document = options.text_from_stdin ? input::parse_text(file, text_of_stdin()) : input::parse_file(file);
    auto [settings, places] = input::case_of(std::move(document), options.overrides);
    all.push_back({std::move(settings), file, folder, false, std::move(places), {}, options.overrides});
    options.refuse_programs(all.back());
  }
  return all;
}

bool brings_programs(const simulation::RunRequest& request)
{
  return !programs_of(request.settings).empty();
}

bool brings_libraries(const simulation::RunRequest& request)
{
  return user_law::names_library(request.settings.material);
}

void messages_to_stderr()
{
  spdlog::set_default_logger(spdlog::stderr_color_st("berm"));
  spdlog::set_pattern("%l: %v");
}

}  // namespace berm::commands
