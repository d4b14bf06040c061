// SPDX-License-Identifier: BSD-3-Clause
#include "springs/line_formats.hpp"

#include "os/error.hpp"
#include "samples/error_of.hpp"
#include "samples/made_line_run.hpp"
#include "structures/structures.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <sstream>

namespace berm::springs::this_file {
namespace {

using test::MadeLineRun;

class LineFormats : public testing::Test {
protected:
  /// A made run whose slices all do the same.
  record::RunRecord record_of(const MadeLineRun& made)
  {
    record::RunRecord run = made.record(folder_);
    for (const std::string end : {"u_m", "w_m", "H_N_m", "V_N_m"}) {
      const std::vector<Real> values = run.history[end];
      run_folder::Column column = run.history.column(end);
      for (int k = 1; k <= 8; ++k) {
        column.name = fmt::format("slice_{}_{}", k, end);
        run.history.columns.push_back(column), run.history.values.push_back(values);
      }
    }
    return run;
  }
  /// The lines that are no comment.
  static std::vector<std::string> rows_of(const std::string& text)
  {
    std::vector<std::string> rows;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
      if (!line.starts_with('#')) rows.push_back(line);
    return rows;
  }
  TemporaryFolder folder_;
};

TEST_F(LineFormats, shapes_are_one_table_that_names_its_run)
{
  const ExportFiles files = shape_files(record_of({}));
  ASSERT_EQ(files.size(), 1u);
  EXPECT_EQ(files[0].name, "line.csv");
  EXPECT_TRUE(files[0].text.starts_with("# written by berm"));
  EXPECT_NE(files[0].text.find("\n# run made\n"), std::string::npos);
  const std::vector<std::string> rows = rows_of(files[0].text);
  EXPECT_EQ(rows.front(), "time_s,stage,x_m,y_m,z_m,u_m,P_N,M_Nm");
  EXPECT_EQ(rows.size(), 1u + 3 * 751);
  EXPECT_TRUE(rows[1].ends_with(",heat,0,1.9,0,-0.1,600000,500000")) << rows[1];
}

TEST_F(LineFormats, curves_are_those_of_the_run_folder)
{
  const record::RunRecord run = record_of({});
  const ExportFiles files = curve_files(run);
  ASSERT_EQ(files.size(), 1u);
  EXPECT_EQ(files[0].name, "curves.json");
  EXPECT_EQ(files[0].text, structures::curves_json(run));
  EXPECT_NE(files[0].text.find("\"chart\":\"P_load\""), std::string::npos);
}

TEST_F(LineFormats, slices_have_their_rows_and_the_backbone_of_the_way_that_is_farther_than_before)
{
  const ExportFiles files = py_files(record_of({}));
  ASSERT_EQ(files.size(), 2u);
  const std::vector<std::string> rows = rows_of(files[0].text), backbone = rows_of(files[1].text);
  EXPECT_EQ(rows.front(), "slice,x_m,time_s,stage,u_m,w_m,H_N_m,V_N_m");
  EXPECT_EQ(rows.size(), 1u + 9 * 30);
  EXPECT_TRUE(rows[1 + 3 * 30].starts_with("3,24,")) << rows[1 + 3 * 30];
  EXPECT_EQ(backbone.front(), "slice,x_m,side,u_m,H_N_m,V_N_m");
  EXPECT_EQ(std::ranges::count_if(backbone, [](const std::string& row) { return row.starts_with("8,64,+x,"); }), 12)
      << "ten rows of the first heating, the last two of the second, none on the way back";
  EXPECT_EQ(std::ranges::count_if(backbone, [](const std::string& row) { return row.find("-x") != std::string::npos; }), 0);
  EXPECT_EQ(backbone.back(), "8,64,+x,1.45,900,1500") << "from the first row on the line";
}

TEST_F(LineFormats, a_run_of_no_pipeline_and_one_that_has_not_come_to_its_line_are_refused)
{
  record::RunRecord run = record_of({});
  run.history.stage.assign(run.history.stage.size(), "lay");
  EXPECT_NE(test::error_of<RunError>([&] { shape_files(run); }).find("has not reached its line"), std::string::npos);
  EXPECT_NE(test::error_of<RunError>([&] { py_files(run); }).find("has not reached its line"), std::string::npos);
  run.settings.pipeline.reset();
  EXPECT_NE(test::error_of<InputError>([&] { py_files(run); }).find("its case has no [pipeline]"), std::string::npos);
}

}  // namespace
}  // namespace berm::springs::this_file
