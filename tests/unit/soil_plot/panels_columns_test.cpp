// SPDX-License-Identifier: BSD-3-Clause
#include "soil_plot/panels.hpp"

#include "samples/drawn_run.hpp"

namespace berm::soil_plot::this_file {
namespace {

using ColumnsPlot = DrawnRun;

TEST_F(ColumnsPlot, any_columns_are_drawn_against_time)
{
  if (!gnuplot_is_there()) GTEST_SKIP() << "gnuplot is not installed";
  ASSERT_TRUE(draw_columns(folder, pipe_history(0.01), {"u_m", "w_m", "H_N_m"}, "columns"));
  EXPECT_EQ(png_size(folder.file("curves.png")), (std::pair{1200, 900}));
  EXPECT_NE(content_of(folder.file("plots/curves.gp")).find("set ylabel 'H (N/m)'"), std::string::npos);
}

TEST_F(ColumnsPlot, of_nothing_there_is_no_picture)
{
  EXPECT_FALSE(draw_columns(folder, empty_history(), {"u_m"}, "nothing"));
}

}  // namespace
}  // namespace berm::soil_plot::this_file
