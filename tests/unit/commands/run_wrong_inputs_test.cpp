// SPDX-License-Identifier: BSD-3-Clause
// What the program does with wrong input: status 2, one line, nothing written.
#include "samples/program.hpp"
#include "samples/small_cases.hpp"
#include "samples/wrong_inputs.hpp"

#include <gtest/gtest.h>

namespace berm::commands::this_file {
namespace {

using test::WrongInput;

std::vector<std::string> arguments_for(const char* command, const std::vector<std::string>& overrides)
{
  std::vector<std::string> arguments = {command, "case.toml"};
  for (const std::string& override : overrides) arguments.insert(arguments.end(), {"--set", override});
  if (command == std::string("run")) arguments.insert(arguments.end(), {"-o", "results"});
  return arguments;
}

void expect_refused(const TemporaryFolder& folder, const std::vector<std::string>& arguments, const std::vector<std::string>& says)
{
  const auto before = names_in(folder.path());
  const Ended ended = run_program(folder.path(), arguments);
  EXPECT_EQ(ended.status, 2);
  EXPECT_EQ(ended.out, "");
  EXPECT_EQ(ended.err.find("berm: "), 0u) << ended.err;
  EXPECT_EQ(ended.err.find('\n'), ended.err.size() - 1) << "more or less than one line: " << ended.err;
  for (const std::string& part : says) EXPECT_NE(ended.err.find(part), std::string::npos) << "no `" << part << "` in: " << ended.err;
  EXPECT_EQ(names_in(folder.path()), before) << "something was written";
}

class WrongInputs : public testing::TestWithParam<WrongInput> {};

TEST_P(WrongInputs, end_run_and_check_with_status_2_one_line_and_nothing_written)
{
  const WrongInput& wrong = GetParam();
  TemporaryFolder folder;
  folder.write("case.toml", text_of(wrong));
  auto says = wrong.says;
  if (wrong.line > 0) says.push_back("berm: case.toml:" + std::to_string(wrong.line) + ": ");
  for (const char* command : {"run", "check"}) expect_refused(folder, arguments_for(command, wrong.overrides), says);
}

INSTANTIATE_TEST_SUITE_P(Table, WrongInputs, testing::ValuesIn(test::wrong_inputs()),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(WrongInput, of_a_name_that_the_mesh_does_not_have_leaves_no_run_folder)
{
  TemporaryFolder folder;
  folder.write("case.toml", test::small_case);
  expect_refused(folder, arguments_for("run", {"support.left.boundary=west"}), {"support.left.boundary", "left, right, bottom, top"});
  expect_refused(folder, arguments_for("check", {"support.left.boundary=west"}), {"support.left.boundary", "left, right, bottom, top"});
}

TEST(Run, of_a_stage_of_unknown_duration_writes_a_history_all_the_same)
{
  // How long a stage takes that ends at a force cannot be told.
  TemporaryFolder folder;
  std::string text = test::small_case;
  const auto replace = [&](const std::string& from, const std::string& to) { text.replace(text.find(from), from.size(), to); };
  replace("history_time = \"0.05 ms\"\n", "");
  replace("until.embedment = \"2 mm\"", "until.force = \"1 kN/m\"");
  folder.write("case.toml", text);
  ASSERT_EQ(run_program(folder.path(), arguments_for("run", {})).status, 0);
  EXPECT_GT(text_of_file(folder / "results/history.csv").size(), 10000u);
}

TEST(WrongInput, of_a_file_that_is_missing_or_a_folder)
{
  TemporaryFolder folder;
  std::filesystem::create_directory(folder / "case.toml");
  for (const char* command : {"run", "check"}) {
    expect_refused(folder, arguments_for(command, {}), {"case.toml", "folder"});
    expect_refused(folder, {command, "nothing.toml"}, {"nothing.toml", "no such file"});
  }
}

TEST(WrongInput, of_the_second_case_keeps_the_first_from_running)
{
  TemporaryFolder folder;
  folder.write("first.toml", test::small_case);
  std::string text = test::small_case;
  text.replace(text.find("mohr_coulomb"), 4, "more");
  folder.write("second.toml", text);
  expect_refused(folder, {"run", "first.toml", "second.toml", "-o", "results"}, {"second.toml:12: "});
}

TEST(WrongInput, of_two_cases_that_would_share_a_folder)
{
  TemporaryFolder folder;
  std::filesystem::create_directory(folder / "other");
  folder.write("case.toml", test::small_case);
  folder.write("other/case.toml", test::small_case);
  expect_refused(folder, {"run", "case.toml", "other/case.toml", "-o", "all"}, {"case.toml", "other/case.toml", "all/case"});
}

TEST(WrongInput, of_the_command_line_ends_with_status_2)
{
  TemporaryFolder folder;
  folder.write("case.toml", test::small_case);
  using Words = std::vector<std::string>;
  for (const Words& arguments :
       {Words{}, Words{"walk"}, Words{"run"}, Words{"run", "case.toml", "--colour"}, Words{"run", "case.toml", "--threads", "0"},
        Words{"run", "case.toml", "--threads", "many"}, Words{"params", "--schema", "nothing"}, Words{"--nothing"}}) {
    const Ended ended = run_program(folder.path(), arguments);
    EXPECT_EQ(ended.status, 2) << testing::PrintToString(arguments);
    EXPECT_FALSE(ended.err.empty());
    EXPECT_EQ(names_in(folder.path()), (Words{"case.toml"}));
  }
}

}  // namespace
}  // namespace berm::commands::this_file
