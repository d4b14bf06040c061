// SPDX-License-Identifier: BSD-3-Clause
#include "springs/written_springs.hpp"

#include "samples/made_springs.hpp"

#include <gtest/gtest.h>
#include <sstream>

namespace berm::springs::this_file {
namespace {

TEST(WrittenSprings, tell_run_state_travel_and_what_they_are_found_by)
{
  const std::vector<WrittenSpring> all = springs_to_write(made_springs());
  ASSERT_EQ(all.size(), 4u) << "two travels, along the axis, downwards";
  EXPECT_EQ(all[0].origin, "run b1, state operation (end of stage unload, w = 0.136 m, V = 1000 N/m), sweep_1, computed");
  EXPECT_NE(all[1].origin.find("sweep_2, computed, no residual, 1129 N/m against a berm at its end, which is not a residual"),
            std::string::npos)
      << all[1].origin;
  EXPECT_NE(all[2].origin.find("undrained, by White and Randolph 2007, displacements by DNVGL-RP-F114, table 4-2"), std::string::npos)
      << all[2].origin;
  EXPECT_EQ(all[3].origin,
            "run b1, state operation (end of stage unload, w = 0.136 m, V = 1000 N/m), push, computed: unloading and reloading have "
            "2e+04 N/m2 (run b1, push, secant to its end, computed), from V = 0 at w = 0.086 m to the preload of 2000 N/m, beyond it the "
            "last slope of the virgin curve, which was not followed so deep");
  EXPECT_EQ(all[2].V, 1000) << "axial coefficients are over the V of the state";
  Springs before = made_springs();
  before.V = nan;
  before.lateral[0].V = 700;
  EXPECT_EQ(axial_V(before), 700) << "where the state has none, of the first travel";
}

TEST(WrittenSprings, along_the_axis_are_named_by_the_strength_that_they_have_in_every_file)
{
  Springs s = made_springs();
  s.axial.strength = "undisturbed clay", s.axial.sensitivity = 3, s.axial.residual = 80;
  const Design design = made_design(s);
  for (const Format& format : formats)
    for (const ExportFile& file : format.files(design)) {
      const bool has_axial = file.text.find("240") != std::string::npos || file.text.find("0.24") != std::string::npos;
      EXPECT_TRUE(!has_axial || file.text.find("undisturbed") != std::string::npos) << format.name << '\n' << file.text;
    }
  const std::string head = abaqus_files(design).front().text;
  EXPECT_NE(head.find("(sensitivity): axial residual 80 N/m"), std::string::npos) << head;
  EXPECT_EQ(abaqus_files(made_design()).front().text.find("undisturbed"), std::string::npos);
}

TEST(WrittenSprings, of_a_travel_with_a_berm_and_no_residual_never_reach_it_as_a_residual)
{
  const Springs s = made_springs();
  const std::vector<WrittenSpring> all = springs_to_write(s);
  for (const Point& p : all.at(1).points) EXPECT_LE(p.F, 800) << "its breakout, not the 1129 N/m at its end";
}

/// V over w between the points of a spring.
Real reaction(const Points& points, Real w)
{
  for (std::size_t k = 1; k < points.size(); ++k)
    if (w <= points[k].x) return std::lerp(points[k - 1].F, points[k].F, (w - points[k - 1].x) / (points[k].x - points[k - 1].x));
  return nan;
}

// Pushed to 2000 N/m at 0.1 m, laid to 0.136 m, unloaded to 1000 N/m there along 6.25e5 N/m2: without load it lies at 0.136 - 1000/6.25e5 = 0.1344 m, the preload is met
// again at 0.136 + 1000/6.25e5 = 0.1376 m.
TEST(WrittenSprings, downwards_begin_at_the_state_follow_the_unloading_line_to_the_preload_and_go_on_as_virgin)
{
  Springs s = made_springs();
  s.vertical.unloading = {{"unload", 2000, 1000, 6.25e5}};
  Points points = vertical_spring(s);
  ASSERT_EQ(points.size(), 5u);
  EXPECT_NEAR(points[1].x, 0.1344, 1e-12);
  EXPECT_EQ(points[1].F, 0);
  EXPECT_EQ(points[2].x, 0.136);
  EXPECT_EQ(points[2].F, 1000) << "under V of the state the pipe lies at its embedment";
  EXPECT_NEAR(points[3].x, 0.1376, 1e-12);
  EXPECT_EQ(points[3].F, 2000);
  EXPECT_NEAR((points[4].F - points[3].F) / (points[4].x - points[3].x), 800 / 0.05, 1e-6) << "the last slope of the push";
  EXPECT_NEAR(reaction(points, 0.1352), 500, 1e-9) << "unloaded";
  for (const Point& p : from_rest(points)) EXPECT_GE(p.x, 0);
  EXPECT_NEAR(reaction(from_rest(points), 0.0016), 1000, 1e-9);
  EXPECT_NE(rest_words(s).find("0.1344 m below the seabed"), std::string::npos) << rest_words(s);
  // Followed deeper than the state: the virgin curve itself.
  s.vertical.curve.push_back({0.2, 2600});
  points = vertical_spring(s);
  ASSERT_EQ(points.size(), 5u);
  EXPECT_EQ(points[4].x, 0.2);
  EXPECT_EQ(points[4].F, 2600);
}

TEST(WrittenSprings, downwards_have_the_stiffness_of_a_formula_where_no_stage_unloads_and_never_rise_out_of_the_bed)
{
  Springs s = made_springs();
  s.vertical.rebound = 4e5, s.vertical.rebound_source = "a guideline";
  EXPECT_NEAR(vertical_spring(s)[1].x, 0.136 - 1000 / 4e5, 1e-12);
  EXPECT_NE(vertical_origin(s).find("4e+05 N/m2 (by a guideline)"), std::string::npos) << vertical_origin(s);
  s.vertical.rebound = 1000;  // would rise by 1 m
  const Points points = vertical_spring(s);
  EXPECT_EQ(points[1].x, 0.136);
  EXPECT_EQ(points[1].F, 1000) << "straight from the surface";
  s.V = nan;
  EXPECT_EQ(vertical_spring(s).size(), 4u) << "without a state the virgin curve";
  s = made_springs();
  s.vertical.preload = 700;
  EXPECT_EQ(vertical_spring(s)[2].F, 1000) << "what lies on it now is the least preload";
}

TEST(WrittenSprings, along_the_axis_fall_to_the_residual_and_stay)
{
  Springs s = made_springs();
  s.axial.residual = 80;
  const Points best = axial_spring(s), high = axial_spring(s, &Range::high);
  ASSERT_EQ(best.size(), 4u);
  EXPECT_NEAR(best[1].x, 0.005, 1e-12);
  EXPECT_EQ(best[1].F, 240);
  EXPECT_NEAR(best[2].x, 0.03, 1e-12);
  EXPECT_EQ(best[2].F, 80);
  EXPECT_EQ(best[3].F, 80);
  for (std::size_t k = 1; k < high.size(); ++k) EXPECT_GT(high[k].x, high[k - 1].x);
  EXPECT_NEAR(high[2].x, 0.25, 1e-12);
}

TEST(WrittenSprings, upwards_are_minus_the_push_and_nothing_where_the_pipe_is_lifted)
{
  const Points points = upwards_positive({{0, 0}, {0.1, 20}, {0.2, 30}}, 0.5);
  ASSERT_EQ(points.size(), 4u);
  EXPECT_EQ(points[0].x, -0.2);
  EXPECT_EQ(points[0].F, -30);
  EXPECT_EQ(points[2].x, 0);
  EXPECT_EQ(points[3].x, 0.5);
  EXPECT_EQ(points[3].F, 0);
}

TEST(WrittenSprings, have_no_stiffness_of_a_slope_that_is_none_and_say_why)
{
  Springs s = made_springs();
  EXPECT_NEAR(normal_stiffness(s).value, 2000 / 0.1, 1e-9) << "of the push, as the pipe sank while V fell";
  s.vertical.unloading = {{"unload", 1860, 1000, -1e5}, {"pause", 1000, 1200, nan}, {"lift", 1000, 0, 4e5}};
  EXPECT_EQ(normal_stiffness(s).value, 4e5);
  EXPECT_NE(normal_stiffness(s).origin.find("lift"), std::string::npos);
  const std::vector<std::string> lines = refused_stiffnesses(s);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0],
            "stiffness dV/dw in stage unload is not written: V fell from 1860 to 1000 N/m while the pipe sank, so that the slope is "
            "negative and no stiffness");
  EXPECT_EQ(lines[1], "stiffness dV/dw in stage pause is not written: w does not follow V in it");
}

TEST(WrittenSprings, have_comments_that_no_name_can_end_and_no_program_cuts)
{
  Design design = made_design();
  design.provenance.push_back(std::string(400, 'x').append(" end"));
  design.provenance.push_back("a\n*STEP\r\nb");
  std::string long_line;
  for (int k = 0; k < 60; ++k) long_line += "word ";
  std::istringstream lines(comments(design, "** ", {long_line}));
  int words = 0;
  for (std::string line; std::getline(lines, line);) {
    EXPECT_TRUE(line.starts_with("** ")) << line;
    if (line.find("xxx") == std::string::npos) {
      EXPECT_LE(line.size(), 123u) << line;
    }
    for (std::size_t at = line.find("word"); at != std::string::npos; at = line.find("word", at + 1)) ++words;
  }
  EXPECT_EQ(words, 60);
}

}  // namespace
}  // namespace berm::springs::this_file
