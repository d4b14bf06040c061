// SPDX-License-Identifier: BSD-3-Clause
#include "jobs/shell.hpp"

#include "io/atomic_file.hpp"
#include "os/child_process.hpp"
#include "os/error.hpp"

#include <csignal>
#include <fmt/format.h>
#include <sstream>
#include <sys/mman.h>
#include <system_error>
#include <unistd.h>

namespace berm::jobs {

std::string quoted(const std::string& word)
{
  constexpr const char* plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=./:,";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? "'\\''" : std::string(1, c);
  return text + "'";
}

ChildProcess started_shell(const std::string& command, int out)
{
  std::fflush(nullptr);
  try {
    return ChildProcess({.words = {"sh", "-c", command}, .program = "/bin/sh", .out = out, .end_by = SIGTERM});
  } catch (const std::system_error& error) {
    throw RunError(fmt::format("no process can be started: {}", error.code().message()));
  }
}

ShellEnd run_shell(const std::string& command)
{
  const int memory = ::memfd_create("berm", MFD_CLOEXEC);
  if (memory < 0) io::throw_errno("no process can be started");
  ShellEnd end;
  try {
    end.status = started_shell(command, memory).wait();
  } catch (...) {
    ::close(memory);
    throw;
  }
  end.out = io::read_text_file(fmt::format("/proc/self/fd/{}", memory));
  ::close(memory);
  return end;
}

bool has_program(const std::string& name)
{
  return run_shell("command -v " + quoted(name)).status == 0;
}

std::string last_line(const std::string& text)
{
  std::istringstream lines(text);
  std::string line, last;
  while (std::getline(lines, line))
    if (line.find_first_not_of(" \t\r") != std::string::npos) last = line;
  return last;
}

}  // namespace berm::jobs
