// SPDX-License-Identifier: BSD-3-Clause
#include "input/pipeline_tables.hpp"

#include "samples/error_of.hpp"
#include "samples/small_cases.hpp"
#include "samples/temporary_folder.hpp"

#include "input/read_case.hpp"
#include "input/write_case.hpp"

#include <gtest/gtest.h>

namespace berm::input::this_file {
namespace {

class PipelineTables : public testing::Test {
protected:
  /// The small line with a route or a curve in a file.
  settings::Case read(const char* key, const std::string& text)
  {
    folder_.write("table.csv", text);
    return read_case_text((folder_ / "line.toml").string(), test::small_line_case,
                          {std::string(key) + ".table=\"table.csv\"", "pipeline.imperfection.amplitude=0", "pipeline.half=\"none\""});
  }
  std::string refusal(const char* key, const std::string& text)
  {
    return test::error_of<InputError>([&] { read(key, text); });
  }

  TemporaryFolder folder_;
  const char *route_ = "pipeline.route", *curve_ = "pipeline.far_soil.lateral";
};

TEST_F(PipelineTables, are_the_numbers_of_the_case_in_the_units_of_their_columns)
{
  const settings::Route route = read(route_, "# as it was surveyed\nx_km,y_mm\n0,5\n1,-2\n").pipeline->route;
  EXPECT_EQ(route.x, (std::vector<Real>{0, 1000}));
  EXPECT_EQ(route.y, (std::vector<Real>{0.005, -0.002}));
  EXPECT_EQ(route.table, "");
  const settings::LateralCurve curve = read(curve_, "u_mm;H_kN_m\n5;0.9\n400;1.2\n").pipeline->far_soil.lateral;
  EXPECT_EQ(curve.x, (std::vector<Real>{0.005, 0.4}));
  EXPECT_EQ(curve.y, (std::vector<Real>{900, 1200}));
}

TEST_F(PipelineTables, stand_in_the_resolved_case_which_needs_no_file)
{
  const std::string resolved = resolved_toml(read(curve_, "u_m,H_N_m\n0.005,900\n0.4,1200\n"));
  const settings::Case again = read_case_text("resolved.toml", resolved, {});
  EXPECT_EQ(again.pipeline->far_soil.lateral.x, (std::vector<Real>{0.005, 0.4}));
  EXPECT_EQ(again.pipeline->far_soil.lateral.y, (std::vector<Real>{900, 1200}));
}

TEST_F(PipelineTables, that_are_wrong_are_refused_with_file_and_line)
{
  const auto says = [&](const char* key, const std::string& text, const std::string& words) {
    const std::string answer = refusal(key, text);
    EXPECT_NE(answer.find("table.csv:" + words), std::string::npos) << text << ": " << answer;
  };
  says(route_, "x_m,y_m\n0,1\n5,2\n5,3\n", "4: 5 m follows 5 m: the first column must ascend");
  says(route_, "x_m,y_m\n1,1\n5,2\n", "2: a route must begin at x = 0");
  says(route_, "time_s,y_m\n0,1\n5,2\n", "1: the first column is the position along the line, \"x_m\", and not \"time_s\"");
  says(route_, "x_m\n0\n5\n", "1: names no column after the position along the line, such as x_m,y_m");
  says(route_, "x_m,z_m\n0,1\n5,2\n", "1: \"z_m\" is not a column of this route");
  says(route_, "x_s,y_m\n0,1\n5,2\n", "1: \"x_s\" has no unit of a length");
  says(route_, "0,1\n5,2\n", "1: the first line must name the columns: x_m,y_m");
  says(route_, "x_m,y_m\n0,1\n", " has one line of numbers: it needs two at least");
  says(curve_, "u_m,H_N_m\n0,0\n1,2\n", "2: the point 0, 0 of a curve is implied");
  says(curve_, "u_m,H_N_m\n1,2\n2,-1\n", "3: a resistance must be more than 0");
  says(curve_, "u_m,H_N\n1,2\n2,1\n", "1: \"H_N\" has no unit of a force per length");
}

TEST_F(PipelineTables, that_are_not_there_are_refused_with_the_key)
{
  const std::string answer = test::error_of<InputError>(
      [&] { read_case_text((folder_ / "line.toml").string(), test::small_line_case, {"pipeline.far_soil.lateral.table=\"none.csv\""}); });
  EXPECT_NE(answer.find("pipeline.far_soil.lateral.table: "), std::string::npos) << answer;
  EXPECT_NE(answer.find("none.csv"), std::string::npos) << answer;
}

}  // namespace
}  // namespace berm::input::this_file
