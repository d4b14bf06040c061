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
  EXPECT_EQ(all[0].origin, "run b1, state operation (end of stage unload, w = 0.136 m, V = 1000 N/m), travel sweep_1, computed");
  EXPECT_NE(all[1].origin.find("travel sweep_2, computed, no residual, 1129 N/m against a berm at its end, which is not a residual"),
            std::string::npos)
      << all[1].origin;
  EXPECT_NE(all[2].origin.find("undrained, by White and Randolph 2007, displacement by DNVGL-RP-F114, table 4-2"), std::string::npos)
      << all[2].origin;
  EXPECT_EQ(all[3].origin,
            "run b1, from the surface of the bed down, travel push, computed, virgin curve: it is followed where V is larger than ever "
            "before, stiffness of unloading and reloading not known, it ends at w = 0.1 m, above the pipe in state operation "
            "(end of stage unload, w = 0.136 m, V = 1000 N/m)");
  EXPECT_EQ(all[2].V, 1000) << "axial coefficients are over the V of the state";
  Springs before = made_springs();
  before.V = nan;
  before.lateral[0].V = 700;
  EXPECT_EQ(axial_V(before), 700) << "where the state has none, of the first travel";
}

TEST(WrittenSprings, along_the_axis_are_named_by_the_strength_that_they_have_in_every_file)
{
  Springs s = made_springs();
  s.axial.strength = "undisturbed clay", s.axial.sensitivity = 3;
  const Design design = made_design(s);
  for (const Format& format : formats)
    for (const ExportFile& file : format.files(design)) {
      const bool has_axial = file.text.find("240") != std::string::npos || file.text.find("0.24") != std::string::npos;
      EXPECT_TRUE(!has_axial || file.text.find("undisturbed") != std::string::npos) << format.name << '\n' << file.text;
    }
  const std::string head = abaqus_files(design).front().text;
  EXPECT_NE(head.find("1/3 of that (sensitivity), 80 N/m"), std::string::npos) << head;
  EXPECT_EQ(abaqus_files(made_design()).front().text.find("undisturbed"), std::string::npos);
}

TEST(WrittenSprings, of_a_travel_with_a_berm_and_no_residual_never_reach_it_as_a_residual)
{
  const Springs s = made_springs();
  const std::vector<WrittenSpring> all = springs_to_write(s);
  for (const Point& p : all.at(1).points) EXPECT_LE(p.F, 800) << "its breakout, not the 1129 N/m at its end";
}

TEST(WrittenSprings, downwards_say_where_the_stiffness_of_unloading_is)
{
  Springs s = made_springs();
  s.vertical.unloading = {{"unload", 1860, 1000, 6.19e5}};
  EXPECT_NE(push_origin(s).find("unloading and reloading have 6.19e+05 N/m2 (stage unload; springs.csv has it)"), std::string::npos)
      << push_origin(s);
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
  EXPECT_NE(normal_stiffness(s).origin.find("travel lift"), std::string::npos);
  const std::vector<std::string> lines = refused_stiffnesses(s);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0],
            "stiffness of V over w in stage unload is not written: V fell from 1860 to 1000 N/m while the pipe sank, so that the slope is "
            "negative and no stiffness");
  EXPECT_EQ(lines[1], "stiffness of V over w in stage pause is not written: w does not follow V in it");
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
