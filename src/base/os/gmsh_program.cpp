// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/mesh/mesh_settings_test.cpp
#include "os/gmsh_program.hpp"

#include "os/case_programs.hpp"
#include "os/child_process.hpp"
#include "os/control_characters.hpp"
#include "os/error.hpp"
#include "os/interrupt.hpp"
#include "os/read_file.hpp"

#include <cerrno>
#include <chrono>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <fstream>
#include <sstream>
#include <string>
#include <sys/stat.h>
#include <system_error>
#include <thread>
#include <unistd.h>
#include <vector>

namespace berm {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> lines_of(const fs::path& file)
{
  constexpr std::uintmax_t max_bytes = 100'000'000;
  std::istringstream in(read_file(file, max_bytes).bytes);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);)
    if (!line.empty()) lines.push_back(one_line(line));  // a geometry may print what moves a cursor
  return lines;
}

std::string last_lines(const fs::path& file, std::size_t count)
{
  const std::vector<std::string> lines = lines_of(file);
  std::string text;
  for (std::size_t k = lines.size() > count ? lines.size() - count : 0; k < lines.size(); ++k) text += "\n  " + lines[k];
  return text;
}

std::string last_line(const fs::path& file)
{
  const std::vector<std::string> lines = lines_of(file);
  return lines.empty() ? "gmsh was stopped" : lines.back();
}

ChildProcess started(const ChildStart& start)
{
  try {
    return ChildProcess(start);
  } catch (const std::system_error& error) {
    const std::string& name = start.words[0];
    if (error.code().value() == ENOENT) throw RunError(fmt::format("{0} is not installed: sudo apt-get install {0}", name));
    throw RunError(fmt::format("{} cannot be started: {}", name, error.code().message()));
  }
}

/// Of a WaitingGmsh, in its folder: the pipe that brings it the next commands, the file by which it says that they are done, and its messages.
constexpr const char *next = "next.geo", *done = "meshed", *messages = "gmsh.log";

/// Gmsh reads its user's options from the folder that GMSH_HOME names; a folder without any makes meshes the same for everyone.
std::vector<std::string> without_options(const fs::path& folder)
{
  return {"GMSH_HOME=" + folder.string() + "/"};
}

}  // namespace

void run_gmsh(const fs::path& geo, const fs::path& msh, int dim, GeometryBy whose)
{
  const fs::path folder = fs::absolute(msh).parent_path();
  const fs::path log = fs::path(msh).replace_extension(".log");
  // An old mesh or a missing output folder must not be taken for a result or for a missing program.
  if (!fs::is_directory(folder)) throw RunError(fmt::format("gmsh: there is no folder {} for the mesh", folder.string()));
  if (!fs::is_regular_file(geo)) throw RunError(fmt::format("gmsh: there is no geometry {}", geo.string()));
  fs::remove(msh);
  const std::vector<std::string> words = {
      "gmsh", fs::absolute(geo).string(), fmt::format("-{}", dim), "-nt", "1", "-v", "3", "-format", "msh41",
      "-o",   fs::absolute(msh).string()};
  ChildProcess gmsh = started({.words = whose == GeometryBy::user ? contained(words, folder.string()) : words,
                               .messages = log.string(),
                               .environment = without_options(folder)});
  const int status = wait_unless_interrupted(gmsh, "gmsh");
  if (status == stopped_status && whose == GeometryBy::user) throw RunError(last_line(log));
  if (status > 128) throw RunError(fmt::format("gmsh was stopped by signal {} ({})", status - 128, strsignal(status - 128)));
  if (status != 0 || !fs::exists(msh))
    throw RunError(
        fmt::format("gmsh failed on {} (exit status {}); the end of {}:{}", geo.string(), status, log.string(), last_lines(log, 8)));
}

void WaitingGmsh::start()
{
  const fs::path geo = folder_ / "gmsh.geo", pipe = folder_ / next;
  fs::remove(pipe);
  if (mkfifo(pipe.c_str(), S_IRUSR | S_IWUSR) != 0)
    throw RunError(fmt::format("cannot make the pipe {}: {}", pipe.string(), strerror(errno)));
  std::ofstream(geo) << "General.AbortOnError = 4;\nFor k In {1:1000000000}\n  Include \"" << next << "\";\nEndFor\n";
  gmsh_.emplace(started({.words = {"gmsh", geo.string(), "-", "-nt", "1", "-v", "2", "-format", "msh41"},
                         .messages = (folder_ / messages).string(),
                         .environment = without_options(folder_)}));
}

/// Throws where the program has ended.
void WaitingGmsh::check_alive()
{
  if (interrupted()) {
    gmsh_.reset();
    throw Interrupted("stopped while gmsh was running");
  }
  if (!gmsh_->has_ended()) return;
  const int status = gmsh_->wait();
  gmsh_.reset();
  throw RunError(fmt::format("gmsh failed (exit status {}); the end of its messages:{}", status, last_lines(folder_ / messages, 8)));
}

/// Writes commands into the pipe, once the program reads from it.
void WaitingGmsh::hand_over(const std::string& commands)
{
  int pipe = -1;
  while ((pipe = open((folder_ / next).c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC)) < 0) {
    check_alive();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  const auto written = write(pipe, commands.data(), commands.size());  // at once, since it is shorter than a pipe
  close(pipe);
  if (written != static_cast<ssize_t>(commands.size())) throw RunError("gmsh took no commands");
}

void WaitingGmsh::mesh(const std::string& geo, const std::string& msh)
{
  fs::remove(folder_ / msh);
  fs::remove(folder_ / done);
  if (!gmsh_) start();
  hand_over(fmt::format("Merge \"{}\";\nMesh 2; Save \"{}\"; Delete Model; Delete Physicals; Printf(\"\") > \"{}\";\n", geo, msh, done));
  while (!fs::exists(folder_ / done)) {
    check_alive();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

}  // namespace berm
