// SPDX-License-Identifier: BSD-3-Clause
#include "structures/line/load_curves.hpp"

#include "samples/drawn_run.hpp"
#include "samples/made_line_run.hpp"
#include "structures/structures.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace berm::line::this_file {
namespace {

using test::MadeLineRun;

class LoadPicture : public DrawnRun {};

TEST(LoadCurves, of_a_heated_line_are_over_temperature_with_springs_and_hobbs_beside)
{
  const TemporaryFolder folder;
  MadeLineRun made;
  made.springs = true;
  const record::RunRecord run = made.record(folder);
  const base::Charts charts = load_charts(run);
  ASSERT_EQ(charts.size(), 3u);
  EXPECT_EQ(charts[0].id, "P_load");
  EXPECT_EQ(charts[0].x.words, "rise of temperature");
  EXPECT_EQ(charts[0].y.unit, "N");
  EXPECT_EQ(charts[0].curves.size(), 4u) << "P0, the line, springs, Hobbs";
  EXPECT_EQ(charts[0].curves[1].y[9], run.history["line_P_N"][charts[0].curves[1].rows[9]]);
  const base::Curve& y = charts[1].curves.front();
  EXPECT_EQ(y.x.size(), 30u);
  EXPECT_NEAR(y.x[9], MadeLineRun::hot, 1e-9);
  EXPECT_NEAR(y.y[9], 1.9, 1e-9);
  const base::Curve& hobbs = charts[1].curves.back();
  EXPECT_EQ(hobbs.name, "Hobbs, far_soil 0.6 W");
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
  const base::Charts charts = load_charts(run);
  EXPECT_EQ(charts[0].x.unit, "s");
  EXPECT_FALSE(charts[1].curves.back().name.starts_with("Hobbs"));
}

TEST(LoadCurves, are_charts_of_the_page_once_the_line_is_loaded)
{
  const TemporaryFolder folder;
  record::RunRecord run = MadeLineRun{}.record(folder);
  const base::Charts charts = structures::structure_of(run.settings).charts(run);
  ASSERT_EQ(charts.size(), 3u);
  EXPECT_EQ(charts[2].title, "Line: M(T)");
  run.history.stage.assign(run.history.stage.size(), "lay");
  EXPECT_TRUE(load_charts(run).empty()) << "not loaded";
}

TEST_F(LoadPicture, has_the_units_of_its_titles)
{
  if (!gnuplot_is_there()) GTEST_SKIP() << "gnuplot is not installed";
  const TemporaryFolder shapes;
  const record::RunRecord run = MadeLineRun{}.record(shapes);
  ASSERT_TRUE(draw_load_curves(folder, run));
  const std::string script = content_of(folder.file("plots/curves.gp")), data = content_of(folder.file("plots/curves.dat"));
  for (const char* words : {"compression P (kN)", "lateral displacement y (m)", "Hobbs, far_soil 0.6 W", "rise of temperature (K)"})
    EXPECT_NE(script.find(words), std::string::npos) << words;
  EXPECT_NE(data.find("# compression P (kN), line on slices\n"), std::string::npos);
  const std::string last = fmt::format("\n{:.8g} {:.8g}\n", run.history["line_T_K"].back(), run.history["line_P_N"].back() / 1e3);
  EXPECT_NE(data.find(last), std::string::npos) << last;
}

}  // namespace
}  // namespace berm::line::this_file
