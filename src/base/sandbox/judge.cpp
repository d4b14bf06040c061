// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/run_sandbox_test.cpp
#include "sandbox/judge.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <climits>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <optional>
#include <sys/socket.h>
#include <sys/uio.h>

namespace berm::sandbox {
namespace {

namespace fs = std::filesystem;

/// A call that changes a file by its name or by its number.
struct Changes {
  int call;
  struct Name {
    int folder, path;  ///< arguments; folder -1: names begin at the working folder; path -1: the folder is the open file itself
  };
  std::vector<Name> names;
  bool only_here;  ///< Landlock does not know it in all of its versions
};

const std::vector<Changes>& changing_calls()
{
  static const std::vector<Changes> all = {
      {SCMP_SYS(open), {{-1, 0}}, false},
      {SCMP_SYS(openat), {{0, 1}}, false},
      {SCMP_SYS(creat), {{-1, 0}}, false},
      {SCMP_SYS(mkdir), {{-1, 0}}, false},
      {SCMP_SYS(mkdirat), {{0, 1}}, false},
      {SCMP_SYS(mknod), {{-1, 0}}, false},
      {SCMP_SYS(mknodat), {{0, 1}}, false},
      {SCMP_SYS(unlink), {{-1, 0}}, false},
      {SCMP_SYS(unlinkat), {{0, 1}}, false},
      {SCMP_SYS(rmdir), {{-1, 0}}, false},
      {SCMP_SYS(rename), {{-1, 0}, {-1, 1}}, false},
      {SCMP_SYS(renameat), {{0, 1}, {2, 3}}, false},
      {SCMP_SYS(renameat2), {{0, 1}, {2, 3}}, false},
      {SCMP_SYS(link), {{-1, 0}, {-1, 1}}, false},
      {SCMP_SYS(linkat), {{0, 1}, {2, 3}}, false},
      {SCMP_SYS(symlink), {{-1, 1}}, false},
      {SCMP_SYS(symlinkat), {{1, 2}}, false},
      {SCMP_SYS(truncate), {{-1, 0}}, true},
      {SCMP_SYS(chmod), {{-1, 0}}, true},
      {SCMP_SYS(fchmod), {{0, -1}}, true},
      {SCMP_SYS(fchmodat), {{0, 1}}, true},
      {SCMP_SYS(chown), {{-1, 0}}, true},
      {SCMP_SYS(lchown), {{-1, 0}}, true},
      {SCMP_SYS(fchown), {{0, -1}}, true},
      {SCMP_SYS(fchownat), {{0, 1}}, true},
      {SCMP_SYS(utime), {{-1, 0}}, true},
      {SCMP_SYS(utimes), {{-1, 0}}, true},
      {SCMP_SYS(futimesat), {{0, 1}}, true},
      {SCMP_SYS(utimensat), {{0, 1}}, true},
      {SCMP_SYS(setxattr), {{-1, 0}}, true},
      {SCMP_SYS(lsetxattr), {{-1, 0}}, true},
      {SCMP_SYS(fsetxattr), {{0, -1}}, true},
      {SCMP_SYS(removexattr), {{-1, 0}}, true},
      {SCMP_SYS(lremovexattr), {{-1, 0}}, true},
      {SCMP_SYS(fremovexattr), {{0, -1}}, true},
  };
  return all;
}

fs::path process(const seccomp_notif& call)
{
  return fs::path("/proc") / std::to_string(call.pid);
}

/// A text in the memory of the process; empty where it cannot be read.
std::optional<std::string> text_at(const seccomp_notif& call, std::uint64_t address)
{
  std::string text;
  constexpr std::size_t page = 4096;
  while (text.size() < PATH_MAX) {
    std::array<char, page> bytes;
    const std::size_t count = page - address % page;  // the next page may not be there
    iovec here{bytes.data(), count}, there{reinterpret_cast<void*>(address), count};
    const ssize_t got = ::process_vm_readv(static_cast<pid_t>(call.pid), &here, 1, &there, 1, 0);
    if (got <= 0) return {};
    const auto end = std::find(bytes.begin(), bytes.begin() + got, '\0');
    text.append(bytes.begin(), end);
    if (end != bytes.begin() + got) return text;
    address += static_cast<std::uint64_t>(got);
  }
  return {};
}

/// A path of the process as an absolute one; empty where that is not to be known.
std::optional<fs::path> absolute_path(const seccomp_notif& call, int folder, int path)
{
  std::error_code error;
  const auto place_of = [&](int argument) -> fs::path {
    const int number = argument < 0 ? AT_FDCWD : static_cast<int>(call.data.args[argument]);
    return fs::read_symlink(number == AT_FDCWD ? process(call) / "cwd" : process(call) / "fd" / std::to_string(number), error);
  };
  if (path < 0 || call.data.args[path] == 0) {  // an open file; utimensat names it by no path
    const fs::path file = place_of(folder);
    return error ? std::nullopt : std::optional(file);
  }
  const std::optional<std::string> text = text_at(call, call.data.args[path]);
  if (!text) return {};
  fs::path name = *text;
  if (const std::string self = "/proc/self/"; text->starts_with(self)) name = process(call) / text->substr(self.size());
  if (name.is_absolute()) return name;
  const fs::path start = place_of(folder);
  return error ? std::nullopt : std::optional(start / name);
}

bool is_within(const fs::path& file, const fs::path& folder)
{
  return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first == folder.end();
}

/// With links followed as far as the path is there, also those that lead to nothing.
fs::path real(const fs::path& file)
{
  std::error_code error;
  fs::path found = file;
  for (int links = 0; links < 40; ++links) {
    const fs::path next = fs::weakly_canonical(found, error);
    if (error) return found.lexically_normal();
    if (!fs::is_symlink(fs::symlink_status(next, error))) return next;
    const fs::path target = fs::read_symlink(next, error);
    found = target.is_absolute() ? target : next.parent_path() / target;
  }
  return found;
}

std::string family(std::uint64_t number)
{
  return number == AF_INET || number == AF_INET6 ? "of the network"
         : number == AF_UNIX                     ? "to other programs"
                                                 : "of family " + std::to_string(number);
}

}  // namespace

const std::vector<int>& watched_calls()
{
  static const std::vector<int> all = [] {
    std::vector<int> calls = {SCMP_SYS(execve), SCMP_SYS(execveat), SCMP_SYS(set_tid_address), SCMP_SYS(socket)};
    for (const Changes& changes : changing_calls())
      if (changes.call != SCMP_SYS(open) && changes.call != SCMP_SYS(openat)) calls.push_back(changes.call);
    return calls;
  }();
  return all;
}

/// gnuplot and what else draws may try to write what it remembers: that is refused without a word.
Verdict Judge::refused(const seccomp_notif& call, const std::string& what) const
{
  std::error_code error;
  const fs::path program = fs::read_symlink(process(call) / "exe", error);
  if (std::find(allowed_.quiet.begin(), allowed_.quiet.end(), program) != allowed_.quiet.end()) return {EACCES, ""};
  if (program == fs::read_symlink(fs::path("/proc") / std::to_string(watched_) / "exe", error))
    return {EACCES, "a library of the case would have " + what};
  return {EACCES, (program.filename() == "gmsh" ? "the geometry of the case would have " : "a program of the case would have ") + what};
}

Verdict Judge::start(const seccomp_notif& call) const
{
  if (call.data.nr == SCMP_SYS(execveat)) return refused(call, "started a program");
  const std::optional<fs::path> file = absolute_path(call, -1, 0);
  if (!file) return refused(call, "started a program");
  std::error_code error;
  if (!fs::exists(*file, error)) return {};  // the system says that there is none
  const fs::path program = real(*file);
  const bool allowed = std::find(allowed_.programs.begin(), allowed_.programs.end(), program) != allowed_.programs.end();
  return allowed ? Verdict{} : refused(call, "started the program " + file->string());
}

/// Each program makes this call as it begins, before any code of its own: the loader, which may be started, must not have been started to load another.
Verdict Judge::begin(const seccomp_notif& call) const
{
  std::error_code error;
  const fs::path program = fs::read_symlink(process(call) / "exe", error);
  if (!error && std::find(allowed_.programs.begin(), allowed_.programs.end(), program) != allowed_.programs.end()) return {};
  Verdict verdict = refused(call, "started a program by the loader");
  verdict.ends = true;
  return verdict;
}

/// Below /proc and /dev names are others for each process, but for the files in shared memory: what Landlock knows it judges itself, and of the rest nothing is allowed.
Verdict Judge::change(const seccomp_notif& call, const fs::path& file, bool only_here) const
{
  const fs::path path = real(file);
  const auto within = [&](const fs::path& folder) { return is_within(file.lexically_normal(), folder) || is_within(path, folder); };
  if (within("/proc") || (within("/dev") && !is_within(path, "/dev/shm")))
    return only_here ? refused(call, "changed " + file.string()) : Verdict{};
  if (std::any_of(allowed_.folders.begin(), allowed_.folders.end(), [&](const fs::path& folder) { return is_within(path, folder); }))
    return {};
  // FLTK, which gmsh is made with, tries to keep settings of its own, for all users and for this one, whatever the geometry is, and makes the home folder for that.
  const char* const home = std::getenv("HOME");
  const bool of_fltk =
      is_within(path, "/etc/fltk") || std::find(path.begin(), path.end(), ".fltk") != path.end() || (home != nullptr && path == home);
  return of_fltk ? Verdict{EACCES, ""} : refused(call, "written to " + path.string());
}

Verdict Judge::operator()(const seccomp_notif& call) const
{
  if (call.data.nr == SCMP_SYS(renameat2) && call.data.args[4] == question_flags) return {answer_inside, ""};
  if (call.data.nr == SCMP_SYS(set_tid_address)) return begin(call);
  if (call.data.nr == SCMP_SYS(socket)) return refused(call, "opened a socket " + family(call.data.args[0]));
  if (call.data.nr == SCMP_SYS(execve) || call.data.nr == SCMP_SYS(execveat)) return start(call);
  const auto changes =
      std::find_if(changing_calls().begin(), changing_calls().end(), [&](const Changes& known) { return known.call == call.data.nr; });
  if (changes == changing_calls().end()) return {EPERM, ""};
  for (const Changes::Name& name : changes->names) {
    const std::optional<fs::path> file = absolute_path(call, name.folder, name.path);
    if (!file) return refused(call, "written to a file whose name cannot be read");
    if (Verdict verdict = change(call, *file, changes->only_here); verdict.error != 0) return verdict;
    // The kernel may find another file by the same name, and Landlock does not look: nothing that berm starts asks by name.
    if (changes->only_here && name.path >= 0 && call.data.args[name.path] != 0) return refused(call, "written to " + real(*file).string());
  }
  return {};
}

}  // namespace berm::sandbox
