// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/record/soil_plot_test.cpp
#include "plot/gnuplot.hpp"

#include "core/error.hpp"
#include "io/atomic_file.hpp"

#include <cerrno>
#include <fcntl.h>
#include <fmt/format.h>
#include <fstream>
#include <spawn.h>
#include <spdlog/spdlog.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

namespace berm::plot {
namespace {

/// Runs gnuplot in the folder on the script, which draws into `picture`; its messages go into a file there. The exit status; -1, and errno says why, where it did not start.
int run_gnuplot(const std::filesystem::path& folder, std::string script, const std::string& picture, const std::string& messages)
{
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, messages.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  std::string program = "gnuplot", option = "-e", command = "picture = " + gnuplot_text(picture);
  char* arguments[] = {program.data(), option.data(), command.data(), script.data(), nullptr};
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

/// Whether a picture ends as pictures of its kind do: gnuplot does not tell when the disk does not take all of it.
bool is_whole(const std::filesystem::path& picture, PlotFormat format)
{
  constexpr std::string_view end_of_svg = "</svg>", end_of_png("IEND\xAE\x42\x60\x82", 8);
  std::string bytes = io::read_text_file(picture);
  if (format == PlotFormat::svg) bytes.erase(bytes.find_last_not_of(" \n") + 1);
  return bytes.ends_with(format == PlotFormat::svg ? end_of_svg : end_of_png);
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

PlotUnit force_unit(Real size, int dimension)
{
  if (size < 100) return {1, dimension == 2 ? "N/m" : "N"};
  return {1e-3, dimension == 2 ? "kN/m" : "kN"};
}

bool draw(const std::filesystem::path& folder, const std::string& name, int width, int height, const std::string& script, PlotFormat format)
{
  const bool vector = format == PlotFormat::svg;
  const std::string stem = vector ? name + "_svg" : name, picture = name + (vector ? ".svg" : ".png");
  const std::filesystem::path plots = folder / "plots", messages = plots / (stem + ".messages");
  std::error_code ignored;
  io::make_folder(plots);
  const std::string head = fmt::format("# Draws ../{0}: run 'gnuplot {1}.gp' in this folder.\n"
                                       "set terminal {2} size {3},{4} noenhanced font 'DejaVu Sans,13' linewidth 1.2 background '#ffffff'\n"
                                       "if (!exists('picture')) picture = {5}\nset output picture\nset encoding utf8\n",
                                       picture, stem, vector ? "svg" : "pngcairo", width, height, gnuplot_text("../" + picture));
  io::write_atomically(plots / (stem + ".gp"), head + script);
  // A name that begins with - is no option.
  const int status = run_gnuplot(plots, "./" + stem + ".gp", "../" + io::part_of(picture).string(), messages.filename().string());
  const int reason = errno;
  if (status == 0) {
    std::filesystem::remove(messages, ignored);
    if (!is_whole(io::part_of(folder / picture), format)) {
      std::filesystem::remove(io::part_of(folder / picture), ignored);
      throw RunError(fmt::format("cannot write {}: gnuplot could not write all of it (is the disk full?)", (folder / picture).string()));
    }
    io::finish_whole(folder / picture);
    return true;
  }
  std::filesystem::remove(io::part_of(folder / picture), ignored);
  errno = reason;
  if (status < 0 && reason != ENOENT) io::throw_errno(fmt::format("cannot write {}: gnuplot did not start", (folder / picture).string()));
  if (status < 0)
    spdlog::warn("{} is not drawn: the program gnuplot did not start ({}); its script is {}", picture,
                 std::generic_category().message(errno), (plots / (stem + ".gp")).string());
  else
    spdlog::warn("{} is not drawn: gnuplot says: {}", picture, last_message(messages));
  std::filesystem::remove(messages, ignored);
  std::filesystem::remove(folder / picture, ignored);
  return false;
}

}  // namespace berm::plot
