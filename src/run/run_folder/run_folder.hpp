// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/folder_lock.hpp"

#include <functional>
#include <memory>
#include <string_view>

namespace berm::run_folder {

/// The folder that a run writes into, and nobody else while this lives. Its resolved.toml says that it holds a run, which can be resumed.
class RunFolder {
public:
  /// Makes the folder and its parents. In the folder of an earlier run all that berm wrote is removed, and nothing else.
  /// Throws RunError where the path is not a folder, cannot be written to, is written to by another process, or holds
  /// something and is not one of a run.
  explicit RunFolder(const std::filesystem::path& path);
  /// The folder of a resumed run: nothing is removed. Throws RunError where it is not the folder of a run or cannot be written to.
  static RunFolder of_earlier_run(const std::filesystem::path& path);

  /// Has give(FOLDER) make what the run is given, resolved.toml among it, in a folder inside, and moves it from there, resolved.toml first: before this the
  /// folder holds no run, from there on one that has begun.
  void begin(const std::function<void(const std::filesystem::path&)>& give) const;
  /// The same of a run that goes on: has give(FOLDER) make the files that replace those of their names. Where the program ends while they are moved, finish_start() moves the rest.
  void change(const std::function<void(const std::filesystem::path&)>& give) const;

  const std::filesystem::path& path() const { return path_; }
  /// The path of a file in the folder, "history.csv" or "frames/mesh.vtu".
  std::filesystem::path file(std::string_view name) const { return path_ / name; }
  /// Makes a folder inside (no error where it is there) and gives its path.
  std::filesystem::path subfolder(std::string_view name) const;

private:
  struct AsItIs {};
  RunFolder(const std::filesystem::path& path, AsItIs) : path_(path), lock_(std::make_unique<io::FolderLock>(path)) {}

  std::filesystem::path path_;
  std::unique_ptr<io::FolderLock> lock_;
};

/// Throws RunError where the path is not a folder, or one that holds something and is not one of a run. Makes nothing.
void refuse_other_files(const std::filesystem::path& path);

/// Moves what a process that was killed in begin() or change() left of it, and removes what was not complete. Throws RunError where another process writes into the folder.
void finish_start(const std::filesystem::path& run_folder);

}  // namespace berm::run_folder
