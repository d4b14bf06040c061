// SPDX-License-Identifier: BSD-3-Clause
#include "io/scratch_folder.hpp"
#include "samples/processes.hpp"

#include <gtest/gtest.h>

namespace berm::io::this_file {
namespace {

TEST(ScratchFolder, goes_with_its_object)
{
  std::filesystem::path path;
  {
    const ScratchFolder scratch;
    path = scratch.path();
    std::ofstream(path / "file") << "x";
    EXPECT_TRUE(std::filesystem::exists(path / "file"));
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(ScratchFolder, goes_where_the_program_is_killed)
{
  for (const int signal : {SIGTERM, SIGKILL}) {
    const TemporaryFolder folder;
    const pid_t program = fork_to([&] {
      const ScratchFolder scratch;
      std::ofstream(scratch.path() / "file") << "x";
      std::filesystem::create_symlink(scratch.path(), folder / "scratch");
      ::pause();
    });
    ASSERT_TRUE(wait_until([&] { return std::filesystem::is_symlink(folder / "scratch"); }));
    const std::filesystem::path path = std::filesystem::read_symlink(folder / "scratch");
    EXPECT_TRUE(std::filesystem::exists(path / "file"));
    ::kill(program, signal);
    ::waitpid(program, nullptr, 0);
    EXPECT_TRUE(wait_until([&] { return !std::filesystem::exists(path); })) << signal;
  }
}

}  // namespace
}  // namespace berm::io::this_file
