// SPDX-License-Identifier: BSD-3-Clause
#include "input/load_history.hpp"

#include "core/error.hpp"
#include "samples/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace berm::input::this_file {
namespace {

using problem::load_factor;

class LoadHistory : public testing::Test {
protected:
  problem::StageSettings read(const std::string& text, std::optional<Real> time = {})
  {
    folder_.write("storm.csv", text);
    problem::StageSettings stage;
    stage.name = "storm";
    stage.load_history = "storm.csv";
    stage.until.time = time;
    read_load_history(stage, 0, folder_.path());
    return stage;
  }
  std::string refusal(const std::string& text)
  {
    try {
      read(text);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
  TemporaryFolder folder_;
};

TEST_F(LoadHistory, is_read_beside_the_case)
{
  const problem::StageSettings stage = read("time, factor\n# a comment\n0, 0\r\n\n0.5 , 1.5\n2,-1\n");
  EXPECT_EQ(stage.load_times, (std::vector<Real>{0, 0.5, 2}));
  EXPECT_EQ(stage.load_factors, (std::vector<Real>{0, 1.5, -1}));
  EXPECT_TRUE(stage.load_history.empty()) << "a resolved case needs no file";
  EXPECT_EQ(stage.until.time, 2) << "the stage ends with it at the latest";
}

TEST_F(LoadHistory, ends_its_stage_at_its_last_time_or_at_the_time_of_the_stage_whichever_is_first)
{
  EXPECT_EQ(read("0,0\n2,1\n", 1.5).until.time, 1.5);
  EXPECT_EQ(read("0,0\n2,1\n", 3).until.time, 2);
}

TEST_F(LoadHistory, is_linear_between_its_times_and_constant_after)
{
  const problem::StageSettings stage = read("1,2\n3,6\n");
  EXPECT_EQ(load_factor(stage, 0), 2);
  EXPECT_EQ(load_factor(stage, 1), 2);
  EXPECT_EQ(load_factor(stage, 2), 4);
  EXPECT_EQ(load_factor(stage, 3), 6);
  EXPECT_EQ(load_factor(stage, 9), 6);
  EXPECT_EQ(load_factor(problem::StageSettings{}, 9), 1);
}

TEST_F(LoadHistory, that_is_wrong_is_refused_with_its_line)
{
  EXPECT_NE(refusal("0,1\n1,x\n").find("storm.csv:2: a line of a load history is two numbers"), std::string::npos);
  EXPECT_NE(refusal("0,1\n0,2\n").find("storm.csv:2: times must ascend"), std::string::npos);
  EXPECT_NE(refusal("0\n").find("storm.csv:1: "), std::string::npos);
  EXPECT_NE(refusal("0,nan\n").find("storm.csv:1: "), std::string::npos);
  EXPECT_NE(refusal("-1,1\n").find("storm.csv:1: times count from the begin"), std::string::npos);
  EXPECT_NE(refusal("0,1\n").find("storm.csv: has no line"), std::string::npos);
  EXPECT_NE(refusal("time,factor\n").find("storm.csv: has no line"), std::string::npos);
  problem::StageSettings stage;
  stage.name = "storm";
  stage.load_history = "none.csv";
  EXPECT_THROW(read_load_history(stage, 0, folder_.path()), InputError);
}

}  // namespace
}  // namespace berm::input::this_file
