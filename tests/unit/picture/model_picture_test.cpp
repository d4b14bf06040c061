// SPDX-License-Identifier: BSD-3-Clause
#include "picture/model_picture.hpp"

#include "picture/panel.hpp"
#include "samples/drawn_run.hpp"
#include "samples/layered_box.hpp"
#include "samples/pixel_color.hpp"

#include <fmt/format.h>
#include <regex>

namespace berm::picture::this_file {
namespace {

namespace fs = std::filesystem;

class ModelPicture : public testing::Test {
protected:
  /// The picture of the layered box.
  fs::path draw(const std::vector<std::string>& changes = {}, const std::string& name = "model.png")
  {
    const settings::Case c = test::layered_box(changes);
    draw_model(c, mesh::make_mesh<2>(c.mesh, ".", "."), folder / name);
    return folder / name;
  }
  void SetUp() override
  {
    if (!draws_png()) GTEST_SKIP() << "rsvg-convert or gnuplot is not installed";
  }
  TemporaryFolder folder;
};

/// On white.
Color color_of(const std::string& hex)
{
  const auto part = [&](std::size_t k) { return std::stoi(hex.substr(1 + 2 * k, 2), nullptr, 16); };
  const Real opaque = hex.size() > 7 ? part(3) / 255. : 1;
  Color color;
  for (std::size_t k = 0; k < 3; ++k) color[k] = static_cast<int>(std::lround(255 + opaque * (part(k) - 255)));
  return color;
}

/// Blending rounds twice.
void expect_color(const Color& found, const Color& expected, const std::string& where)
{
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(found[k], expected[k], 1) << where;
}

/// Where the whole model lies in the picture: the box and the pipe on it, 2 m by 1.5 m (the pipe is cut at half the height of the box above it), from (114, 112), 640 pixels high at most and 626 wide.
Color color_in(const fs::path& picture, Real x, Real y)
{
  const Real scale = std::min(626. / 2, 640. / 1.5);
  return color_at(picture, static_cast<int>(114 + scale * x), static_cast<int>(112 + scale * (1.5 - y)));
}

TEST_F(ModelPicture, each_soil_and_the_pipe_have_their_colour_where_they_are)
{
  const fs::path picture = draw();
  EXPECT_EQ(png_size(picture).first, picture_width);
  const Color sand = color_of(soil_color(0)), clay = color_of(soil_color(1)), pipe = color_of(rigid_color), white{255, 255, 255};
  expect_color(color_in(picture, 1.57, 0.86), sand, "in the sand");
  expect_color(color_in(picture, 1.57, 0.72), sand, "2 cm above the border");
  expect_color(color_in(picture, 1.57, 0.68), clay, "2 cm below the border, in the same cell");
  expect_color(color_in(picture, 1.57, 0.11), clay, "in the clay");
  EXPECT_EQ(color_in(picture, 0.42, 1.35), pipe);
  EXPECT_EQ(color_in(picture, 0.7, 1.45), pipe);
  EXPECT_EQ(color_in(picture, 1.57, 1.1), white) << "above the bed";
  EXPECT_EQ(color_in(picture, 0.3, 1.35), white) << "beside the pipe, which ends at 0.35 m";
}

TEST_F(ModelPicture, the_arrow_of_a_stage_lies_on_its_way)
{
  const fs::path picture = draw();
  // The pipe's centre goes down from 1.35 m to 1.25 m and then along x to 1.2 m.
  const Color drag = color_of(drag_color);
  EXPECT_EQ(color_in(picture, 0.84, 1.25), drag);
  EXPECT_EQ(color_in(picture, 1.1, 1.25), drag);
  EXPECT_NE(color_in(picture, 1.25, 1.25), drag) << "beyond its end";
  EXPECT_NE(color_in(draw({"stage.drag.velocity=\"-1 m/s\""}), 1.1, 1.25), drag) << "the other way";
}

TEST_F(ModelPicture, words_say_what_is_drawn)
{
  const std::string words = std::regex_replace(content_of(draw({}, "model.svg")), std::regex("\u00a0"), " ");
  for (const char* expected : {"sand on clay", "64 cells", "sand (body bed)", "clay (body bed)", "φ = 35°", "sᵤ = 2 kPa",
                               "circle, D = 700 mm", "skin: bed on pipe", "δ = 20°", "x, y fixed", "x fixed in rest", "D = 700 mm",
                               "push 1 m/s to w = 100 mm", "drag 1 m/s, V held, 500 mm", "2 m", "1 m"})
    EXPECT_NE(words.find(expected), std::string::npos) << expected;
  EXPECT_EQ(words.find("inf"), std::string::npos);
  EXPECT_EQ(words.find("nan"), std::string::npos);
}

/// A bed of 10 m by 3 m and 0.8 m of headroom on a slope of 10 degrees, with a pipe 0.2 m deep.
TEST_F(ModelPicture, a_slope_has_its_depth_at_the_wall_and_w_below_the_axis)
{
  if (std::system("gmsh --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "gmsh is not installed";
  const std::string bed = "[mesh]\nkind = \"seabed\"\nslope = \"10 deg\"\nlength = 10\ndepth = 3\nheadroom = 0.8\nnear_size = "
                          "0.2\nnear_left = -1\nnear_right = 1.5\n"
                          "near_depth = 0.9\nnear_height = 0.5\ngrowth = 0.25\n[material.sand]";
  const std::string text = std::regex_replace(test::layered_box_text, std::regex("surface = [^]*\\[material.sand\\]"), bed);
  const settings::Case c = input::read_case_text("case.toml", text,
                                                 {"body.bed.regions=[\"near\", \"bed\"]", "support.base.boundary=base",
                                                  "rigid.pipe.center=[0.5, \"238.1635 mm\"]", "stage.push.until.embedment=\"0.3 m\""});
  draw_model(c, mesh::make_mesh<2>(c.mesh, ".", folder.path()), folder / "model.svg");
  const std::string words = std::regex_replace(content_of(folder / "model.svg"), std::regex("\u00a0"), " ");
  for (const char* expected : {"w = 200 mm", ">3 m<", ">800 mm<", "fine zone along the slope", "2.5 m × 1.4 m"})
    EXPECT_NE(words.find(expected), std::string::npos) << expected;
}

TEST_F(ModelPicture, a_small_body_is_drawn_once_more_enlarged)
{
  EXPECT_EQ(content_of(draw({}, "model.svg")).find("enlarged"), std::string::npos);
  EXPECT_NE(content_of(draw({"rigid.pipe.diameter=\"0.1 m\"", "rigid.pipe.center=[\"0.7 m\", \"1.05 m\"]",
                             "stage.push.until.embedment=\"0.02 m\""},
                            "model.svg"))
                .find("enlarged"),
            std::string::npos);
}

/// The level of the middle of some words in an SVG, pixels; NaN where they are not there.
Real level_of(const std::string& svg, const std::string& words)
{
  std::smatch found;
  const std::regex text("<text x=\"[-0-9.]+\" y=\"([-0-9.]+)\"[^>]*>" + words + "</text>");
  return std::regex_search(svg, found, text) ? std::stod(found[1]) : nan;
}

TEST_F(ModelPicture, the_word_beside_the_frame_of_what_is_enlarged_lies_on_no_words_of_a_support)
{
  // The frame reaches out of the top of the mesh, and ends beside its middle.
  const std::string svg = content_of(draw({"rigid.pipe.diameter=\"0.1 m\"", "rigid.pipe.center=[\"0.3 m\", \"1 m\"]",
                                           "stage.push.until.embedment=\"0.06 m\"", "support.top={boundary=\"top\", fixed=[\"y\"]}"},
                                          "model.svg"));
  constexpr Real line = 14;  // pixels, of letters of 10 points
  EXPECT_GT(std::abs(level_of(svg, "enlarged") - level_of(svg, "y fixed")), line);
  EXPECT_LT(level_of(svg, "enlarged"), level_of(svg, "x, y fixed") - line);
}

TEST_F(ModelPicture, a_title_with_quotes_is_no_command)
{
  EXPECT_NE(content_of(draw({"title=\"it's a 'pipe'; exit\""}, "model.svg")).find("it's a 'pipe'; exit"), std::string::npos);
}

}  // namespace
}  // namespace berm::picture::this_file
