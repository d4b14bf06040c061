// SPDX-License-Identifier: BSD-3-Clause
// `berm new`, from outside.
#include "samples/program.hpp"

#include <gtest/gtest.h>

namespace berm::commands::this_file {
namespace {

namespace fs = std::filesystem;

class New : public testing::Test {
protected:
  Ended berm(const std::vector<std::string>& arguments) const { return run_program(folder_.path(), arguments); }
  TemporaryFolder folder_;
};

/// The kinds that the command lists.
std::vector<std::string> kinds_in(const std::string& list)
{
  std::vector<std::string> kinds;
  std::istringstream lines(list);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("  ")) kinds.push_back(line.substr(2, line.find(' ', 2) - 2));
  return kinds;
}

TEST_F(New, lists_its_kinds)
{
  const Ended ended = berm({"new"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  const std::vector<std::string> kinds = kinds_in(ended.out);
  for (const char* kind : {"cable-in-sand", "pipe-in-clay", "pipe-in-sand"})
    EXPECT_NE(std::find(kinds.begin(), kinds.end(), kind), kinds.end()) << kind << " is not in\n" << ended.out;
}

TEST_F(New, writes_a_case_that_check_takes_without_a_doubt)
{
  for (const std::string& kind : kinds_in(berm({"new"}).out)) {
    const Ended written = berm({"new", kind});
    ASSERT_EQ(written.status, 0) << written.err;
    ASSERT_TRUE(fs::exists(folder_ / (kind + ".toml")));
    const Ended checked = berm({"check", kind + ".toml", "--threads", "1"});
    EXPECT_EQ(checked.status, 0) << checked.err;
    EXPECT_EQ(checked.err.find("warning"), std::string::npos) << checked.err;
  }
}

TEST_F(New, writes_to_the_file_that_is_named)
{
  const Ended ended = berm({"new", "pipe-in-clay", "my case.toml"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_TRUE(fs::exists(folder_ / "my case.toml"));
}

TEST_F(New, replaces_nothing)
{
  folder_.write("pipe-in-clay.toml", "mine");
  const Ended ended = berm({"new", "pipe-in-clay"});
  EXPECT_EQ(ended.status, 2);
  EXPECT_NE(ended.err.find("pipe-in-clay.toml is there already"), std::string::npos) << ended.err;
  EXPECT_EQ(folder_.read("pipe-in-clay.toml"), "mine");
}

TEST_F(New, refuses_a_kind_that_it_does_not_know)
{
  const Ended ended = berm({"new", "pipe-in-cly"});
  EXPECT_EQ(ended.status, 2);
  EXPECT_NE(ended.err.find("did you mean \"pipe-in-clay\""), std::string::npos) << ended.err;
}

}  // namespace
}  // namespace berm::commands::this_file
