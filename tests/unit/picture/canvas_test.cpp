// SPDX-License-Identifier: BSD-3-Clause
#include "picture/canvas.hpp"

#include "samples/drawn_run.hpp"
#include "samples/pixel_color.hpp"

namespace berm::picture::this_file {
namespace {

TEST(Canvas, what_is_drawn_lies_at_its_pixels_and_nothing_of_it_outside_an_open_window)
{
  if (!draws_png()) GTEST_SKIP() << "rsvg-convert or gnuplot is not installed";
  const TemporaryFolder folder;
  Canvas canvas(Canvas::Place::file);
  canvas.polygon({Vec<2>(10, 10), Vec<2>(90, 10), Vec<2>(90, 90), Vec<2>(10, 90)}, "#ff0000");
  canvas.open({Vec<2>(120, 20), Vec<2>(160, 80)});
  canvas.disk({120, 50}, 25, "#0000ff");
  canvas.close();
  const std::filesystem::path picture = folder / "shapes.png";
  canvas.write(picture, {200, 100}, "shapes", "");
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

TEST(Canvas, a_colour_is_that_of_the_page_only_on_one)
{
  for (const Canvas::Place place : {Canvas::Place::page, Canvas::Place::file}) {
    Canvas canvas(place);
    canvas.polygon({Vec<2>(0, 0), Vec<2>(9, 0), Vec<2>(9, 9)}, "var(--link,#1764ab)");
    const std::string svg = canvas.svg({10, 10}, "triangle", "");
    EXPECT_NE(svg.find(place == Canvas::Place::page ? "fill=\"var(--link,#1764ab)\"" : "fill=\"#1764ab\""), std::string::npos) << svg;
  }
}

TEST(Canvas, words_keep_their_quotes)
{
  const TemporaryFolder folder;
  Canvas canvas(Canvas::Place::file);
  canvas.text({10, 50}, "the pipe's \"skin\" \\ s_u");
  canvas.write(folder / "words.svg", {300, 100}, "words", "");
  EXPECT_NE(content_of(folder / "words.svg").find("the pipe's &quot;skin&quot; \\ s_u<"), std::string::npos)
      << content_of(folder / "words.svg");
}

TEST(Canvas, words_are_wrapped_between_words_and_none_is_lost)
{
  const std::string words = "2  drag (tow) 0.5 m/s, V = 85.32 kN, rotation about z on a spring";
  const std::vector<std::string> lines = Canvas::wrapped(words, 11, 300);
  ASSERT_GT(lines.size(), 1u);
  std::string all;
  for (const std::string& line : lines) {
    EXPECT_LE(Canvas::width_of(line, 11), 300);
    all += (all.empty() ? "" : " ") + line;
  }
  EXPECT_EQ(all, words);
  EXPECT_EQ(Canvas::wrapped("word", 11, 1), std::vector<std::string>{"word"});
}

}  // namespace
}  // namespace berm::picture::this_file
