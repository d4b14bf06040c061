// SPDX-License-Identifier: BSD-3-Clause
#include "samples/program.hpp"
#include "samples/small_cases.hpp"

#include <gtest/gtest.h>

namespace berm::user_law::this_file {
namespace {

namespace fs = std::filesystem;

/// The small case with a law of tests/samples/trial_laws.cpp in the folder's law.so.
std::string case_with(const std::string& symbol)
{
  std::string text = test::small_case;
  const std::size_t begin = text.find("[material.sand]"), end = text.find("[body.sand]");
  return text.replace(begin, end - begin,
                      "[material.sand]\nlaw = \"user\"\nlibrary = \"law.so\"\nsymbol = \"" + symbol +
                          "\"\nproperties = [7e6, 0.25]\nstate_variables = 1\nstate_names = [\"calls\"]\ncan_yield = false\n"
                          "density = \"877 kg/m^3\"\nyoung_modulus = \"7 MPa\"\npoisson_ratio = 0.25\n\n");
}

class UserLawRun : public testing::Test {
protected:
  void SetUp() override
  {
    fs::create_directory(folder_.path() / "cases");
    fs::copy_file(BERM_TRIAL_LAWS, folder_.path() / "cases" / "law.so");
    write("berm_law");
  }
  void write(const std::string& symbol) { std::ofstream(folder_.path() / "cases" / "case.toml") << case_with(symbol); }
  Ended berm(const std::vector<std::string>& arguments) { return run_program(folder_.path(), arguments); }
  Ended run(const std::string& to, const std::string& threads = "1")
  {
    return berm({"run", "cases/case.toml", "-o", to, "--threads", threads});
  }
  std::string history(const std::string& of) const { return text_of_file(folder_.path() / of / "history.csv"); }

  TemporaryFolder folder_;
};

TEST_F(UserLawRun, gives_the_same_numbers_on_one_thread_and_on_two)
{
  const Ended one = run("one");
  ASSERT_EQ(one.status, 0) << one.err;
  ASSERT_EQ(run("two", "2").status, 0);
  EXPECT_GT(history("one").size(), 1000u);
  EXPECT_EQ(history("one"), history("two"));
}

TEST_F(UserLawRun, gives_the_same_numbers_where_threads_take_turns)
{
  write("works_in_static_memory");
  const Ended one = run("one"), two = run("two", "2");
  ASSERT_EQ(two.status, 0) << two.err;
  EXPECT_NE((two.out + two.err).find("calls are serialised"), std::string::npos) << two.err;
  EXPECT_EQ(history("one"), history("two"));
}

TEST_F(UserLawRun, notes_the_library_and_is_resumed_with_no_other)
{
  ASSERT_EQ(run("run").status, 0);
  EXPECT_NE(text_of_file(folder_.path() / "run" / "origin.json").find("cases/law.so\": \""), std::string::npos);
  Program program(folder_.path(), {"run", "cases/case.toml", "-o", "cut", "--threads", "1", "--set", "stage.drag.until.displacement=0.02"});
  ASSERT_TRUE(wait_until([&] { return fs::exists(folder_.path() / "cut" / "history.csv"); }));
  program.signal(SIGINT);
  ASSERT_NE(program.wait().status, 0);
  std::ofstream(folder_.path() / "cases" / "law.so", std::ios::app | std::ios::binary) << "another";
  const Ended resumed = berm({"run", "--resume", "cut", "--threads", "1"});
  EXPECT_EQ(resumed.status, 2) << resumed.err;
  EXPECT_NE(resumed.err.find("does not have the SHA-256"), std::string::npos) << resumed.err;
}

TEST_F(UserLawRun, that_fails_on_the_way_leaves_what_it_has_and_names_the_law)
{
  write("fails_later");
  const Ended ended = run("run");
  EXPECT_EQ(ended.status, 1);
  EXPECT_NE(ended.err.find("the law \"user\" of [material.sand], fails_later of "), std::string::npos) << ended.err;
  EXPECT_NE(ended.err.find("not a number or infinite"), std::string::npos) << ended.err;
  EXPECT_TRUE(fs::exists(folder_.path() / "run" / "summary.json"));
}

TEST_F(UserLawRun, that_crashes_on_the_way_leaves_a_folder_that_can_be_resumed)
{
  write("crashes_later");
  const Ended ended = run("run");
  EXPECT_EQ(ended.status, 1);
  EXPECT_NE(ended.err.find("crashes_later of "), std::string::npos) << ended.err;
  EXPECT_NE(ended.err.find("crashed: it accessed invalid memory"), std::string::npos) << ended.err;
  // It crashes again, having begun where it was.
  const Ended again = berm({"run", "--resume", "run", "--threads", "1"});
  EXPECT_EQ(again.status, 1);
  EXPECT_NE(again.err.find("crashed: it accessed invalid memory"), std::string::npos) << again.err;
}

TEST_F(UserLawRun, without_its_library_is_refused_with_the_line)
{
  fs::remove(folder_.path() / "cases" / "law.so");
  const Ended ended = berm({"check", "cases/case.toml"});
  EXPECT_EQ(ended.status, 2);
  EXPECT_NE(ended.err.find("material.sand.library: there is no "), std::string::npos) << ended.err;
  EXPECT_NE(ended.err.find("case.toml:13"), std::string::npos) << ended.err;
}

}  // namespace
}  // namespace berm::user_law::this_file
