// SPDX-License-Identifier: BSD-3-Clause
#include "simulation/resume.hpp"

#include "core/error.hpp"
#include "io/atomic_file.hpp"
#include "run_folder/summary_file.hpp"
#include "simulation/checkpoints.hpp"
#include "simulation/results.hpp"
#include "structures/structures.hpp"

#include <fmt/format.h>

namespace berm::simulation {
namespace {

namespace fs = std::filesystem;

fs::path note_of_case(const fs::path& run_folder)
{
  return checkpoints_in(run_folder) / "case_file.txt";
}

bool is_finished(const fs::path& folder)
{
  try {
    const std::optional<run_folder::RunSummary> summary = run_folder::read_summary(folder);
    return summary && summary->finished();
  } catch (const RunError& error) {
    throw RunError(
        fmt::format("--resume: {}; it is not known whether the run is finished: remove that file to start it again", error.what()));
  }
}

}  // namespace

void note_case_file(const run_folder::RunFolder& folder, const fs::path& case_file)
{
  folder.subfolder(checkpoints_in("").string());
  io::write_atomically(note_of_case(folder.path()), fs::absolute(case_file).string());
}

std::optional<RunRequest> run_to_resume(const fs::path& folder)
{
  const auto must_hold = [&](const fs::path& file) {
    if (std::error_code error; !fs::exists(file, error))
      throw InputError(fmt::format("--resume: {} is not the folder of a run that has begun: there is no {}", folder.string(),
                                   file.lexically_relative(folder).string()));
  };
  for (const char* name : {"resolved.toml", "case.toml"}) must_hold(folder / name);
  // A finished run removes its checkpoints last of all.
  if (!fs::exists(note_of_case(folder)) && is_finished(folder)) return std::nullopt;
  must_hold(note_of_case(folder));
  const std::string noted = io::read_text_file(note_of_case(folder));
  auto [settings, places] = structures::read_case(folder / "resolved.toml");
  return RunRequest{std::move(settings), noted.empty() ? folder / "case.toml" : fs::path(noted), folder, true, std::move(places)};
}

RunRequest finished_run(const fs::path& folder)
{
  auto [settings, places] = structures::read_case(folder / "resolved.toml");
  return {std::move(settings), folder / "case.toml", folder, false, std::move(places)};
}

bool has_begun(const fs::path& folder)
{
  std::error_code error;
  return fs::exists(folder / "resolved.toml", error) && fs::exists(folder / "case.toml", error) &&
         (fs::exists(note_of_case(folder), error) || fs::exists(folder / "summary.json", error));
}

bool can_be_resumed(const fs::path& folder)
{
  std::error_code error;
  return fs::exists(note_of_case(folder), error);
}

bool has_checkpoint(const fs::path& folder)
{
  return !checkpoint::CheckpointFolder(checkpoints_in(folder)).files().empty();
}

std::string key_results_in(const RunRequest& request)
{
  record::RunRecord run;
  run.settings = request.settings;
  run.summary = run_folder::read_summary(request.folder);
  if (run.summary) run.quantities = run.summary->quantities;
  const std::string table = run.summary ? structures::structure_of(request.settings).table_of(run) : "";
  return table.empty() ? "" : fmt::format("{}: {}", request.folder.string(), key_results(table, run.summary->spoiled));
}

}  // namespace berm::simulation
