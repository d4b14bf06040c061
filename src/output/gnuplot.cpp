// SPDX-License-Identifier: BSD-3-Clause
#include "output/gnuplot.hpp"

#include "output/whole_file.hpp"

#include <cerrno>
#include <fcntl.h>
#include <fmt/format.h>
#include <fstream>
#include <spawn.h>
#include <spdlog/spdlog.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

namespace berm {
namespace {

/// Runs `gnuplot SCRIPT` in the folder, its messages into a file there. The exit status; -1, and errno says why, where it did not start.
int run_gnuplot(const std::filesystem::path& folder, std::string script, const std::string& messages)
{
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, messages.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  std::string program = "gnuplot";
  char* arguments[] = {program.data(), script.data(), nullptr};
  pid_t child = 0;
  const int error = posix_spawnp(&child, program.c_str(), &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) {
    errno = error;
    return -1;
  }
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128;
}

std::string last_message(const std::filesystem::path& file)
{
  std::ifstream lines(file);
  std::string line, last;
  while (std::getline(lines, line))
    if (line.find_first_not_of(" \t^") != std::string::npos) last = line;
  return last;
}

}  // namespace

std::string gnuplot_text(const std::string& text)
{
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("''") : std::string(1, c == '\n' || c == '\r' ? ' ' : c);
  return quoted + "'";
}

PlotUnit length_unit(Real size)
{
  return size < 1 ? PlotUnit{1000, "mm"} : PlotUnit{1, "m"};
}

PlotUnit force_unit(Real size)
{
  return size < 100 ? PlotUnit{1, "N/m"} : PlotUnit{1e-3, "kN/m"};
}

bool draw(const std::filesystem::path& folder, const std::string& name, int width, int height, const std::string& script)
{
  const std::filesystem::path plots = folder / "plots", messages = plots / (name + ".messages");
  std::error_code ignored;
  std::filesystem::create_directories(plots, ignored);  // where it cannot be made, write_whole says why
  const std::string head =
      fmt::format("# Draws ../{0}.png: run 'gnuplot {0}.gp' in this folder.\n"
                  "set terminal pngcairo size {1},{2} noenhanced font 'DejaVu Sans,13' linewidth 1.2 background '#ffffff'\n"
                  "set output '../{0}.png'\nset encoding utf8\n",
                  name, width, height);
  write_whole(plots / (name + ".gp"), head + script);
  const int status = run_gnuplot(plots, name + ".gp", messages.filename().string());
  if (status == 0) {
    std::filesystem::remove(messages);
    return true;
  }
  if (status < 0)
    spdlog::warn("{}.png is not drawn: the program gnuplot did not start ({}); its script is {}", name,
                 std::generic_category().message(errno), (plots / (name + ".gp")).string());
  else
    spdlog::warn("{}.png is not drawn: gnuplot says: {}", name, last_message(messages));
  std::filesystem::remove(messages, ignored);
  std::filesystem::remove(folder / (name + ".png"), ignored);
  return false;
}

}  // namespace berm
