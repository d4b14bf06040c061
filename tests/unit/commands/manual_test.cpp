// SPDX-License-Identifier: BSD-3-Clause
// Manual pages and completion, as the program prints them and as man and bash take them.
#include "samples/program.hpp"

#include <gtest/gtest.h>

namespace berm::this_file {
namespace {

/// What a line of bash prints, and its status.
Ended bash(const TemporaryFolder& folder, const std::string& line)
{
  const std::string command = "cd '" + folder.path().string() + "' && bash -c '" + line + "' > out.txt 2> err.txt";
  const int status = std::system(command.c_str());
  return {WEXITSTATUS(status), folder.read("out.txt"), folder.read("err.txt")};
}

class Completion : public testing::Test {
protected:
  Completion() { folder_.write("berm.bash", run_program(folder_.path(), {"completion", "bash"}).out); }

  /// What the words of a line, the last of which is being typed, are completed to.
  std::string of(const std::string& words, int count) const
  {
    const Ended ended =
        bash(folder_, "source berm.bash; COMP_WORDS=(" + words + "); COMP_CWORD=" + std::to_string(count - 1) +
                          "; [ ${#COMP_WORDS[@]} -eq " + std::to_string(count) + " ] || COMP_WORDS+=(\"\"); _berm; echo ${COMPREPLY[@]}");
    EXPECT_EQ(ended.status, 0) << ended.err;
    return ended.out;
  }

  TemporaryFolder folder_;
};

TEST_F(Completion, of_bash_knows_commands_options_and_words)
{
  EXPECT_EQ(of("berm ru", 2), "run\n");
  EXPECT_EQ(of("berm run --unc", 3), "--uncertainty\n");
  EXPECT_EQ(of("berm export out --to or", 5), "orcaflex\n");
  EXPECT_EQ(of("berm completion z", 3), "zsh\n");
  EXPECT_EQ(of("berm new pipe-in-s", 3), "pipe-in-sand\n");
  const std::string all = of("berm", 2);
  for (const char* command : {"new", "check", "run", "report", "study", "envelope", "safety", "element", "verify", "params"})
    EXPECT_NE(all.find(command), std::string::npos) << command << " in " << all;
}

TEST_F(Completion, of_other_shells_names_every_command_and_its_options)
{
  for (const char* shell : {"zsh", "fish"}) {
    const std::string script = run_program(folder_.path(), {"completion", shell}).out;
    for (const char* word : {"run", "export", "uncertainty", "orcaflex"})
      EXPECT_NE(script.find(word), std::string::npos) << shell << ": " << word;
  }
  EXPECT_EQ(run_program(folder_.path(), {"completion", "csh"}).status, 2);
}

TEST(Manual, has_a_page_for_each_command_which_man_takes_without_a_warning)
{
  const TemporaryFolder folder;
  ASSERT_EQ(run_program(folder.path(), {"man", "pages"}).status, 0);
  const auto names = names_in(folder / "pages");
  EXPECT_TRUE(std::count(names.begin(), names.end(), "berm.1") == 1 && std::count(names.begin(), names.end(), "berm-run.1") == 1);
  EXPECT_NE(folder.read("pages/berm-export.1").find("orcaflex"), std::string::npos);
  EXPECT_NE(folder.read("pages/berm-run.1").find("\\-\\-resume"), std::string::npos);
  if (std::system("command -v groff >/dev/null 2>&1") != 0) GTEST_SKIP() << "groff is not installed";
  const Ended groff = bash(folder, "for page in pages/*.1; do groff -man -Tutf8 -ww \"$page\" >/dev/null || exit 1; done");
  EXPECT_EQ(groff.status, 0);
  EXPECT_EQ(groff.err, "");
}

}  // namespace
}  // namespace berm::this_file
