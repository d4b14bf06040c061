// SPDX-License-Identifier: BSD-3-Clause
#include "structures/driven/curves.hpp"

#include "samples/drawn_run.hpp"
#include "structures/driven/run_charts.hpp"

namespace berm::driven::this_file {
namespace {

namespace fs = std::filesystem;

using PipeCurves = DrawnRun;

const base::BodyScale scale{.width = 0.02, .unit_weight = 430e3, .gravity_level = 50};
const Stages stages{Stage{.name = "push", .kind = settings::StageKind::push}, Stage{.name = "drag", .kind = settings::StageKind::drag}};

TEST_F(PipeCurves, the_curves_of_a_pipe_are_drawn_with_and_without_a_drag)
{
  if (!gnuplot_is_there()) GTEST_SKIP() << "gnuplot is not installed";
  for (const Real drag : {0.01, 0.}) {
    fs::remove(folder.file("curves.png"));
    ASSERT_TRUE(draw_run_curves(folder, run_charts(pipe_history(drag), scale, stages), scale, "it's a pipe", {}));
    EXPECT_EQ(png_size(folder.file("curves.png")), (std::pair{1200, 900}));
  }
  EXPECT_TRUE(fs::exists(folder.file("plots/curves.dat")));
  EXPECT_TRUE(fs::exists(folder.file("plots/curves.gp")));
  EXPECT_FALSE(fs::exists(folder.file("plots/curves.messages")));
}

TEST_F(PipeCurves, bands_are_filled_under_the_curves)
{
  if (!gnuplot_is_there()) GTEST_SKIP() << "gnuplot is not installed";
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  const std::vector<run_folder::CurveBand> bands = {{"V_w", {0, 0.001, 0.002}, {nan, 100, 200}, {nan, 300, 500}}};
  ASSERT_TRUE(draw_run_curves(folder, run_charts(pipe_history(0.01), scale, stages), scale, "a pipe", bands));
  EXPECT_EQ(content_of(folder.file("plots/band_V_w.dat")), "1 0.1\n2 0.2\n2 0.5\n1 0.3\n");
  const std::string script = content_of(folder.file("plots/curves.gp"));
  EXPECT_NE(script.find("'band_V_w.dat' using 2:1 with filledcurves"), std::string::npos) << script;
  EXPECT_EQ(script.find("band_H_u"), std::string::npos);
  EXPECT_EQ(png_size(folder.file("curves.png")), (std::pair{1200, 900}));
}

TEST_F(PipeCurves, of_a_body_with_ends_have_forces_and_not_forces_per_metre)
{
  if (!gnuplot_is_there()) GTEST_SKIP() << "gnuplot is not installed";
  base::BodyScale in_space = scale;
  for (const auto& [dimension, ours, theirs] : {std::tuple{2, "N/m)", "N)"}, {3, "N)", "N/m)"}}) {
    in_space.dimension = dimension;
    ASSERT_TRUE(draw_run_curves(folder, run_charts(pipe_history(0.01), in_space, stages), in_space, "a pipe", {}));
    const std::string script = content_of(folder.file("plots/curves.gp"));
    EXPECT_NE(script.find(ours), std::string::npos) << script;
    EXPECT_EQ(script.find(theirs), std::string::npos) << script;
  }
}

TEST_F(PipeCurves, of_nothing_there_is_no_picture)
{
  EXPECT_FALSE(draw_run_curves(folder, run_charts(empty_history(), scale, stages), scale, "nothing", {}));
}

}  // namespace
}  // namespace berm::driven::this_file
