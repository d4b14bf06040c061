// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/run_sandbox_test.cpp
#include "sandbox/sandbox.hpp"

#include "io/atomic_file.hpp"
#include "io/log.hpp"
#include "io/scratch_folder.hpp"
#include "io/tell.hpp"
#include "os/case_programs.hpp"
#include "os/child_process.hpp"
#include "os/control_group.hpp"
#include "os/error.hpp"
#include "os/read_file.hpp"
#include "sandbox/judge.hpp"
#include "sandbox/landlock.hpp"
#include "sandbox/watcher.hpp"

#include <cerrno>
#include <cstdlib>
#include <fmt/format.h>
#include <seccomp.h>
#include <sstream>
#include <string_view>
#include <sys/syscall.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace berm::sandbox {
namespace {

namespace fs = std::filesystem;

std::optional<Watcher> watcher;

bool does_without = false;

constexpr const char* inside_word = "--inside";  // the first word of a berm that starts a program of a case

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

/// The folders that are not there yet on the way to this one, the innermost first.
std::vector<fs::path> missing(fs::path folder)
{
  std::vector<fs::path> all;
  for (; !folder.empty() && !fs::exists(folder); folder = folder.parent_path()) all.push_back(folder);
  return all;
}

/// Throws RunError where that is not possible.
void restrict(const Allowed& allowed)
{
  if (!has_one_thread()) throw RunError("the sandbox cannot be set up: the program has threads already");
  adopt_orphans();  // so that the watcher finds what the program started
  try {
    watcher.emplace(allowed);  // first: the watcher itself is not restricted
    restrict_files(allowed.folders, allowed.programs);
  } catch (const std::system_error& error) {
    throw RunError(std::string("the sandbox cannot be set up: ") + error.what());
  }
}

void set_temporary_folder(const fs::path& folder)
{
  for (const char* variable : {io::ScratchFolder::outer_variable, "TMPDIR", "TMP", "TEMP"}) ::setenv(variable, folder.c_str(), 1);
}

/// The first thing that was stopped, in words; "" where nothing was.
std::string first_stopped()
{
  const std::string what = stopped();
  return what.empty() ? "" : "stopped by the sandbox: " + what.substr(0, what.find('\n'));
}

}  // namespace

std::string why_there_is_none()
{
  if (landlock_version() < 2) return "its kernel has no Landlock (Linux 5.19 and later, where it is not switched off)";
  if (seccomp_api_get() < 5) return "its kernel has no notifications of seccomp";
  if (is_script(program_in_path("gmsh"))) return "gmsh is a script here, which would have to start other programs";
  const Real scope = kernel_number("/proc/sys/kernel/yama/ptrace_scope");
  if (scope > 0 && scope < infinity && ::geteuid() != 0) return "no process may look into another here (kernel.yama.ptrace_scope)";
  return "";
}

bool is_inside()
{
  errno = 0;
  ::syscall(SYS_renameat2, -1, nullptr, -1, nullptr, question_flags);
  return errno == answer_inside;
}

void enter(const std::vector<fs::path>& folders)
{
  if (is_inside()) return;
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
  restrict(allowed);
  set_temporary_folder(allowed.folders.front());
}

bool is_trusted()
{
  const char* const value = std::getenv(trust_variable);
  return value != nullptr && std::string_view(value) == "1";
}

void do_without(const std::string& why)
{
  if (!std::exchange(does_without, true)) io::warn("what the case brings runs with all of your rights: there is no sandbox here: {}", why);
}

void guard_case_programs()
{
  set_case_program_rules({words_inside, [](const std::string& library) {
                            if (!is_inside() && !is_trusted() && !does_without)
                              throw RunError(
                                  fmt::format("{} is a library of a case, and loaded in a sandbox only: {}", library, how_to_do_without));
                          }});
}

std::vector<std::string> words_inside(const std::vector<std::string>& words, const std::string& folder)
{
  if (is_trusted()) return words;
  if (const std::string why = is_inside() ? "" : why_there_is_none(); !why.empty()) {
    do_without(why);
    return words;
  }
  const fs::path program = program_in_path(words.front());
  if (program.empty()) return words;  // it cannot be started, and is missed
  std::vector<std::string> inside = {fs::canonical("/proc/self/exe").string(), inside_word, folder, program.string()};
  inside.insert(inside.end(), words.begin() + 1, words.end());
  return inside;
}

std::optional<int> run_inside(int argc, char** argv)
{
  if (argc < 4 || std::string_view(argv[1]) != inside_word) return {};
  try {
    Allowed allowed;
    allowed.folders.push_back(fs::canonical(argv[2]));
    add_own_programs(allowed);
    if (is_inside())
      restrict_files(allowed.folders, allowed.programs);
    else
      restrict(allowed);
    set_temporary_folder(allowed.folders.front());
    ChildProcess program({.words = std::vector<std::string>(argv + 3, argv + argc)});
    const int status = program.wait();
    const std::string what = first_stopped();
    leave();
    if (what.empty()) return status;
    io::tell("{}; {}\n", what, how_to_do_without);
    return stopped_status;
  } catch (const std::exception& error) {
    io::tell("{}\n", error.what());
    return 1;
  }
}

std::string stopped()
{
  return watcher ? watcher->notes() : "";
}

void throw_if_stopped()
{
  if (const std::string what = first_stopped(); !what.empty()) throw RunError(what);
}

void leave()
{
  if (watcher) watcher->tidy_up();
}

}  // namespace berm::sandbox
