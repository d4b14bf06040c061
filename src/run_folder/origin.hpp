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

/// A program that computed a run, or a part of it.
struct RunSession {
  std::string begun;  ///< date and time (UTC, ISO 8601)
  std::string version, build;
  FileHashes program;
};

/// Where a run comes from: what it read, and the programs that computed it. A resumed run has a session more.
struct Origin {
  FileHashes input;
  std::vector<RunSession> sessions;
};

/// The present program, now.
RunSession this_session();

/// Notes in origin.json what the run in the folder is made from: SHA-256 of its case.toml, resolved.toml, mesh.msh and claims.toml as they are there, and this
/// session; of a resumed run only another session. Throws RunError.
void note_origin(const std::filesystem::path& run_folder);
void note_resumption(const std::filesystem::path& run_folder);

/// What origin.json of a run says; empty where it is not there (a run of an earlier version). Throws RunError where it is damaged.
std::optional<Origin> read_origin(const std::filesystem::path& run_folder);

}  // namespace berm::run_folder
