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

bool draw(const std::filesystem::path& folder, const std::string& name, int width, int height, const std::string& script, PlotFormat format)
{
  const bool vector = format == PlotFormat::svg;
  const std::string stem = vector ? name + "_svg" : name, picture = name + (vector ? ".svg" : ".png");
  const std::filesystem::path plots = folder / "plots", messages = plots / (stem + ".messages");
  std::error_code ignored;
  std::filesystem::create_directories(plots, ignored);  // where it cannot be made, write_whole says why
  const std::string head = fmt::format("# Draws ../{0}: run 'gnuplot {1}.gp' in this folder.\n"
                                       "set terminal {2} size {3},{4} noenhanced font 'DejaVu Sans,13' linewidth 1.2 background '#ffffff'\n"
                                       "set output {5}\nset encoding utf8\n",
                                       picture, stem, vector ? "svg" : "pngcairo", width, height, gnuplot_text("../" + picture));
  write_whole(plots / (stem + ".gp"), head + script);
  const int status = run_gnuplot(plots, stem + ".gp", messages.filename().string());
  if (status == 0) {
    std::filesystem::remove(messages);
    return true;
  }
  if (status < 0)
    spdlog::warn("{} is not drawn: the program gnuplot did not start ({}); its script is {}", picture,
                 std::generic_category().message(errno), (plots / (stem + ".gp")).string());
  else
    spdlog::warn("{} is not drawn: gnuplot says: {}", picture, last_message(messages));
  std::filesystem::remove(messages, ignored);
  std::filesystem::remove(folder / picture, ignored);
  return false;
}

}  // namespace berm
