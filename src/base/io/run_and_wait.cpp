// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/soil_plot/soil_plot_test.cpp
#include "io/run_and_wait.hpp"

#include "io/atomic_file.hpp"
#include "os/child_process.hpp"

#include <cerrno>
#include <sstream>
#include <system_error>

namespace berm::io {

int run_and_wait(const std::vector<std::string>& words, const std::filesystem::path& messages, const std::filesystem::path& folder)
{
  try {
    return ChildProcess({.words = words, .messages = messages.string(), .folder = folder.string()}).wait();
  } catch (const std::system_error& error) {
    errno = error.code().value();
    return -1;
  }
}

std::string last_message(const std::filesystem::path& file)
{
  std::istringstream lines(read_text_file(file));
  std::string line, last;
  while (std::getline(lines, line))
    if (line.find_first_not_of(" \t^") != std::string::npos) last = line;
  return last;
}

}  // namespace berm::io
