// SPDX-License-Identifier: BSD-3-Clause
#include "os/child_process.hpp"
#include "os/error.hpp"
#include "os/interrupt.hpp"
#include "samples/processes.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <system_error>

namespace berm::this_file {
namespace {

std::vector<std::string> shell(const std::string& command)
{
  return {"sh", "-c", command};
}

/// Notes its process in a file and does not end.
std::vector<std::string> endless(const std::filesystem::path& file)
{
  return shell("echo $$ > '" + file.string() + "'; exec sleep 1000");
}

TEST(ChildProcess, tells_how_it_ended_and_leaves_what_it_said)
{
  const TemporaryFolder folder;
  const std::string file = (folder / "messages").string();
  EXPECT_EQ(ChildProcess({.words = shell("echo one; echo two >&2; exit 3"), .messages = file}).wait(), 3);
  EXPECT_EQ(folder.read("messages"), "one\ntwo\n");
  EXPECT_EQ(ChildProcess({.words = shell("kill -TERM $$")}).wait(), 128 + SIGTERM);
  EXPECT_EQ(
      ChildProcess(
          {.words = shell("cat; pwd; echo $BERM_WORD"), .messages = file, .folder = folder.path().string(), .environment = {"BERM_WORD=x"}})
          .wait(),
      0);
  EXPECT_EQ(folder.read("messages"), folder.path().string() + "\nx\n") << "and there is nothing to read";
}

TEST(ChildProcess, that_cannot_be_started_says_why)
{
  try {
    ChildProcess child({.words = {"no_such_program_as_this"}});
    FAIL();
  } catch (const std::system_error& error) {
    EXPECT_EQ(error.code().value(), ENOENT);
  }
  EXPECT_THROW(ChildProcess({.words = {"true"}, .messages = "/no/such/folder/messages"}), RunError);
}

// To open a FIFO waits for who reads it, and a link leads anywhere.
TEST(ChildProcess, writes_messages_to_a_regular_file_only)
{
  const TemporaryFolder folder;
  ASSERT_EQ(::mkfifo((folder / "fifo").c_str(), 0600), 0);
  folder.write("target", "kept");
  std::filesystem::create_symlink(folder / "target", folder / "link");
  const auto why = [&](const std::string& file) -> std::string {
    try {
      ChildProcess({.words = {"true"}, .messages = file}).wait();
      return "";
    } catch (const RunError& error) {
      return error.what();
    }
  };
  const std::string fifo = (folder / "fifo").string(), link = (folder / "link").string();
  EXPECT_EQ(why(fifo), "cannot write " + fifo + ": it is not a regular file");
  EXPECT_EQ(why(link), "cannot write " + link + ": it is a link, and berm writes through none");
  EXPECT_EQ(why("/dev/null"), "cannot write /dev/null: it is not a regular file");
  EXPECT_EQ(folder.read("target"), "kept");
}

TEST(ChildProcess, ends_where_its_parent_is_killed)
{
  const TemporaryFolder folder;
  const pid_t parent = fork_to([&] { ChildProcess({.words = endless(folder / "child")}).wait(); });
  const pid_t child = process_in(folder / "child");
  ASSERT_TRUE(is_alive(child));
  ::kill(parent, SIGKILL);
  ::waitpid(parent, nullptr, 0);
  EXPECT_TRUE(wait_until([&] { return !is_alive(child); }));
}

TEST(ChildProcess, is_ended_with_what_it_started_where_nobody_waits_for_it)
{
  const TemporaryFolder folder;
  pid_t child = 0;
  {
    ChildProcess process({.words = shell("sh -c 'echo $$ > " + (folder.path() / "inner").filename().string() + "; exec sleep 1000'; true"),
                          .folder = folder.path().string()});
    child = process_in(folder / "inner");
    ASSERT_TRUE(is_alive(child));
    EXPECT_FALSE(process.has_ended());
  }
  EXPECT_TRUE(wait_until([&] { return !is_alive(child); }));
}

TEST(ChildProcess, is_ended_at_the_first_signal_where_nothing_can_be_kept)
{
  const TemporaryFolder folder;
  const pid_t parent = fork_to([&] {
    catch_interrupts();
    ChildProcess child({.words = endless(folder / "child")});
    try {
      wait_unless_interrupted(child, "a program");
    } catch (const Interrupted& why) {
      ::_exit(std::string(why.what()) == "stopped while a program was running" ? 7 : 8);
    }
  });
  const pid_t child = process_in(folder / "child");
  ::kill(parent, SIGTERM);
  int status = 0;
  ::waitpid(parent, &status, 0);
  EXPECT_EQ(WEXITSTATUS(status), 7);
  EXPECT_FALSE(is_alive(child));
}

TEST(ChildProcess, gets_signals_as_a_program_does_that_a_shell_starts)
{
  const auto before = ::signal(SIGPIPE, SIG_IGN);
  EXPECT_EQ(ChildProcess({.words = shell("kill -PIPE $$")}).wait(), 128 + SIGPIPE);
  ::signal(SIGPIPE, before);
}

}  // namespace
}  // namespace berm::this_file
