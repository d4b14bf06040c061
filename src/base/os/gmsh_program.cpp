// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/mesh/mesh_settings_test.cpp
#include "os/gmsh_program.hpp"

#include "os/case_programs.hpp"
#include "os/child_process.hpp"
#include "os/control_characters.hpp"
#include "os/error.hpp"
#include "os/read_file.hpp"

#include <cerrno>
#include <cstring>
#include <fmt/format.h>
#include <sstream>
#include <string>
#include <system_error>
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

}  // namespace

void run_gmsh(const fs::path& geo, const fs::path& msh, int dim, GeometryBy whose)
{
  const fs::path folder = fs::absolute(msh).parent_path();
  const fs::path log = fs::path(msh).replace_extension(".log");
  // An old mesh or a missing output folder must not be taken for a result or for a missing program.
  if (!fs::is_directory(folder)) throw RunError(fmt::format("gmsh: there is no folder {} for the mesh", folder.string()));
  if (!fs::is_regular_file(geo)) throw RunError(fmt::format("gmsh: there is no geometry {}", geo.string()));
  fs::remove(msh);
  // Gmsh reads its user's options from the folder that GMSH_HOME names; a folder without any makes meshes the same for everyone.
  const std::vector<std::string> words = {
      "gmsh", fs::absolute(geo).string(), fmt::format("-{}", dim), "-nt", "1", "-v", "3", "-format", "msh41",
      "-o",   fs::absolute(msh).string()};
  ChildProcess gmsh = started({.words = whose == GeometryBy::user ? contained(words, folder.string()) : words,
                               .messages = log.string(),
                               .environment = {"GMSH_HOME=" + folder.string() + "/"}});
  const int status = wait_unless_interrupted(gmsh, "gmsh");
  if (status == stopped_status && whose == GeometryBy::user) throw RunError(last_line(log));
  if (status > 128) throw RunError(fmt::format("gmsh was stopped by signal {} ({})", status - 128, strsignal(status - 128)));
  if (status != 0 || !fs::exists(msh))
    throw RunError(
        fmt::format("gmsh failed on {} (exit status {}); the end of {}:{}", geo.string(), status, log.string(), last_lines(log, 8)));
}

}  // namespace berm
