// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/run_sandbox_test.cpp
#include "sandbox/sandbox.hpp"

#include "core/error.hpp"
#include "io/atomic_file.hpp"
#include "io/scratch_folder.hpp"
#include "sandbox/landlock.hpp"
#include "sandbox/watcher.hpp"

#include <cstdlib>
#include <fmt/format.h>
#include <optional>
#include <seccomp.h>
#include <sstream>
#include <system_error>
#include <unistd.h>

namespace berm::sandbox {
namespace {

namespace fs = std::filesystem;

std::optional<Watcher> watcher;

bool has_one_thread()
{
  std::error_code error;
  const auto tasks = fs::directory_iterator("/proc/self/task", error);
  return !error && std::distance(begin(tasks), end(tasks)) == 1;
}

/// The programs that berm itself starts, where they are installed, and berm.
std::vector<fs::path> own_programs()
{
  std::error_code error;
  std::vector<fs::path> found = {fs::canonical("/proc/self/exe")};
  const char* const path = std::getenv("PATH");
  for (const char* name : {"gmsh", "gnuplot", "rsvg-convert"}) {
    std::istringstream folders(path == nullptr ? "/usr/bin:/bin" : path);
    for (std::string folder; std::getline(folders, folder, ':');)
      if (const fs::path file = fs::path(folder) / name; !folder.empty() && ::access(file.c_str(), X_OK) == 0) {
        if (const fs::path program = fs::canonical(file, error); !error) found.push_back(program);
        break;
      }
  }
  return found;
}

/// The folders that are not there yet on the way to this one, the innermost first.
std::vector<fs::path> missing(fs::path folder)
{
  std::vector<fs::path> all;
  for (; !folder.empty() && !fs::exists(folder); folder = folder.parent_path()) all.push_back(folder);
  return all;
}

}  // namespace

std::string why_there_is_none()
{
  if (landlock_version() < 2) return "its kernel has no Landlock (Linux 5.19 and later, where it is not switched off)";
  if (seccomp_api_get() < 5) return "its kernel has no notifications of seccomp";
  if (!has_one_thread()) return "the program has threads already";
  return "";
}

void enter(const std::vector<fs::path>& folders)
{
  if (std::getenv(io::ScratchFolder::outer_variable) != nullptr) return;
  if (const std::string why = why_there_is_none(); !why.empty()) throw RunError("this system has no sandbox: " + why);
  // Never removed by this program, which may not: its guard does so, outside of the sandbox.
  static const auto* const scratch = new io::ScratchFolder;
  Allowed allowed{{fs::canonical(scratch->path())}, own_programs(), {}};
  for (const fs::path& name : folders) {
    const fs::path folder = fs::absolute(name).lexically_normal();
    const std::vector<fs::path> made = missing(folder);
    allowed.made.insert(allowed.made.end(), made.begin(), made.end());
    io::make_folder(folder);
    allowed.folders.push_back(fs::canonical(folder));
  }
  try {
    watcher.emplace(allowed);  // first: the watcher itself is not restricted
    restrict_files(allowed.folders, allowed.programs);
  } catch (const std::system_error& error) {
    throw RunError(std::string("the sandbox cannot be set up: ") + error.what());
  }
  ::setenv(io::ScratchFolder::outer_variable, allowed.folders.front().c_str(), 1);
}

std::string stopped()
{
  return watcher ? watcher->notes() : "";
}

void throw_if_stopped()
{
  if (const std::string what = stopped(); !what.empty()) throw RunError("stopped by the sandbox: " + what.substr(0, what.find('\n')));
}

void leave()
{
  if (watcher) watcher->tidy_up();
}

}  // namespace berm::sandbox
