// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace berm::run_folder {

/// SHA-256 of files, by their names.
using FileHashes = std::vector<std::pair<std::string, std::string>>;

/// Under this name stands the hash of resolved.toml up to its table [report], which may be changed after the run.
constexpr const char* without_report_entry = "resolved.toml before [report]";

/// A program that computed a run, or a part of it.
struct RunSession {
  std::string begun;  ///< date and time (UTC, ISO 8601)
  std::string version, build;
  FileHashes program;
  bool resumption = false;  ///< of a run that was begun before
};

/// Where a run comes from: what it read, and the programs that computed it. A resumed run has a session more. Where the first is a resumption, what the run
/// was begun with is not known: an earlier version began it, or its origin.json was damaged.
struct Origin {
  FileHashes input;
  std::vector<RunSession> sessions;
  std::string case_file{};         ///< its name; "" in a run of an earlier version
  std::vector<std::string> set{};  ///< what was changed in it, each KEY=VALUE
  bool lengthened = false;         ///< the last of that was a longer mesh, on which the run was resumed: particles were divided and added

  /// Whether the session is known that began the run.
  bool begins() const { return !sessions.empty() && !sessions.front().resumption; }
};

/// The present program, now.
RunSession this_session();

/// Notes in origin.json what the run in the folder is made from: the name of the case file and what was changed in it, SHA-256 of its case.toml, resolved.toml, mesh.msh
/// and expected.toml as they are there, of the files that the case names (by their whole paths: mesh, surfaces, libraries with laws), and this session; of a resumed
/// run only another session, also where its origin.json is missing or damaged. Throws RunError where it cannot be written.
void note_origin(const std::filesystem::path& run_folder, const std::string& case_file, const std::vector<std::string>& set,
                 const FileHashes& named = {});
void note_resumption(const std::filesystem::path& run_folder);
/// Notes for a run that goes on with other files what was changed in its case, and the files that there are in `changed`, into which origin.json goes.
void note_change(const std::filesystem::path& run_folder, const std::filesystem::path& changed, const std::vector<std::string>& set,
                 const FileHashes& named);

/// What origin.json of a run says; empty where it is not there (a run of an earlier version). Throws RunError where it is damaged.
std::optional<Origin> read_origin(const std::filesystem::path& run_folder);

/// Whether the files that its case names hold what they held when the run in the folder began; false where origin.json does not tell.
bool named_files_are_the_same(const std::filesystem::path& run_folder);

}  // namespace berm::run_folder
