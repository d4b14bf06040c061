// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/run_test.cpp
#include "commands/case_options.hpp"

#include "core/error.hpp"
#include "core/threads.hpp"
#include "input/read_case.hpp"

#include <fmt/format.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

namespace berm::commands {

namespace fs = std::filesystem;

CLI::Option* CaseOptions::take_cases(CLI::App& command)
{
  command
      .add_option("--set", overrides, "set a parameter: material.sand.friction_angle=\"40 deg\"; stages by their names; * for every name")
      ->take_all()
      ->allow_extra_args(false);
  return command.add_option("CASE", files, "case files (TOML)")->required();
}

void CaseOptions::take_threads(CLI::App& command)
{
  command.add_option("--threads", threads, "threads to use (default: all processors)")->check(CLI::Range(1, 1024));
}

void CaseOptions::take_jobs(CLI::App& command)
{
  command.add_option("--threads", threads, "runs at a time, each on one thread (default: all processors)")->check(CLI::Range(1, 1024));
}

int CaseOptions::jobs() const
{
  return threads > 0 ? threads : processor_count();
}

fs::path default_folder(const fs::path& file)
{
  const fs::path folder = file.lexically_normal().parent_path().filename();
  const bool named = !folder.empty() && folder != "." && folder != "..";
  return named ? fs::path("out") / folder / file.stem() : fs::path("out") / file.stem();
}

std::vector<simulation::RunRequest> requests(const CaseOptions& options)
{
  std::vector<simulation::RunRequest> all;
  for (const std::string& file : options.files) {
    const fs::path name = fs::path(file).stem();
    const fs::path folder = options.output.empty()      ? default_folder(file)
                            : options.files.size() == 1 ? fs::path(options.output)
                                                        : fs::path(options.output) / name;
    for (const simulation::RunRequest& other : all)
      if (other.folder == folder)
        throw InputError(fmt::format("{} and {} would both be written to {}", other.case_file.string(), file, folder.string()));
    auto [settings, places] = input::read_case_in_file(file, options.overrides);
    all.push_back({std::move(settings), file, folder, false, std::move(places)});
  }
  return all;
}

void messages_to_stderr()
{
  spdlog::set_default_logger(spdlog::stderr_color_st("berm"));
  spdlog::set_pattern("%l: %v");
}

}  // namespace berm::commands
