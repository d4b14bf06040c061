// SPDX-License-Identifier: BSD-3-Clause
#include "jobs/shell.hpp"

#include "io/atomic_file.hpp"

#include <array>
#include <cstdio>
#include <sstream>
#include <sys/wait.h>

namespace berm::jobs {

std::string quoted(const std::string& word)
{
  constexpr const char* plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=./:,";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? "'\\''" : std::string(1, c);
  return text + "'";
}

ShellEnd run_shell(const std::string& command)
{
  std::fflush(nullptr);
  std::FILE* stream = ::popen(("{ " + command + "\n} 2>&1").c_str(), "re");
  if (stream == nullptr) io::throw_errno("no process can be started");
  ShellEnd end;
  std::array<char, 4096> part{};
  while (const std::size_t count = std::fread(part.data(), 1, part.size(), stream)) end.out.append(part.data(), count);
  const int status = ::pclose(stream);
  end.status = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
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
