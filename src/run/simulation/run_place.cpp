// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/run_faults_test.cpp
#include "simulation/run_place.hpp"

#include "core/ranks.hpp"
#include "input/read_case.hpp"
#include "input/write_case.hpp"
#include "io/atomic_file.hpp"
#include "io/log.hpp"
#include "io/sha256.hpp"
#include "os/control_characters.hpp"
#include "os/error.hpp"
#include "os/text_of_list.hpp"
#include "run_folder/origin.hpp"
#include "run_folder/summary_file.hpp"
#include "settings/safety.hpp"
#include "simulation/checkpoints.hpp"
#include "simulation/good_sense.hpp"
#include "simulation/run_of_ranks.hpp"
#include "user_law/load.hpp"

#include <fmt/format.h>

namespace berm::simulation {
namespace {

namespace fs = std::filesystem;

/// Whole path and SHA-256 of the files that the case names, and what tells whether it was changed.
run_folder::FileHashes named_files(const RunRequest& request)
{
  run_folder::FileHashes files = user_law::library_hashes(request.settings);
  files.emplace_back(run_folder::without_report_entry, io::sha256_of(input::without_report(input::resolved_toml(request.settings))));
  const auto add = [&](const fs::path& file) {
    const fs::path whole = fs::absolute(file).lexically_normal();
    files.emplace_back(whole.string(), io::sha256_of_file(whole));
  };
  if (const auto* mesh = std::get_if<mesh::GmshFile>(&request.settings.mesh)) add(request.case_file.parent_path() / mesh->file);
  for (const auto& entry : request.settings.rigid)
    if (const auto* surface = std::get_if<bodies::TriangulatedSettings>(&entry.second.shape)) add(surface->file);
  return files;
}

/// The case file that the run in the folder is of, for summary.json of a resumed run.
fs::path note_of_case(const fs::path& run_folder)
{
  return checkpoints_in(run_folder) / "case_file.txt";
}

/// Makes in a folder what a run is given.
void give(const fs::path& folder, const RunRequest& request, const io::ScratchFolder& scratch, const std::vector<std::string>& warnings)
{
  io::write_atomically(folder / "resolved.toml", input::resolved_toml(request.settings));
  scratch.move_files_to(folder);
  io::copy_atomically(request.case_file, folder / "case.toml");
  std::error_code error;
  if (const fs::path expected = request.case_file.parent_path() / "expected.toml"; fs::exists(expected, error))
    io::copy_atomically(expected, folder / "expected.toml");
  run_folder::note_origin(folder, request.case_file.filename().string(), request.set, named_files(request));
  io::make_folder(checkpoints_in(folder));
  note_warnings(folder, warnings);
  io::write_atomically(note_of_case(folder), fs::absolute(request.case_file).string());
}

/// That of ranks whose messages nobody sees is not the one of the request.
run_folder::RunFolder folder_of(const RunRequest& request, const io::ScratchFolder& scratch, const std::vector<std::string>& warnings)
{
  if (!Ranks::of_run().is_first()) return run_folder::RunFolder(scratch.path() / "run");
  if (request.resume) return run_folder::RunFolder::of_earlier_run(request.folder);
  run_folder::RunFolder folder(request.folder);
  folder.begin([&](const fs::path& start) { give(start, request, scratch, warnings); });
  return folder;
}

}  // namespace

settings::Case case_to_run(const RunRequest& request)
{
  settings::Case settings = settings::with_reduced_strength(request.settings);
  const fs::path mesh = fs::absolute(request.folder / "mesh.msh");
  const bool from_file = std::holds_alternative<mesh::GmshFile>(settings.mesh);
  const bool made =
      std::holds_alternative<mesh::SeabedMesh>(settings.mesh) && settings.method == settings::Method::mpm && settings.dimension() == 2;
  std::error_code error;
  if (request.resume && !request.shorter && (from_file || made) && fs::exists(mesh, error)) {
    mesh::GmshFile file = from_file ? std::get<mesh::GmshFile>(settings.mesh) : mesh::GmshFile{};
    file.file = mesh.string();
    if (made) file.made_from = std::get<mesh::SeabedMesh>(settings.mesh);
    settings.mesh = file;
  }
  return settings;
}

RunPlace::RunPlace(const RunRequest& request, const Context& context, const io::ScratchFolder& scratch, const std::string& size,
                   const std::vector<std::string>& warnings)
    : replaces_(!request.resume && !run_folder::CheckpointFolder(checkpoints_in(request.folder)).files().empty()),
      folder_(folder_of(request, scratch, warnings)),
      log_(folder_.file("run.log"), request.resume, context.messages())
{
  if (!Ranks::of_run().is_first()) return;
  if (replaces_) io::info("the unfinished run in {} is replaced; `berm run --resume` resumes one instead", request.folder.string());
  io::info("{}", one_line(fmt::format("{} -> {}: {}", request.case_file.string(), folder_.path().string(), size)));
  if (request.resume) run_folder::note_resumption(folder_.path());
  if (!request.resume || request.shorter)
    for (const std::string& warning : warnings) io::warn("{}", warning);
}

void RunPlace::lengthen(const RunRequest& request, const io::ScratchFolder& scratch, const std::vector<std::string>& warnings,
                        const std::function<void(const fs::path&)>& keep)
{
  folder_.change([&](const fs::path& change) {
    io::write_atomically(change / "resolved.toml", input::resolved_toml(request.settings));
    scratch.move_files_to(change);
    run_folder::note_change(folder_.path(), change, request.set, named_files(request));
    io::make_folder(checkpoints_in(change));
    note_warnings(change, warnings);
    keep(change);
  });
  io::info("the mesh is longer now: {}", text_of_list(request.set, ", "));
}

namespace {

namespace fs = std::filesystem;

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

std::optional<RunRequest> run_to_resume(const fs::path& folder)
{
  const auto must_hold = [&](const fs::path& file) {
    if (std::error_code error; !fs::exists(file, error))
      throw InputError(
          fmt::format("--resume: {0} is not the folder of a run that has begun: there is no {1}; begin it with berm run CASE -o {0}",
                      folder.string(), file.lexically_relative(folder).string()));
  };
  on_first_rank([&] { run_folder::finish_start(folder); });
  for (const char* name : {"resolved.toml", "case.toml"}) must_hold(folder / name);
  // A finished run removes its checkpoints last of all.
  if (!fs::exists(note_of_case(folder)) && is_finished(folder)) return std::nullopt;
  must_hold(note_of_case(folder));
  const std::string noted = io::read_text_file(note_of_case(folder));
  auto [settings, places] = input::case_of(folder / "resolved.toml");
  return RunRequest{std::move(settings), noted.empty() ? folder / "case.toml" : fs::path(noted), folder, true, std::move(places)};
}

RunRequest finished_run(const fs::path& folder)
{
  auto [settings, places] = input::case_of(folder / "resolved.toml");
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
  return !run_folder::CheckpointFolder(checkpoints_in(folder)).files().empty();
}

}  // namespace berm::simulation
