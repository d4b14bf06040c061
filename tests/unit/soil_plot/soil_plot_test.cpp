// SPDX-License-Identifier: BSD-3-Clause
#include "soil_plot/soil_plot.hpp"

#include "os/error.hpp"
#include "plot/gnuplot.hpp"
#include "samples/drawn_run.hpp"
#include "samples/pixel_color.hpp"

#include <algorithm>
#include <cstring>
#include <fmt/format.h>

namespace berm::soil_plot::this_file {
namespace {

namespace fs = std::filesystem;

TEST(SoilView, reaches_up_to_a_berm_but_not_to_a_grain_that_is_thrown_up)
{
  std::vector<Vec<2>> soil(5000, Vec<2>(0.01, -0.02));
  EXPECT_DOUBLE_EQ(view_around(0, -0.01, 0.02, 0, soil).upper[1], -0.01 + 1.3 * 0.02);
  for (int k = 0; k < 100; ++k) soil[k] = Vec<2>(0.03, 0.04);
  soil.back() = Vec<2>(0.03, 0.2);
  EXPECT_DOUBLE_EQ(view_around(0, -0.01, 0.02, 0, soil).upper[1], 0.04 + 0.2 * 0.02);
  for (int k = 0; k < 100; ++k) soil[k] = Vec<2>(0.06, 0.04);
  EXPECT_DOUBLE_EQ(view_around(0, -0.01, 0.02, 0, soil).upper[1], -0.01 + 1.3 * 0.02) << "beside the view";
}

TEST(SoilView, shows_no_level_surface_where_the_ground_is_another_line)
{
  SoilView view{Vec<2>(0, 0), Vec<2>(1, 1), 0.5};
  view.show({});
  EXPECT_EQ(view.surface, 0.5);
  view.show({{Vec<2>(-1, -1), Vec<2>(3, 3)}});
  EXPECT_FALSE(view.surface);
  ASSERT_EQ(view.ground.corners.size(), 2U);
  EXPECT_NEAR((view.ground.corners[1] - Vec<2>(1, 1)).norm(), 0, 1e-15);
  SoilView below{Vec<2>(0, -9), Vec<2>(1, -8), 0.5};
  below.show({{Vec<2>(-1, -1), Vec<2>(3, 3)}});
  EXPECT_FALSE(below.surface) << "the ground lies outside the view";
  EXPECT_TRUE(below.ground.level());
}

class SoilPlot : public DrawnRun {
protected:
  /// The values of a picture's pixels, row by row from the lowest up; NaN without soil.
  std::vector<float> pixels(const std::string& name)
  {
    const std::string bytes = content_of(folder.file("plots/" + name + ".bin"));
    std::vector<float> values(bytes.size() / sizeof(float));
    std::memcpy(values.data(), bytes.data(), values.size() * sizeof(float));
    return values;
  }
  static run_folder::Frame<2> frame()
  {
    static const problem::Problem<2> problem = sample_problem<2>();
    const TemporaryFolder frames_folder;
    SampleFrames<2> frames(frames_folder.path(), problem);
    frames.write(problem.state);
    return frames.last();
  }
};

TEST_F(SoilPlot, the_soil_is_drawn_in_both_colourings)
{
  if (!gnuplot_is_there()) GTEST_SKIP() << "gnuplot is not installed";
  const SoilView view{Vec<2>(0, 0), Vec<2>(0.2, 0.1), 0.09};
  ASSERT_TRUE(draw_soil(folder.path(), frame(), {"soil", "deviatoric_strain", view, "soil"}));
  ASSERT_TRUE(draw_soil(folder.path(), frame(), {"soil_increment", "incremental_deviatoric_strain", view, "increment of nothing"}));
  EXPECT_EQ(png_size(folder.file("soil.png")).first, 1330);
  EXPECT_EQ(png_size(folder.file("soil_increment.png")).first, 1330);
}

TEST_F(SoilPlot, triangles_are_filled_with_the_colour_of_their_strain)
{
  if (!gnuplot_is_there()) GTEST_SKIP() << "gnuplot is not installed";
  const SoilView view{Vec<2>(-0.1, -0.1), Vec<2>(0.3, 0.3), {}};
  ASSERT_TRUE(draw_soil(folder.path(), two_triangles(), {"soil", "deviatoric_strain", view, "two triangles"}));
  ASSERT_EQ(png_size(folder.file("soil.png")), (std::pair{1330, 1160}));
  // The view is 930 pixels wide and high, 160 from the left and 110 from the top.
  const auto color = [&](Real x, Real y) {
    return color_at(folder.file("soil.png"), 160 + static_cast<int>(930 * (x + 0.1) / 0.4), 110 + static_cast<int>(930 * (0.3 - y) / 0.4));
  };
  const Color below = color(0.15, 0.05), above = color(0.05, 0.15), white = {255, 255, 255};
  EXPECT_GT(below[1], above[1] + 60);  // strain 0.75 is green: 96 200 96; strain 0.25 is blue: 59 81 138
  EXPECT_GT(above[2], below[2] + 20);
  EXPECT_EQ(color(-0.05, 0.1), white);
  EXPECT_EQ(color(0.1, 0.25), white);
}

TEST_F(SoilPlot, triangles_are_painted_without_gaps_as_far_as_the_middles_of_their_sides_reach)
{
  run_folder::Frame<2> frame = two_triangles();
  const auto strain = [](Real x, Real y) { return 0.5 + (x - y) / 0.4; };
  frame.points[1][1] = -0.03;  // of the middle of the lower side
  frame.field("deviatoric_strain").at(1) = strain(0.1, -0.03);
  draw_soil(folder.path(), frame, {"soil", "deviatoric_strain", {Vec<2>(-0.1, -0.1), Vec<2>(0.31, 0.3), {}}, "two triangles"});
  constexpr int columns = 930, rows = 907;
  const std::vector<float> shown = pixels("soil");
  ASSERT_EQ(shown.size(), static_cast<std::size_t>(columns) * rows);
  int wrong = 0;
  for (int k = 0; k < rows * columns; ++k) {
    const Real x = -0.1 + (k % columns + 0.5) * 0.41 / columns, y = -0.1 + (k / columns + 0.5) * 0.4 / rows;
    const bool inside = x > 0 && x < 0.2 && y < 0.2 && y > -0.3 * std::min(x, 0.2 - x);
    if (inside ? !(std::abs(shown[k] - strain(x, y)) < 1e-6) : !std::isnan(shown[k])) ++wrong;  // of a float's precision
  }
  EXPECT_EQ(wrong, 0);
}

// Two particles at rest, whose circles have radii of 1 m; the plot has 930 by 465 pixels of 1/93 m.
TEST_F(SoilPlot, particles_are_painted_where_they_are_and_those_outside_the_view_are_left_out)
{
  run_folder::Frame<2> two;
  two.allocate(2, run_folder::common_fields<2>());
  two.points = {Vec<2>(3, 2), Vec<2>(30, 2)};
  two.volume = {1, 1};
  two.field("mean_stress").values = {5, 7};
  draw_soil(folder.path(), two, {"soil", "mean_stress", {Vec<2>(0, 0), Vec<2>(10, 5), {}}, "two"});
  const std::vector<float> shown = pixels("soil");
  ASSERT_EQ(shown.size(), 930U * 465U);
  int soil = 0, wrong = 0;
  for (int k = 0; k < 930 * 465; ++k) {
    const Real away = (Vec<2>((k % 930 + 0.5) / 93, (k / 930 + 0.5) / 93) - Vec<2>(3, 2)).norm();
    if (away < 0.999 ? shown[k] != 5 : away > 1.001 && !std::isnan(shown[k])) ++wrong;
    soil += shown[k] == 5 ? 1 : 0;
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_NEAR(soil, pi * 93 * 93, 300) << "a row of pixels along the circle is 580";
}

TEST_F(SoilPlot, around_an_axis_both_sides_are_shown)
{
  run_folder::Frame<2> ring;
  ring.allocate(1, run_folder::common_fields<2>());
  ring.points = {Vec<2>(3, 2)};
  ring.volume = {1};
  ring.field("mean_stress").values = {5};
  SoilView view{Vec<2>(0, 0), Vec<2>(10, 5), {}};
  view.mirror();
  EXPECT_EQ(view.lower, Vec<2>(-10, 0));
  draw_soil(folder.path(), ring, {"soil", "mean_stress", view, "ring"});
  const std::vector<float> shown = pixels("soil");
  const int columns = 930, rows = static_cast<int>(shown.size()) / columns;
  int soil = 0, wrong = 0;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const float here = shown[row * columns + column], there = shown[row * columns + columns - 1 - column];
      soil += std::isnan(here) ? 0 : 1;
      if (std::isnan(here) != std::isnan(there)) ++wrong;
    }
  EXPECT_EQ(wrong, 0);
  EXPECT_NEAR(soil, 2 * pi * 46.5 * 46.5, 300);
}

// A cone of ten diameters: one of its pictures is five times as high as wide.
TEST_F(SoilPlot, a_narrow_picture_has_no_empty_part_and_the_whole_of_its_title)
{
  const SoilView narrow{Vec<2>(0, 0), Vec<2>(0.02, 0.1), {}};
  const std::string title = "A smooth cone of 10 cm2 with its shaft, pushed ten diameters into clay";
  draw_soil(folder.path(), frame(), {"soil", "deviatoric_strain", narrow, title});
  EXPECT_EQ(pixels("soil").size(), 200U * 1000U);
  const std::string script = content_of(folder.file("plots/soil.gp"));
  EXPECT_NE(script.find("size 600,1230"), std::string::npos) << script;
  EXPECT_NE(script.find("'" + title + "' at screen 0.5"), std::string::npos) << script;
  EXPECT_NE(script.find("'DejaVu Sans,11.1'"), std::string::npos) << "0.97 x 600 pixels for 70 letters of 0.75 x 11.1";
}

TEST_F(SoilPlot, at_survey_coordinates_places_count_from_a_round_number_that_the_axis_names)
{
  const Vec<2> origin(499'900, -1500);
  run_folder::Frame<2> far = frame();
  for (Vec<2>& x : far.points) x += origin;
  draw_soil(folder.path(), frame(), {"near", "deviatoric_strain", {Vec<2>(0, 0), Vec<2>(0.2, 0.1), {}}, "soil"});
  draw_soil(folder.path(), far, {"far", "deviatoric_strain", {origin, origin + Vec<2>(0.2, 0.1), origin[1] + 0.09}, "soil"});
  const std::vector<float> here = pixels("near"), there = pixels("far");
  ASSERT_EQ(here.size(), there.size());
  int other = 0, soil = 0;
  for (std::size_t k = 0; k < here.size(); ++k) {
    soil += std::isnan(here[k]) ? 0 : 1;
    other += std::isnan(here[k]) != std::isnan(there[k]) ? 1 : 0;
  }
  EXPECT_GT(soil, 1000);
  EXPECT_LT(other, soil / 1000) << "places of 500 km have digits of 1e-10 m";
  const std::string script = content_of(folder.file("plots/far.gp"));
  EXPECT_NE(script.find("set xlabel 'x - 499900 m (mm)'"), std::string::npos) << script;
  EXPECT_NE(script.find("set ylabel 'y + 1500 m (mm)'"), std::string::npos) << script;
  EXPECT_NE(content_of(folder.file("plots/near.gp")).find("set xlabel 'x (mm)'"), std::string::npos);
}

TEST_F(SoilPlot, of_nothing_there_is_no_picture)
{
  const SoilView elsewhere{Vec<2>(50, 50), Vec<2>(51, 51), {}};
  EXPECT_FALSE(draw_soil(folder.path(), frame(), {"soil", "deviatoric_strain", elsewhere, "nothing"}));
}

TEST_F(SoilPlot, a_missing_gnuplot_is_no_failure_and_the_script_stays)
{
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", base.path().c_str(), 1);
  bool drawn = true;
  EXPECT_NO_THROW(drawn = plot::draw(folder.path(), "curves", 100, 100, "plot x\n"));
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_FALSE(drawn);
  EXPECT_TRUE(fs::exists(folder.file("plots/curves.gp")));
}

TEST_F(SoilPlot, a_script_that_fails_is_no_failure_and_leaves_no_broken_picture)
{
  if (!gnuplot_is_there()) GTEST_SKIP() << "gnuplot is not installed";
  EXPECT_FALSE(plot::draw(folder.path(), "curves", 100, 100, "plot 'not there'\n"));
  EXPECT_FALSE(fs::exists(folder.file("curves.png")));
}

TEST_F(SoilPlot, a_picture_that_the_disk_took_a_part_of_is_an_error_and_the_one_before_stays)
{
  const fs::path picture = folder.file("curves.png");
  put(picture, "the one before");
  put(base.path() / "gnuplot", "#!/bin/sh\nprintf 'PNG' > ../curves.png.part\n");
  fs::permissions(base.path() / "gnuplot", fs::perms::owner_all);
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", base.path().c_str(), 1);
  std::string message;
  try {
    plot::draw(folder.path(), "curves", 100, 100, "plot x\n");
  } catch (const RunError& error) {
    message = error.what();
  }
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_NE(message.find("cannot write " + picture.string()), std::string::npos) << message;
  EXPECT_EQ(content_of(picture), "the one before");
  EXPECT_FALSE(fs::exists(picture.string() + ".part"));
}

TEST(GnuplotText, cannot_leave_its_quotes)
{
  EXPECT_EQ(plot::gnuplot_text("it's\n`x`"), "'it''s `x`'");
}

}  // namespace
}  // namespace berm::soil_plot::this_file
