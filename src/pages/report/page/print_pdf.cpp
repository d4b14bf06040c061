// SPDX-License-Identifier: BSD-3-Clause
#include "report/page/print_pdf.hpp"

#include "core/error.hpp"
#include "io/atomic_file.hpp"
#include "io/scratch_folder.hpp"

#include <algorithm>
#include <cstdlib>
#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spawn.h>
#include <sstream>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace berm::report {
namespace {

namespace fs = std::filesystem;

constexpr const char* names[] = {"chromium", "chromium-browser", "google-chrome", "google-chrome-stable"};

bool is_program(const fs::path& file)
{
  std::error_code error;
  return fs::is_regular_file(file, error) && ::access(file.c_str(), X_OK) == 0;
}

fs::path in_path(const std::string& name)
{
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "/usr/bin:/bin" : path);
  for (std::string folder; std::getline(folders, folder, ':');)
    if (const fs::path file = fs::path(folder) / name; is_program(file)) return file;
  return {};
}

/// The address of a file; all but plain letters by their numbers.
std::string address_of(const fs::path& file)
{
  std::string address = "file://";
  for (const char c : fs::absolute(file).lexically_normal().string()) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = byte < 0x80 && (std::isalnum(byte) != 0 || std::string_view("/._-~").find(c) != std::string_view::npos);
    address += plain ? std::string(1, c) : fmt::format("%{:02X}", byte);
  }
  return address;
}

/// Exit status of a program whose messages go into a file; -1 where it does not start.
int run_browser(std::vector<std::string> words, const fs::path& messages)
{
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, messages.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t child = 0;
  const int error = posix_spawn(&child, words.front().c_str(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) return -1;
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128;
}

/// The last line that says something, for an error.
std::string last_line(const fs::path& file)
{
  std::istringstream lines(io::read_text_file(file));
  std::string last;
  for (std::string line; std::getline(lines, line);)
    if (line.find_first_not_of(" \t") != std::string::npos) last = line;
  return last;
}

}  // namespace

fs::path printing_browser()
{
  if (const char* named = std::getenv("BERM_BROWSER"); named != nullptr && *named != '\0') {
    if (is_program(named)) return named;
    throw RunError(fmt::format("--pdf: BERM_BROWSER names \"{}\", which is no program", named));
  }
  for (const char* name : names)
    if (const fs::path found = in_path(name); !found.empty()) return found;
  throw RunError(
      fmt::format("--pdf: no browser that can print is installed (looked for {}). Install one, as by apt-get install chromium, or name one "
                  "in the environment variable BERM_BROWSER; or open the page in any browser and print it there",
                  fmt::join(names, ", ")));
}

void print_pdf(const fs::path& browser, const fs::path& page, const fs::path& pdf)
{
  const io::ScratchFolder scratch;  // a browser wants a profile of its own
  const fs::path made = scratch.path() / "page.pdf", messages = scratch.path() / "messages.txt";
  // Time is virtual: the browser waits until the page has drawn its films, and no longer.
  std::vector<std::string> words = {browser.string(),
                                    "--headless",
                                    "--disable-gpu",
                                    "--no-first-run",
                                    "--no-pdf-header-footer",
                                    "--force-device-scale-factor=2",
                                    "--virtual-time-budget=20000",
                                    "--user-data-dir=" + (scratch.path() / "profile").string(),
                                    "--print-to-pdf=" + made.string(),
                                    address_of(page)};
  if (::geteuid() == 0) words.insert(words.begin() + 1, "--no-sandbox");  // which it cannot have as root
  const int status = run_browser(words, messages);
  if (status != 0 || !io::read_text_file(made).starts_with("%PDF"))
    throw RunError(
        fmt::format("--pdf: {} could not print {} (exit status {}): {}", browser.string(), page.string(), status, last_line(messages)));
  io::copy_atomically(made, pdf);
}

}  // namespace berm::report
