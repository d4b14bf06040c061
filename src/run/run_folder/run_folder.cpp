// SPDX-License-Identifier: BSD-3-Clause
#include "run_folder/run_folder.hpp"

#include "core/error.hpp"
#include "io/atomic_file.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <set>
#include <unistd.h>
#include <vector>

namespace berm::run_folder {
namespace {

namespace fs = std::filesystem;

// All that a run writes but its pictures of the soil. resolved.toml goes last: until then the folder is known as one of a run, so that an interrupted removal can be repeated.
constexpr const char* own_files[] = {
    "history.csv",     "history.schema.json", "summary.json",       "origin.json",        "run.log",
    "case.toml",       "expected.toml",       "mesh.geo",           "mesh.msh",           "mesh.log",
    "ground.csv",      "report.html",         "report.pdf",         "curves.png",         "plots/curves.dat",
    "plots/curves.gp", "plots/band_V_w.dat",  "plots/band_H_u.dat", "plots/band_w_u.dat", "frames",
    "uncertainty",     "checkpoint",          "claims.toml",        "resolved.toml"};  // claims.toml: of earlier versions

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

/// Whether anything is in the folder but what a run leaves that is ended by force as it begins: its lock, a part of its first file.
bool holds_files(const fs::path& folder)
{
  return std::any_of(fs::directory_iterator(folder), fs::directory_iterator(), [](const fs::directory_entry& entry) {
    return entry.path().filename() != io::FolderLock::file_name && entry.path().filename() != io::part_of("resolved.toml");
  });
}

[[noreturn]] void refuse(const fs::path& path, const std::string& reason)
{
  throw RunError(fmt::format("cannot use {} as the run folder: {}", path.string(), reason));
}

}  // namespace

RunFolder::RunFolder(const fs::path& path) : path_(path)
{
  try {
    if (fs::exists(path) && !fs::is_directory(path)) refuse(path, "it is not a folder");
    fs::create_directories(path);
    if (::access(path.c_str(), W_OK | X_OK) != 0) io::throw_errno(fmt::format("cannot use {} as the run folder", path.string()));
    const bool of_a_run = fs::exists(path / "resolved.toml");
    if (!of_a_run && holds_files(path))
      refuse(path, "it holds files that are not of a run (there is no resolved.toml); name another folder with -o");
    lock_ = std::make_unique<io::FolderLock>(path);
    if (of_a_run) {
      remove_soil_pictures(path);
      for (const char* name : own_files) fs::remove_all(path / name);
    }
  } catch (const fs::filesystem_error& error) {
    refuse(path, error.code().message());
  }
}

RunFolder RunFolder::of_earlier_run(const fs::path& path)
{
  std::error_code error;
  if (!fs::exists(path / "resolved.toml", error)) refuse(path, "it is not the folder of a run (there is no resolved.toml)");
  if (::access(path.c_str(), W_OK | X_OK) != 0) io::throw_errno(fmt::format("cannot use {} as the run folder", path.string()));
  return {path, AsItIs{}};
}

fs::path RunFolder::subfolder(std::string_view name) const
{
  io::make_folder(path_ / name);
  return path_ / name;
}

}  // namespace berm::run_folder
