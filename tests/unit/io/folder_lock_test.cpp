// SPDX-License-Identifier: BSD-3-Clause
#include "io/folder_lock.hpp"

#include "os/error.hpp"
#include "samples/temporary_folder.hpp"

#include <csignal>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace berm::io::this_file {
namespace {

std::string refusal(const std::filesystem::path& folder)
{
  try {
    const FolderLock lock(folder);
  } catch (const RunError& error) {
    return error.what();
  }
  return "";
}

TEST(FolderLock, refuses_a_second_owner_and_names_the_first)
{
  const TemporaryFolder base;
  const FolderLock lock(base.path());
  const std::string message = refusal(base.path());
  EXPECT_NE(message.find("another run is writing into it"), std::string::npos) << message;
  EXPECT_NE(message.find("process " + std::to_string(::getpid()) + " on "), std::string::npos) << message;
}

TEST(FolderLock, leaves_nothing_behind_and_can_be_had_again)
{
  const TemporaryFolder base;
  for (int n = 0; n < 2; ++n) {
    EXPECT_EQ(refusal(base.path()), "");
    EXPECT_TRUE(std::filesystem::is_empty(base.path()));
  }
}

TEST(FolderLock, dies_with_its_process)
{
  const TemporaryFolder base;
  int ready[2];
  ASSERT_EQ(::pipe(ready), 0);
  const pid_t owner = ::fork();
  if (owner == 0) {
    const FolderLock lock(base.path());
    if (::write(ready[1], "!", 1) == 1) ::pause();
    ::_exit(1);
  }
  char sign = 0;
  ASSERT_EQ(::read(ready[0], &sign, 1), 1);
  EXPECT_NE(refusal(base.path()).find("process " + std::to_string(owner)), std::string::npos);
  ::kill(owner, SIGKILL);
  ::waitpid(owner, nullptr, 0);
  EXPECT_TRUE(std::filesystem::exists(base.path() / FolderLock::file_name));
  EXPECT_EQ(refusal(base.path()), "");
  ::close(ready[0]);
  ::close(ready[1]);
}

}  // namespace
}  // namespace berm::io::this_file
