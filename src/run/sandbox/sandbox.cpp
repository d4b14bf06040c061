// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/run_sandbox_test.cpp
#include "sandbox/sandbox.hpp"

#include "core/control_group.hpp"
#include "core/error.hpp"
#include "core/read_file.hpp"
#include "io/atomic_file.hpp"
#include "io/scratch_folder.hpp"
#include "sandbox/landlock.hpp"
#include "sandbox/watcher.hpp"

#include <cstdlib>
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

/// A program where PATH has it; "" without.
fs::path program_in_path(const std::string& name)
{
  std::error_code error;
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "/usr/bin:/bin" : path);
  for (std::string folder; std::getline(folders, folder, ':');)
    if (const fs::path file = fs::path(folder) / name;
        !folder.empty() && fs::is_regular_file(file, error) && ::access(file.c_str(), X_OK) == 0)
      return fs::canonical(file, error);
  return {};
}

/// The programs that berm itself starts, where they are installed, and berm.
void add_own_programs(Allowed& allowed)
{
  std::error_code error;
  const fs::path berm = fs::canonical("/proc/self/exe", error);
  if (!error) allowed.programs.push_back(berm);
  if (const fs::path gmsh = program_in_path("gmsh"); !gmsh.empty()) allowed.programs.push_back(gmsh);
  for (const char* name : {"gnuplot", "rsvg-convert"})
    if (const fs::path program = program_in_path(name); !program.empty()) {
      allowed.programs.push_back(program);
      allowed.quiet.push_back(program);
    }
}

bool is_script(const fs::path& program)
{
  std::string fault;
  const int file = open_to_read(program, fault);
  if (file < 0) return false;
  char begin[2] = {};
  const bool script = ::read(file, begin, sizeof begin) == sizeof begin && begin[0] == '#' && begin[1] == '!';
  ::close(file);
  return script;
}

/// Whether a berm that is in a sandbox started this one: what it left in the environment is believed where the kernel says the same.
bool is_in_one_already()
{
  return std::getenv(io::ScratchFolder::outer_variable) != nullptr && kernel_number("/proc/self/status", "Seccomp:") == 2 &&
         kernel_number("/proc/self/status", "NoNewPrivs:") == 1;
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
  if (is_script(program_in_path("gmsh"))) return "gmsh is a script here, which would have to start other programs";
  const Real scope = kernel_number("/proc/sys/kernel/yama/ptrace_scope");
  if (scope > 0 && scope < infinity && ::geteuid() != 0) return "no process may look into another here (kernel.yama.ptrace_scope)";
  return "";
}

void enter(const std::vector<fs::path>& folders)
{
  if (is_in_one_already()) return;
  ::unsetenv(io::ScratchFolder::outer_variable);
  if (const std::string why = why_there_is_none(); !why.empty()) throw RunError("this system has no sandbox: " + why);
  // Never removed by this program, which may not: its guard does so, outside of the sandbox.
  static const auto* const scratch = new io::ScratchFolder;
  Allowed allowed;
  allowed.folders.push_back(fs::canonical(scratch->path()));
  add_own_programs(allowed);
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
  for (const char* variable : {io::ScratchFolder::outer_variable, "TMPDIR", "TMP", "TEMP"})
    ::setenv(variable, allowed.folders.front().c_str(), 1);
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
