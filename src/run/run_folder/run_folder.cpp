// SPDX-License-Identifier: BSD-3-Clause
#include "run_folder/run_folder.hpp"

#include "io/atomic_file.hpp"
#include "os/error.hpp"

#include <algorithm>
#include <cstdio>
#include <fmt/format.h>
#include <set>
#include <unistd.h>
#include <vector>

namespace berm::run_folder {
namespace {

namespace fs = std::filesystem;

constexpr const char* resolved = "resolved.toml";

/// The folder that is there while a run begins. Like resolved.toml it says whose folder this is, so that a removal that was cut short is repeated.
fs::path start_in(const fs::path& run_folder)
{
  return io::part_of(run_folder / "start");
}

/// That in which a change of what the run goes on with is made.
fs::path change_in(const fs::path& run_folder)
{
  return io::part_of(run_folder / "change");
}

// All that a run writes but resolved.toml and its pictures of the soil.
constexpr const char* own_files[] = {
    "history.csv",     "history.schema.json", "summary.json",       "origin.json",        "run.log",
    "case.toml",       "expected.toml",       "mesh.geo",           "mesh.msh",           "mesh.log",
    "ground.csv",      "report.html",         "report.pdf",         "curves.png",         "plots/curves.dat",
    "plots/curves.gp", "plots/band_V_w.dat",  "plots/band_H_u.dat", "plots/band_w_u.dat", "frames",
    "uncertainty",     "checkpoint",          "curves.json",        "claims.toml"};  // claims.toml: of earlier versions

/// Removes the pictures of the soil with their scripts and data: soil, soil_increment, and one for each field that the method or the law has for itself.
void remove_soil_pictures(const fs::path& folder)
{
  std::vector<fs::path> own;
  const auto collect = [&](const fs::path& place, const std::set<std::string>& endings) {
    if (!fs::is_directory(place)) return;
    for (const fs::directory_entry& entry : fs::directory_iterator(place)) {
      const std::string name = entry.path().stem().string();
      if ((name == "soil" || name.starts_with("soil_")) && endings.contains(entry.path().extension().string())) own.push_back(entry.path());
    }
  };
  collect(folder, {".png"});
  collect(folder / "plots", {".gp", ".dat", ".bin"});
  for (const fs::path& file : own) fs::remove(file);
}

/// Whether anything is in the folder but the lock of a run that was ended by force.
bool holds_files(const fs::path& folder)
{
  return std::any_of(fs::directory_iterator(folder), fs::directory_iterator(),
                     [](const fs::directory_entry& entry) { return entry.path().filename() != io::FolderLock::file_name; });
}

/// resolved.toml goes first: what is left then is no run.
void remove_run(const fs::path& folder)
{
  io::make_inner_folder(folder, start_in(folder).filename());
  fs::remove(folder / resolved);
  remove_soil_pictures(folder);
  for (const char* name : own_files) fs::remove_all(folder / name);
  fs::remove_all(change_in(folder));
  for (const fs::directory_entry& entry : fs::directory_iterator(start_in(folder))) fs::remove_all(entry.path());
}

void move(const fs::path& from, const fs::path& to)
{
  if (::rename(from.c_str(), to.c_str()) != 0) io::throw_errno(fmt::format("cannot write {}", to.string()));
}

/// Forces the names in a folder and in its inner ones to the disk.
void sync_names(const fs::path& folder, const fs::path& as_in)
{
  for (const fs::directory_entry& entry : fs::directory_iterator(as_in))
    if (entry.is_directory()) io::sync_file(folder / entry.path().filename());
  io::sync_file(folder);
}

void move_start(const fs::path& folder)
{
  const fs::path start = start_in(folder);
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(start)) {
    const fs::path to = folder / entry.path().lexically_relative(start);
    if (entry.is_directory())
      io::make_inner_folder(to.parent_path(), to.filename());
    else
      files.push_back(to);
  }
  for (const fs::path& file : files) move(start / file.lexically_relative(folder), file);
  sync_names(folder, start);
  fs::remove_all(start);
}

[[noreturn]] void refuse(const fs::path& path, const std::string& reason)
{
  throw RunError(fmt::format("cannot use {} as the run folder: {}", path.string(), reason));
}

bool is_of_a_run(const fs::path& path)
{
  return fs::exists(path / resolved) || fs::exists(start_in(path));
}

}  // namespace

void refuse_other_files(const fs::path& path)
{
  try {
    if (!fs::exists(path)) return;
    if (!fs::is_directory(path)) refuse(path, "it is not a folder");
    if (!is_of_a_run(path) && holds_files(path))
      refuse(path, "it holds files that are not of a run (there is no resolved.toml); name another folder with -o");
  } catch (const fs::filesystem_error& error) {
    refuse(path, error.code().message());
  }
}

RunFolder::RunFolder(const fs::path& path) : path_(path)
{
  refuse_other_files(path);
  try {
    fs::create_directories(path);
    if (::access(path.c_str(), W_OK | X_OK) != 0) io::throw_errno(fmt::format("cannot use {} as the run folder", path.string()));
    lock_ = std::make_unique<io::FolderLock>(path);
    if (is_of_a_run(path)) remove_run(path);
  } catch (const fs::filesystem_error& error) {
    refuse(path, error.code().message());
  }
}

RunFolder RunFolder::of_earlier_run(const fs::path& path)
{
  std::error_code error;
  if (!fs::exists(path / resolved, error)) refuse(path, "it is not the folder of a run (there is no resolved.toml)");
  if (::access(path.c_str(), W_OK | X_OK) != 0) io::throw_errno(fmt::format("cannot use {} as the run folder", path.string()));
  return {path, AsItIs{}};
}

void RunFolder::begin(const std::function<void(const fs::path&)>& give) const
{
  const fs::path start = io::make_inner_folder(path_, start_in(path_).filename());
  try {
    give(start);
    sync_names(start, start);
    move(start / resolved, path_ / resolved);
  } catch (...) {
    std::error_code ignored;
    if (!fs::exists(path_ / resolved, ignored)) fs::remove_all(start, ignored);
    throw;
  }
  move_start(path_);
}

void RunFolder::change(const std::function<void(const fs::path&)>& give) const
{
  const fs::path change = change_in(path_);
  std::error_code ignored;
  try {
    give(io::make_inner_folder(path_, change.filename()));
    sync_names(change, change);
    move(change, start_in(path_));
  } catch (...) {
    fs::remove_all(change, ignored);
    throw;
  }
  move_start(path_);
}

void finish_start(const fs::path& run_folder)
{
  std::error_code error;
  const bool begun = fs::exists(start_in(run_folder), error), cut_short = fs::exists(change_in(run_folder), error);
  if (!fs::exists(run_folder / resolved, error) || !(begun || cut_short)) return;
  const io::FolderLock lock(run_folder);
  fs::remove_all(change_in(run_folder), error);
  if (begun) move_start(run_folder);
}

fs::path RunFolder::subfolder(std::string_view name) const
{
  return io::make_inner_folder(path_, name);
}

}  // namespace berm::run_folder
