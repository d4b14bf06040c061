// SPDX-License-Identifier: BSD-3-Clause
#include "jobs/shell.hpp"

#include "jobs/queue_scripts.hpp"
#include "samples/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

namespace berm::jobs::this_file {
namespace {

TEST(Shell, gets_each_word_back_as_it_was)
{
  for (const std::string word : {"plain/file-1.toml", "", "two words", "it's", "$HOME `id` \"x\" \\ ; & | *", "a\tb"}) {
    const ShellEnd end = run_shell("printf %s " + quoted(word));
    EXPECT_EQ(end.out, word);
    EXPECT_EQ(end.status, 0);
  }
  EXPECT_EQ(quoted("plain/file-1.toml"), "plain/file-1.toml");
}

TEST(Shell, tells_how_a_command_ended_and_all_that_it_said)
{
  const ShellEnd end = run_shell("echo one; echo two >&2; exit 3");
  EXPECT_EQ(end.status, 3);
  EXPECT_EQ(end.out, "one\ntwo\n");
  EXPECT_EQ(run_shell("kill -TERM $$").status, 128 + 15);
  EXPECT_EQ(run_shell("no_such_program_as_this").status, 127);
}

// To open a FIFO would wait for who reads it.
TEST(Shell, does_no_job_of_a_queue_whose_messages_go_to_no_regular_file)
{
  const TemporaryFolder place;
  place.write("run_job", run_job_script);
  ASSERT_EQ(::mkfifo((place / "fifo.messages").c_str(), 0600), 0);
  std::filesystem::create_symlink("target", place / "link.messages");
  for (const std::string name : {"fifo", "link"}) {
    const ShellEnd end = run_shell("cd " + quoted(place.path().string()) + " && sh run_job " + name + " echo run");
    EXPECT_EQ(end.status, 1) << end.out;
    EXPECT_NE(end.out.find(name + ".messages: it is not a regular file"), std::string::npos) << end.out;
    EXPECT_EQ(place.read(name + ".status"), "1\n");
  }
  EXPECT_FALSE(std::filesystem::exists(place / "target"));
}

TEST(Shell, knows_which_programs_there_are)
{
  EXPECT_TRUE(has_program("cat"));
  EXPECT_FALSE(has_program("no_such_program_as_this"));
}

TEST(Shell, takes_the_last_line_that_says_something)
{
  EXPECT_EQ(last_line("a\nb\n \n\n"), "b");
  EXPECT_EQ(last_line(""), "");
}

}  // namespace
}  // namespace berm::jobs::this_file
