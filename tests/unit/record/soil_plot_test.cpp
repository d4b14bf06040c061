// SPDX-License-Identifier: BSD-3-Clause
#include "record/soil_plot.hpp"

#include "core/error.hpp"
#include "plot/gnuplot.hpp"
#include "samples/drawn_run.hpp"
#include "samples/pixel_color.hpp"

#include <algorithm>
#include <cstring>
#include <fmt/format.h>

namespace berm::record::this_file {
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
  EXPECT_EQ(png_size(folder.file("soil.png")).first, 1280);
  EXPECT_EQ(png_size(folder.file("soil_increment.png")).first, 1280);
}

TEST_F(SoilPlot, triangles_are_filled_with_the_colour_of_their_strain)
{
  if (!gnuplot_is_there()) GTEST_SKIP() << "gnuplot is not installed";
  const SoilView view{Vec<2>(-0.1, -0.1), Vec<2>(0.3, 0.3), {}};
  ASSERT_TRUE(draw_soil(folder.path(), two_triangles(), {"soil", "deviatoric_strain", view, "two triangles"}));
  ASSERT_EQ(png_size(folder.file("soil.png")), (std::pair{1280, 1160}));
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
  const std::string bytes = content_of(folder.file("plots/soil.bin"));
  std::vector<float> shown(static_cast<std::size_t>(columns) * rows);
  ASSERT_EQ(bytes.size(), shown.size() * sizeof(float));
  std::memcpy(shown.data(), bytes.data(), bytes.size());
  int wrong = 0;
  for (int k = 0; k < rows * columns; ++k) {
    const Real x = -0.1 + (k % columns + 0.5) * 0.41 / columns, y = -0.1 + (k / columns + 0.5) * 0.4 / rows;
    const bool inside = x > 0 && x < 0.2 && y < 0.2 && y > -0.3 * std::min(x, 0.2 - x);
    if (inside ? !(std::abs(shown[k] - strain(x, y)) < 1e-6) : !std::isnan(shown[k])) ++wrong;  // of a float's precision
  }
  EXPECT_EQ(wrong, 0);
}

TEST_F(SoilPlot, particles_outside_the_view_are_left_out)
{
  const SoilView left_half{Vec<2>(0, 0), Vec<2>(0.1, 0.1), {}};
  run_folder::Frame<2> one = frame();
  one.volume.assign(one.volume.size(), 1e-8);
  draw_soil(folder.path(), one, {"soil", "deviatoric_strain", left_half, "left"});
  std::istringstream lines(content_of(folder.file("plots/soil.dat")));
  std::vector<Real> shown;  // x, mm
  for (std::string line; std::getline(lines, line);)
    if (line[0] != '#') shown.push_back(std::stod(line));
  ASSERT_FALSE(shown.empty());
  EXPECT_LT(*std::max_element(shown.begin(), shown.end()), 100);
}

TEST_F(SoilPlot, at_survey_coordinates_places_count_from_a_round_number_that_the_axis_names)
{
  const Vec<2> origin(499'900, -1500);
  run_folder::Frame<2> far = frame();
  for (Vec<2>& x : far.points) x += origin;
  draw_soil(folder.path(), frame(), {"near", "deviatoric_strain", {Vec<2>(0, 0), Vec<2>(0.2, 0.1), {}}, "soil"});
  draw_soil(folder.path(), far, {"far", "deviatoric_strain", {origin, origin + Vec<2>(0.2, 0.1), origin[1] + 0.09}, "soil"});
  const auto numbers = [&](const char* file) {
    std::istringstream lines(content_of(folder.file(file)));
    std::vector<std::array<Real, 2>> places;  // mm
    for (std::string line; std::getline(lines, line);)
      if (std::array<Real, 2> place; std::sscanf(line.c_str(), "%lf %lf", &place[0], &place[1]) == 2) places.push_back(place);
    return places;
  };
  const auto here = numbers("plots/near.dat"), there = numbers("plots/far.dat");
  ASSERT_EQ(here.size(), there.size());
  ASSERT_FALSE(here.empty());
  for (std::size_t k = 0; k < here.size(); ++k)
    for (int d = 0; d < 2; ++d) EXPECT_NEAR(there[k][d], here[k][d], 1e-3);
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
}  // namespace berm::record::this_file
