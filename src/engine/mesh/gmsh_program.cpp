// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/mesh/gmsh_test.cpp
#include "mesh/gmsh_program.hpp"

#include "core/error.hpp"
#include "core/read_file.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sstream>
#include <string>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace berm::mesh {
namespace {

namespace fs = std::filesystem;

std::string last_lines(const fs::path& file, std::size_t count)
{
  constexpr std::uintmax_t max_bytes = 100'000'000;
  std::istringstream in(read_file(file, max_bytes).bytes);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);)
    if (!line.empty()) lines.push_back(line);
  std::string text;
  for (std::size_t k = lines.size() > count ? lines.size() - count : 0; k < lines.size(); ++k) text += "\n  " + lines[k];
  return text;
}

// Gmsh reads its user's options from the folder that GMSH_HOME names; a folder without any makes meshes the same for
// everyone.
std::vector<std::string> environment_with_home(const fs::path& home)
{
  std::vector<std::string> environment;
  for (char** entry = environ; *entry != nullptr; ++entry)
    if (std::strncmp(*entry, "GMSH_HOME=", 10) != 0) environment.emplace_back(*entry);
  environment.push_back("GMSH_HOME=" + home.string() + "/");
  return environment;
}

std::vector<char*> pointers(std::vector<std::string>& words)
{
  std::vector<char*> list;
  for (std::string& word : words) list.push_back(word.data());
  list.push_back(nullptr);
  return list;
}

// Runs a program found in PATH, without a shell, and waits. Returns its wait status.
int run_and_wait(std::vector<std::string> words, std::vector<std::string> environment, const fs::path& log)
{
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  pid_t process = 0;
  const int failure = posix_spawnp(&process, words[0].c_str(), &actions, nullptr, pointers(words).data(), pointers(environment).data());
  posix_spawn_file_actions_destroy(&actions);
  if (failure == ENOENT) throw RunError(fmt::format("{0} is not installed: sudo apt-get install {0}", words[0]));
  if (failure != 0) throw RunError(fmt::format("{} cannot be started: {}", words[0], std::strerror(failure)));
  int status = 0;
  while (waitpid(process, &status, 0) < 0)
    if (errno != EINTR) throw RunError(fmt::format("waiting for {} failed: {}", words[0], std::strerror(errno)));
  return status;
}

}  // namespace

void run_gmsh(const fs::path& geo, const fs::path& msh, int dim)
{
  const fs::path folder = fs::absolute(msh).parent_path();
  const fs::path log = fs::path(msh).replace_extension(".log");
  // An old mesh or a missing output folder must not be taken for a result or for a missing program.
  if (!fs::is_directory(folder)) throw RunError(fmt::format("gmsh: there is no folder {} for the mesh", folder.string()));
  if (!fs::is_regular_file(geo)) throw RunError(fmt::format("gmsh: there is no geometry {}", geo.string()));
  fs::remove(msh);
  const int status = run_and_wait({"gmsh", fs::absolute(geo).string(), fmt::format("-{}", dim), "-nt", "1", "-v", "3", "-format", "msh41",
                                   "-o", fs::absolute(msh).string()},
                                  environment_with_home(folder), log);
  if (WIFSIGNALED(status)) throw RunError(fmt::format("gmsh was stopped by signal {} ({})", WTERMSIG(status), strsignal(WTERMSIG(status))));
  if (WEXITSTATUS(status) != 0 || !fs::exists(msh))
    throw RunError(fmt::format("gmsh failed on {} (exit status {}); the end of {}:{}", geo.string(), WEXITSTATUS(status), log.string(),
                               last_lines(log, 8)));
}

}  // namespace berm::mesh
