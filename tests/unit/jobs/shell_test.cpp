// SPDX-License-Identifier: BSD-3-Clause
#include "jobs/shell.hpp"

#include <gtest/gtest.h>

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
