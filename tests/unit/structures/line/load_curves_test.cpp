// SPDX-License-Identifier: BSD-3-Clause
#include "structures/line/load_curves.hpp"

#include "samples/made_line_run.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace berm::line::this_file {
namespace {

using test::MadeLineRun;

TEST(LoadCurves, of_a_heated_line_are_over_temperature_with_springs_and_hobbs_beside)
{
  const TemporaryFolder folder;
  MadeLineRun made;
  made.springs = true;
  const LoadCurves curves = load_curves(made.record(folder));
  EXPECT_EQ(curves.x_title, "rise of temperature (K)");
  ASSERT_EQ(curves.panels.size(), 3u);
  EXPECT_EQ(curves.panels[0].curves.size(), 4u) << "P0, the line, springs, Hobbs";
  const LoadCurve& y = curves.panels[1].curves.front();
  EXPECT_EQ(y.x.size(), 30u);
  EXPECT_NEAR(y.x[9], MadeLineRun::hot, 1e-9);
  EXPECT_NEAR(y.y[9], 1.9, 1e-9);
  const LoadCurve& hobbs = curves.panels[1].curves.back();
  EXPECT_EQ(hobbs.by, LoadCurve::By::hobbs);
  EXPECT_LT(hobbs.x.size(), 10u) << "below the smallest force there is no buckle, and only the first heating counts";
  EXPECT_TRUE(std::is_sorted(hobbs.y.begin(), hobbs.y.end()));
}

TEST(LoadCurves, of_a_line_without_heat_and_pressure_are_over_time)
{
  const TemporaryFolder folder;
  record::RunRecord run = MadeLineRun{}.record(folder);
  for (const char* column : {"line_T_K", "line_P0_N"})
    for (std::size_t c = 0; c < run.history.columns.size(); ++c)
      if (run.history.columns[c].name == column) std::ranges::fill(run.history.values[c], 0);
  const LoadCurves curves = load_curves(run);
  EXPECT_EQ(curves.x_title, "time (s)");
  EXPECT_NE(curves.panels[1].curves.back().by, LoadCurve::By::hobbs);
}

TEST(LoadCurves, stand_on_the_page_as_one_drawing)
{
  const TemporaryFolder folder;
  record::RunRecord run = MadeLineRun{}.record(folder);
  const std::string svg = load_chart(run);
  for (const char* words : {"compression P (kN)", "lateral displacement y (m)", "Hobbs, far_soil 0.6 W", "rise of temperature (K)"})
    EXPECT_NE(svg.find(words), std::string::npos) << words;
  run.history.stage.assign(run.history.stage.size(), "lay");
  EXPECT_EQ(load_chart(run), "") << "not loaded";
}

}  // namespace
}  // namespace berm::line::this_file
