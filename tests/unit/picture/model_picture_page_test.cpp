// SPDX-License-Identifier: BSD-3-Clause
#include "picture/model_picture.hpp"

#include "picture/panel.hpp"
#include "samples/pipe_case.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <regex>
#include <sstream>

namespace berm::picture::this_file {
namespace {

/// The outlines in an SVG whose path has this in its attributes.
std::vector<Points> shapes_of(const std::string& svg, const std::string& look)
{
  std::vector<Points> shapes;
  const std::regex path("<path ([^>]*) d=\"([^\"]*)\""), number("[-0-9.]+");
  for (std::sregex_iterator at(svg.begin(), svg.end(), path), end; at != end; ++at) {
    if ((*at)[1].str().find(look) == std::string::npos) continue;
    std::istringstream parts((*at)[2].str());
    for (std::string part; std::getline(parts, part, 'M');) {
      if (part.empty()) continue;
      shapes.emplace_back();
      for (std::sregex_iterator x(part.begin(), part.end(), number); x != end; ++x) {
        const Real first = std::stod(x->str());
        shapes.back().emplace_back(first, std::stod((++x)->str()));
      }
    }
  }
  return shapes;
}

Extent extent_of_first(const std::string& svg, const std::string& look)
{
  const std::vector<Points> shapes = shapes_of(svg, look);
  return shapes.empty() ? Extent{Vec<2>::Zero(), Vec<2>::Zero()} : extent_of(CornersOutline{shapes.front()});
}

std::string stroke(const std::string& color)
{
  return "stroke=\"" + color + "\"";
}
const std::string mesh_look = stroke("#a0a0a880"), pipe_look = "fill=\"#9aa1ab\"", surface_look = stroke(surface_color),
                  fine_look = stroke(fine_color), later_look = stroke(rim_color) + " stroke-width=\"1.3\"";
constexpr Real tolerance = 0.03;  // pixels: numbers are rounded to 0.01

/// Around its sides in the first drawing, the whole.
Extent extent_of_mesh(const std::string& svg)
{
  Points corners;
  for (const Points& side : shapes_of(svg.substr(0, svg.find("<svg xmlns", 1)), mesh_look))
    corners.insert(corners.end(), side.begin(), side.end());
  return corners.empty() ? Extent{Vec<2>::Zero(), Vec<2>::Zero()} : extent_of(CornersOutline{corners});
}

PageDrawing drawing_of(const settings::Case& c, const std::string& title = "x")
{
  return draw_on_page(c, problem::ground_of(c), title);
}

std::string svgs_of(const std::vector<std::string>& changes = {})
{
  return drawing_of(sample_case(changes)).svgs;
}

TEST(ModelPicture_on_a_page, pipe_lies_where_the_case_says)
{
  const std::string svg = svgs_of();
  const Extent mesh = extent_of_mesh(svg), pipe = extent_of_first(svg, pipe_look);
  constexpr Real length = 0.65, headroom = 0.03;
  const Real per_metre = mesh.size()[0] / length;
  ASSERT_GT(per_metre, 0);
  EXPECT_NEAR(mesh.size()[1], 0.17 * per_metre, tolerance);
  EXPECT_NEAR(pipe.lower[0], mesh.lower[0] + (length / 2 - 0.01) * per_metre, tolerance);
  EXPECT_NEAR(pipe.lower[1], mesh.lower[1] + (headroom - 0.02) * per_metre, tolerance);
  EXPECT_NEAR(pipe.size()[0], 0.02 * per_metre, tolerance);
  EXPECT_NEAR(pipe.size()[1], 0.02 * per_metre, tolerance);
}

TEST(ModelPicture_on_a_page, fine_zone_and_surface_lie_where_the_case_says)
{
  const std::string svg = svgs_of();
  const Extent mesh = extent_of_mesh(svg), fine = extent_of_first(svg, fine_look), surface = extent_of_first(svg, surface_look);
  const Real per_metre = mesh.size()[0] / 0.65;
  EXPECT_NEAR(fine.lower[0], mesh.lower[0] + (0.325 - 0.022) * per_metre, tolerance);
  EXPECT_NEAR(fine.lower[1], mesh.lower[1] + (0.03 - 0.014) * per_metre, tolerance);
  EXPECT_NEAR(fine.size()[0], 0.086 * per_metre, tolerance);
  EXPECT_NEAR(fine.size()[1], 0.040 * per_metre, tolerance);
  EXPECT_NEAR(surface.lower[1], mesh.lower[1] + 0.03 * per_metre, tolerance);
  EXPECT_EQ(surface.size()[1], 0);
}

TEST(ModelPicture_on_a_page, shows_the_surface_of_a_slope)
{
  const std::string svg = svgs_of({"mesh.slope=0.1763", "rigid.pipe.center=[0, 0.0102]"});
  const std::vector<Points> surface = shapes_of(svg, surface_look);
  ASSERT_FALSE(surface.empty());
  const Vec<2> way = surface[0].back() - surface[0].front();
  EXPECT_NEAR(-way[1] / way[0], std::tan(0.1763), 1e-3) << "it ascends along x";
  EXPECT_FALSE(shapes_of(svg, soil_color(0)).empty());
  EXPECT_NE(svg.find(">surface<"), std::string::npos);
  const std::vector<Points> mesh = shapes_of(svg.substr(0, svg.find("<svg xmlns", 1)), mesh_look);
  EXPECT_EQ(std::count_if(mesh.begin(), mesh.end(), [](const Points& side) { return (side[1] - side[0]).cwiseAbs().minCoeff() > 10; }), 2)
      << "base and top of the mesh ascend too";
}

TEST(ModelPicture_on_a_page, shows_the_surface_of_a_trench_and_the_embedment_below_it)
{
  const std::string svg = svgs_of({"mesh.trench={depth=0.01, width=0.06, side_slope=0.5}", "rigid.pipe.center=[0, -0.005]"});
  const std::vector<Points> lines = shapes_of(svg, surface_look);
  EXPECT_GE(std::count_if(lines.begin(), lines.end(), [](const Points& line) { return line.size() == 2; }), 5);
  EXPECT_NE(svg.find("w = 5 mm"), std::string::npos);
}

TEST(ModelPicture_on_a_page, small_pipe_is_drawn_once_more_with_its_way)
{
  const std::string svgs = svgs_of();
  const std::size_t second = svgs.find("<svg xmlns", 1);
  ASSERT_NE(second, std::string::npos);
  const std::string svg = svgs.substr(second);
  const Extent pipe = extent_of_first(svg, pipe_look);
  const std::vector<Points> later = shapes_of(svg, later_look);
  ASSERT_EQ(later.size(), 2u);
  const Real per_metre = pipe.size()[0] / 0.02;
  ASSERT_GT(per_metre, 0);
  const Extent after_push = extent_of(CornersOutline{later[0]}), after_drag = extent_of(CornersOutline{later[1]});
  EXPECT_NEAR(after_push.lower[0], pipe.lower[0], tolerance);
  EXPECT_NEAR(after_push.lower[1], pipe.lower[1] + 0.002 * per_metre, tolerance);
  EXPECT_NEAR(after_drag.lower[0], pipe.lower[0] + 0.020 * per_metre, tolerance);
  EXPECT_TRUE(contains(svg, "push 0.1 m/s to w = 2 mm")) << svg;
  EXPECT_TRUE(contains(svg, "drag 0.1 m/s, V held, 20 mm")) << svg;
  EXPECT_TRUE(contains(svg, "D = 20 mm"));
}

TEST(ModelPicture_on_a_page, gravity_supports_and_dimensions_are_told)
{
  const std::string svg = svgs_of();
  for (const char* words : {">50 g<", ">x fixed<", ">x, y fixed<", ">650 mm<", ">140 mm<", ">30 mm<", ">surface<", ">fine zone<"})
    EXPECT_TRUE(contains(svg, words)) << words;
}

TEST(ModelPicture_on_a_page, where_water_leaves_is_told_if_it_flows)
{
  const std::string svg = drawing_of(sample_case_in_water({"support.base.drained=true"})).svgs;
  for (const char* words : {">x fixed, no flow<", ">x, y fixed, drained<"}) EXPECT_TRUE(contains(svg, words)) << words;
  EXPECT_FALSE(contains(svgs_of(), "drained"));
}

TEST(ModelPicture_on_a_page, embedment_of_a_pipe_wished_in_place_is_told)
{
  EXPECT_FALSE(contains(svgs_of(), "w = 5 mm"));
  EXPECT_TRUE(contains(svgs_of({"rigid.pipe.center=[0, 0.005]"}), "w = 5 mm"));
}

TEST(ModelPicture_on_a_page, text_is_escaped)
{
  settings::Case c = sample_case();
  c.body[0].first = "<b> & \"sand\"";
  c.stage[1].name = "<script>";
  const std::string svg = drawing_of(c, "</title><script>").svgs;
  EXPECT_FALSE(contains(svg, "<script>"));
  EXPECT_FALSE(contains(svg, "<b>"));
  EXPECT_TRUE(contains(svg, "<title>&lt;/title&gt;&lt;script&gt;</title>"));
  EXPECT_TRUE(contains(svg, "&lt;b&gt; &amp; &quot;sand&quot;"));
}

TEST(ModelPicture_on_a_page, nothing_is_drawn_outside_of_its_picture)
{
  for (const char* name : {"incline/across", "incline/case", "wip_footing/case", "colliding_disks/case", "cylinder/case", "hertz/case",
                           "oedometer/case", "oedometer/case_3d", "column/case_3d", "envelope/clay", "probe_test/case"}) {
    const std::string svgs = drawing_of(input::read_case(std::string(BERM_SOURCE_DIR) + "/examples/" + name + ".toml"), name).svgs;
    std::size_t from = 0;
    const std::regex frame("<svg xmlns=\"[^\"]*\" role=\"img\" [^>]*viewBox=\"0 0 ([0-9.]+) ([0-9.]+)\"");
    const std::regex word("<text x=\"([-0-9.]+)\" y=\"([-0-9.]+)\" text-anchor=\"(\\w+)\"( transform[^>]*)?[^>]*>([^<]*)<");
    while ((from = svgs.find("<svg xmlns", from)) != std::string::npos) {
      const std::size_t to = svgs.find("<svg xmlns", from + 1);
      const std::string svg = svgs.substr(from, to == std::string::npos ? to : to - from);
      from += 1;
      std::smatch size;
      ASSERT_TRUE(std::regex_search(svg, size, frame)) << name;
      const Real width = std::stod(size[1]), height = std::stod(size[2]);
      for (std::sregex_iterator at(svg.begin(), svg.end(), word), end; at != end; ++at) {
        const Real x = std::stod((*at)[1]), y = std::stod((*at)[2]), half = 0.5 * Canvas::width_of((*at)[5], TextStyle{}.size);
        const bool upright = (*at)[4].length() > 0;
        const Real middle = (*at)[3] == "middle" ? x : (*at)[3] == "start" ? x + half : x - half;
        EXPECT_GE(upright ? x - 8 : middle - half, -1) << name << ": " << (*at)[5];
        EXPECT_LE(upright ? x + 8 : middle + half, width + 1) << name << ": " << (*at)[5];
        EXPECT_GE(y, 10) << name;
        EXPECT_LE(y, height) << name << ": " << (*at)[5];
      }
    }
  }
}

TEST(ModelPicture_on_a_page, mesh_from_a_file_is_told_and_bodies_are_drawn)
{
  const PageDrawing drawing = drawing_of(input::read_case(std::string(BERM_SOURCE_DIR) + "/examples/oedometer/case.toml"));
  ASSERT_FALSE(drawing.notes.empty());
  EXPECT_TRUE(contains(drawing.notes[0], "cells_10.geo")) << drawing.notes[0];
  EXPECT_TRUE(shapes_of(drawing.svgs, mesh_look).empty());
  EXPECT_FALSE(shapes_of(drawing.svgs, pipe_look).empty());
}

TEST(ModelPicture_on_a_page, half_plane_is_cut_at_the_edge_of_the_mesh)
{
  const std::string svg = drawing_of(input::read_case(std::string(BERM_SOURCE_DIR) + "/examples/incline/across.toml")).svgs;
  const Extent mesh = extent_of_mesh(svg);
  const std::vector<Points> planes = shapes_of(svg, pipe_look);
  ASSERT_FALSE(planes.empty());
  EXPECT_EQ(planes[0].size(), 4u);
  for (const Vec<2>& corner : planes[0]) {
    EXPECT_GE(corner[0], mesh.lower[0] - tolerance);
    EXPECT_LE(corner[0], mesh.upper[0] + tolerance);
  }
}

}  // namespace
}  // namespace berm::picture::this_file
