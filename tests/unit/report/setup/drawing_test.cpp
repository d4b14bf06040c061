// SPDX-License-Identifier: BSD-3-Clause
#include "report/setup/drawing.hpp"

#include "samples/pipe_case.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <regex>

namespace berm::report::this_file {
namespace {

/// The numbers of the attributes of the first element of that kind and class in an SVG.
std::vector<Real> numbers_of(const std::string& svg, const std::string& element, const std::string& css_class,
                             const std::vector<std::string>& attributes)
{
  const std::size_t begin = svg.find("<" + element + " class=\"" + css_class + "\"");
  std::vector<Real> numbers;
  if (begin == std::string::npos) return numbers;
  const std::string text = svg.substr(begin, svg.find('>', begin) - begin);
  for (const std::string& attribute : attributes) {
    const std::size_t at = text.find(" " + attribute + "=\"");
    numbers.push_back(at == std::string::npos ? NAN : std::stod(text.substr(at + attribute.size() + 3)));
  }
  return numbers;
}

TEST(drawing, pipe_lies_where_the_case_says)
{
  const std::string svg = draw_case(sample_case(), "x").svgs;
  const auto mesh = numbers_of(svg, "rect", "domain", {"x", "y", "width", "height"});
  const auto pipe = numbers_of(svg, "circle", "rigid", {"cx", "cy", "r"});
  ASSERT_EQ(mesh.size(), 4);
  ASSERT_EQ(pipe.size(), 3);
  constexpr Real length = 0.65, headroom = 0.03, tolerance = 0.03;  // numbers are rounded to 0.01 unit
  const Real per_metre = mesh[2] / length;
  EXPECT_NEAR(mesh[3], 0.17 * per_metre, tolerance);
  EXPECT_NEAR(pipe[0], mesh[0] + length / 2 * per_metre, tolerance);
  EXPECT_NEAR(pipe[1], mesh[1] + (headroom - 0.01) * per_metre, tolerance);
  EXPECT_NEAR(pipe[2], 0.01 * per_metre, tolerance);
}

TEST(drawing, fine_zone_and_surface_lie_where_the_case_says)
{
  const std::string svg = draw_case(sample_case(), "x").svgs;
  const auto mesh = numbers_of(svg, "rect", "domain", {"x", "y", "width", "height"});
  const auto fine = numbers_of(svg, "rect", "fine", {"x", "y", "width", "height"});
  const auto surface = numbers_of(svg, "line", "surface", {"x1", "y1", "x2", "y2"});
  const Real per_metre = mesh[2] / 0.65, tolerance = 0.03;
  EXPECT_NEAR(fine[0], mesh[0] + (0.325 - 0.022) * per_metre, tolerance);
  EXPECT_NEAR(fine[1], mesh[1] + (0.03 - 0.014) * per_metre, tolerance);
  EXPECT_NEAR(fine[2], 0.086 * per_metre, tolerance);
  EXPECT_NEAR(fine[3], 0.040 * per_metre, tolerance);
  EXPECT_NEAR(surface[1], mesh[1] + 0.03 * per_metre, tolerance);
  EXPECT_EQ(surface[1], surface[3]);
}

TEST(drawing, shows_the_surface_of_a_slope)
{
  const std::string svg = draw_case(sample_case({"mesh.slope=0.1763", "rigid.pipe.center=[0, 0.0102]"}), "x").svgs;
  const auto surface = numbers_of(svg, "line", "surface", {"x1", "y1", "x2", "y2"});
  ASSERT_EQ(surface.size(), 4u);
  EXPECT_NEAR((surface[1] - surface[3]) / (surface[2] - surface[0]), std::tan(0.1763), 1e-3) << "it ascends along x";
  EXPECT_NE(svg.find("class=\"soil\""), std::string::npos);
  EXPECT_NE(svg.find(">surface<"), std::string::npos);
  EXPECT_EQ(svg.find("<rect class=\"domain\""), std::string::npos) << "the mesh is no upright rectangle";
}

TEST(drawing, shows_the_surface_of_a_trench_and_the_embedment_below_it)
{
  const std::string svg =
      draw_case(sample_case({"mesh.trench={depth=0.01, width=0.06, side_slope=0.5}", "rigid.pipe.center=[0, -0.005]"}), "x").svgs;
  std::size_t lines = 0;
  for (std::size_t at = svg.find("<line class=\"surface\""); at != std::string::npos; at = svg.find("<line class=\"surface\"", at + 1))
    ++lines;
  EXPECT_GE(lines, 5u);
  EXPECT_NE(svg.find("w = 5 mm"), std::string::npos);
}

TEST(drawing, small_pipe_is_drawn_once_more_with_its_way)
{
  const std::string svgs = draw_case(sample_case(), "x").svgs;
  const std::size_t second = svgs.find("<svg xmlns", 1);
  ASSERT_NE(second, std::string::npos);
  const std::string svg = svgs.substr(second);
  const auto pipe = numbers_of(svg, "circle", "rigid", {"cx", "cy", "r"});
  const auto after_push = numbers_of(svg, "circle", "later", {"cx", "cy", "r"});
  ASSERT_EQ(pipe.size(), 3);
  ASSERT_EQ(after_push.size(), 3);
  const Real per_metre = pipe[2] / 0.01;
  EXPECT_NEAR(after_push[0], pipe[0], 0.03);
  EXPECT_NEAR(after_push[1], pipe[1] + 0.002 * per_metre, 0.03);
  const std::string behind = svg.substr(svg.find("class=\"later\"") + 1);
  const auto after_drag = numbers_of(behind, "circle", "later", {"cx", "cy", "r"});
  ASSERT_EQ(after_drag.size(), 3);
  EXPECT_NEAR(after_drag[0], pipe[0] + 0.020 * per_metre, 0.03);
  EXPECT_TRUE(contains(svg, "push 0.1 m/s to w = 2 mm")) << svg;
  EXPECT_TRUE(contains(svg, "drag 0.1 m/s, V held, 20 mm")) << svg;
  EXPECT_TRUE(contains(svg, "D = 20 mm"));
}

TEST(drawing, gravity_supports_and_dimensions_are_told)
{
  const std::string svg = draw_case(sample_case(), "x").svgs;
  for (const char* words : {">50 g<", ">x fixed<", ">x, y fixed<", ">650 mm<", ">140 mm<", ">30 mm<", ">surface<", ">fine zone<"})
    EXPECT_TRUE(contains(svg, words)) << words;
}

TEST(drawing, where_water_leaves_is_told_if_it_flows)
{
  const std::string svg = draw_case(sample_case_in_water({"support.base.drained=true"}), "x").svgs;
  for (const char* words : {">x fixed, no flow<", ">x, y fixed, drained<"}) EXPECT_TRUE(contains(svg, words)) << words;
  EXPECT_FALSE(contains(draw_case(sample_case(), "x").svgs, "drained"));
}

TEST(drawing, embedment_of_a_pipe_wished_in_place_is_told)
{
  EXPECT_FALSE(contains(draw_case(sample_case(), "x").svgs, "w = 5 mm"));
  EXPECT_TRUE(contains(draw_case(sample_case({"rigid.pipe.center=[0, 0.005]"}), "x").svgs, "w = 5 mm"));
}

TEST(drawing, text_is_escaped)
{
  problem::Case c = sample_case();
  c.body[0].first = "<b> & \"sand\"";
  c.stage[1].name = "<script>";
  const std::string svg = draw_case(c, "</title><script>").svgs;
  EXPECT_FALSE(contains(svg, "<script>"));
  EXPECT_FALSE(contains(svg, "<b>"));
  EXPECT_TRUE(contains(svg, "<title>&lt;/title&gt;&lt;script&gt;</title>"));
  EXPECT_TRUE(contains(svg, "&lt;b&gt; &amp; &quot;sand&quot;"));
}

TEST(drawing, nothing_is_drawn_outside_of_its_picture)
{
  for (const char* name : {"incline/across", "incline/case", "wip_footing/case", "colliding_disks/case", "cylinder/case", "hertz/case",
                           "oedometer/case", "oedometer/case_3d", "column/case_3d", "envelope/clay", "probe_test/case"}) {
    const std::string svgs = draw_case(input::read_case(std::string(BERM_SOURCE_DIR) + "/examples/" + name + ".toml"), name).svgs;
    std::size_t from = 0;
    const std::regex frame("<svg xmlns=\"[^\"]*\" role=\"img\" width=\"([0-9.]+)\" height=\"([0-9.]+)\"");
    const std::regex word("<text x=\"([-0-9.]+)\" y=\"([-0-9.]+)\" text-anchor=\"(\\w+)\"( transform[^>]*)?[^>]*>([^<]*)<");
    while ((from = svgs.find("<svg xmlns", from)) != std::string::npos) {
      const std::size_t to = svgs.find("<svg xmlns", from + 1);
      const std::string svg = svgs.substr(from, to == std::string::npos ? to : to - from);
      from += 1;
      std::smatch size;
      ASSERT_TRUE(std::regex_search(svg, size, frame)) << name;
      const Real width = std::stod(size[1]), height = std::stod(size[2]);
      for (std::sregex_iterator at(svg.begin(), svg.end(), word), end; at != end; ++at) {
        const Real x = std::stod((*at)[1]), y = std::stod((*at)[2]), half = 0.5 * 6.6 * static_cast<Real>((*at)[5].length());
        const bool upright = (*at)[4].length() > 0;
        const Real middle = (*at)[3] == "middle" ? x : (*at)[3] == "start" ? x + half : x - half;
        EXPECT_GE(upright ? x - 12 : middle - half, -1) << name << ": " << (*at)[5];
        EXPECT_LE(upright ? x + 4 : middle + half, width + 1) << name << ": " << (*at)[5];
        EXPECT_GE(y, 10) << name;
        EXPECT_LE(y, height) << name << ": " << (*at)[5];
      }
    }
  }
}

TEST(drawing, mesh_from_a_file_is_told_and_bodies_are_drawn)
{
  const Drawing drawing = draw_case(input::read_case(std::string(BERM_SOURCE_DIR) + "/examples/oedometer/case.toml"), "x");
  ASSERT_FALSE(drawing.notes.empty());
  EXPECT_TRUE(contains(drawing.notes[0], "cells_10.geo")) << drawing.notes[0];
  EXPECT_FALSE(contains(drawing.svgs, "class=\"domain\""));
  EXPECT_TRUE(contains(drawing.svgs, "<polygon class=\"rigid\""));
}

TEST(drawing, half_plane_is_cut_at_the_edge_of_the_mesh)
{
  const std::string svg = draw_case(input::read_case(std::string(BERM_SOURCE_DIR) + "/examples/incline/across.toml"), "x").svgs;
  const auto mesh = numbers_of(svg, "rect", "domain", {"x", "y", "width", "height"});
  const std::size_t begin = svg.find("<polygon class=\"rigid\"");
  ASSERT_NE(begin, std::string::npos);
  const std::string points = svg.substr(svg.find("points=\"", begin) + 8, 100);
  const std::regex pair("([-0-9.]+),([-0-9.]+)");
  int corners = 0;
  for (std::sregex_iterator at(points.begin(), points.end(), pair), end; at != end; ++at, ++corners) {
    EXPECT_GE(std::stod((*at)[1]), mesh[0] - 0.02);
    EXPECT_LE(std::stod((*at)[1]), mesh[0] + mesh[2] + 0.02);
  }
  EXPECT_EQ(corners, 4);
}

}  // namespace
}  // namespace berm::report::this_file
