// SPDX-License-Identifier: BSD-3-Clause
#include "run/resume.hpp"

#include "core/error.hpp"
#include "input/read_case.hpp"
#include "output/whole_file.hpp"
#include "run/checkpoints.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace berm {
namespace {

namespace fs = std::filesystem;

fs::path note_in(const fs::path& run_folder)
{
  return checkpoints_in(run_folder) / "case_file.txt";
}

bool is_finished(const fs::path& folder)
{
  const nlohmann::json summary = nlohmann::json::parse(read_whole(folder / "summary.json"), nullptr, false);
  return !summary.is_discarded() && summary.value("/checks/finished"_json_pointer, false);
}

}  // namespace

void note_case_file(const RunFolder& folder, const fs::path& case_file)
{
  folder.subfolder(checkpoints_in("").string());
  write_whole(note_in(folder.path()), fs::absolute(case_file).string());
}

std::optional<RunRequest> run_to_go_on_with(const fs::path& folder, int threads)
{
  for (const char* name : {"resolved.toml", "case.toml"})
    if (std::error_code error; !fs::exists(folder / name, error))
      throw InputError(fmt::format("--resume: {} is not the folder of a run that has begun: there is no {}", folder.string(), name));
  // A finished run removes its checkpoints last of all.
  if (is_finished(folder) && !fs::exists(checkpoints_in(folder))) return std::nullopt;
  const std::string noted = read_whole(note_in(folder));
  return RunRequest{read_case(folder / "resolved.toml"), noted.empty() ? folder / "case.toml" : fs::path(noted), folder, threads, true};
}

}  // namespace berm
