// SPDX-License-Identifier: BSD-3-Clause
#include "picture/canvas.hpp"

#include "samples/drawn_run.hpp"
#include "samples/pixel_color.hpp"

namespace berm::picture::this_file {
namespace {

const Window window{Vec<2>(10, 20), Vec<2>(30, 60)};

/// Of a polygon, counter-clockwise positive.
Real area_of(const Points& points)
{
  Real twice = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Vec<2>&a = points[k], &b = points[(k + 1) % points.size()];
    twice += a[0] * b[1] - a[1] * b[0];
  }
  return twice / 2;
}

TEST(Canvas, a_polygon_is_cut_at_the_sides_of_a_window)
{
  const Points square{Vec<2>(0, 0), Vec<2>(20, 0), Vec<2>(20, 40), Vec<2>(0, 40)};
  EXPECT_DOUBLE_EQ(area_of(part_inside(square, window)), 10 * 20);
  const Points around{Vec<2>(-100, -100), Vec<2>(100, -100), Vec<2>(100, 100), Vec<2>(-100, 100)};
  EXPECT_DOUBLE_EQ(area_of(part_inside(around, window)), 20 * 40);
  const Points within{Vec<2>(12, 22), Vec<2>(28, 22), Vec<2>(20, 50)};
  EXPECT_DOUBLE_EQ(area_of(part_inside(within, window)), area_of(within));
  EXPECT_TRUE(part_inside({Vec<2>(0, 0), Vec<2>(9, 0), Vec<2>(0, 19)}, window).empty());
}

TEST(Canvas, a_line_is_cut_at_the_sides_of_a_window)
{
  const auto part = part_inside(Vec<2>(0, 30), Vec<2>(40, 30), window);
  ASSERT_TRUE(part);
  EXPECT_EQ(part->first, Vec<2>(10, 30));
  EXPECT_EQ(part->second, Vec<2>(30, 30));
  const auto steep = part_inside(Vec<2>(20, 40), Vec<2>(20, 100), window);
  ASSERT_TRUE(steep);
  EXPECT_EQ(steep->second, Vec<2>(20, 60));
  EXPECT_FALSE(part_inside(Vec<2>(0, 10), Vec<2>(40, 10), window));
  EXPECT_FALSE(part_inside(Vec<2>(0, 61), Vec<2>(11, 100), window));
}

TEST(Canvas, what_is_drawn_lies_at_its_pixels_and_nothing_of_it_outside_an_open_window)
{
  if (std::system("gnuplot --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "gnuplot is not installed";
  const TemporaryFolder folder;
  Canvas canvas;
  canvas.polygon({Vec<2>(10, 10), Vec<2>(90, 10), Vec<2>(90, 90), Vec<2>(10, 90)}, "#ff0000");
  canvas.open({Vec<2>(120, 20), Vec<2>(160, 80)});
  canvas.disk({120, 50}, 25, "#0000ff");
  canvas.close();
  ASSERT_TRUE(canvas.draw(folder.path(), "shapes", 200, 100, plot::PlotFormat::png));
  const std::filesystem::path picture = folder / "shapes.png";
  ASSERT_EQ(png_size(picture), (std::pair{200, 100}));
  const Color red{255, 0, 0}, blue{0, 0, 255}, white{255, 255, 255};
  EXPECT_EQ(color_at(picture, 12, 12), red);
  EXPECT_EQ(color_at(picture, 88, 88), red);
  EXPECT_EQ(color_at(picture, 6, 50), white);
  EXPECT_EQ(color_at(picture, 124, 50), blue);
  EXPECT_EQ(color_at(picture, 142, 50), blue);
  EXPECT_EQ(color_at(picture, 115, 50), white) << "left of the window";
  EXPECT_EQ(color_at(picture, 148, 50), white) << "outside the disk";
}

TEST(Canvas, words_keep_their_quotes)
{
  if (std::system("gnuplot --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "gnuplot is not installed";
  const TemporaryFolder folder;
  Canvas canvas;
  canvas.polygon({Vec<2>(0, 0), Vec<2>(9, 0), Vec<2>(9, 9)}, "#ff0000");
  canvas.text({10, 50}, "the pipe's \"skin\" \\ s_u");
  ASSERT_TRUE(canvas.draw(folder.path(), "words", 300, 100, plot::PlotFormat::svg));
  EXPECT_NE(content_of(folder / "words.svg").find("the pipe's \"skin\" \\ s_u"), std::string::npos) << content_of(folder / "words.svg");
}

}  // namespace
}  // namespace berm::picture::this_file
