// SPDX-License-Identifier: BSD-3-Clause
#include "picture/line_plan.hpp"

#include "samples/made_line_run.hpp"

#include <gtest/gtest.h>

namespace berm::picture::this_file {
namespace {

std::string plan_of(const settings::Case& c)
{
  Canvas canvas(Canvas::Place::file);
  const Real height = draw_line_plan(canvas, c, {40, 30}, 1320);
  EXPECT_GT(height, 200);
  return canvas.svg({1400, height}, "plan", "");
}

std::size_t count(const std::string& text, const std::string& part)
{
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST(LinePlan, tells_its_exaggeration_imperfection_slices_springs_and_ends)
{
  const std::string svg = plan_of(test::MadeLineRun{}.settings());
  for (const char* words : {"lateral scale 10 times larger", "imperfection of 400 mm, 60 m long", "9 slices every 8 m, to 64 m",
                            "springs beyond the slices: 0.6 W lateral, 0.6 W axial", "anchored", "mirror image", "1500 m"})
    EXPECT_EQ(count(svg, words), 1u) << words;
}

TEST(LinePlan, of_a_short_turned_line_with_a_free_end_is_drawn_whole)
{
  settings::Case c = test::MadeLineRun{}.settings();
  c.pipeline->half = settings::LineHalf::antisymmetric;
  c.pipeline->end = settings::LineEnd::free;
  c.pipeline->length = 70;
  const std::string svg = plan_of(c);
  for (const char* words : {"rotated by 180 degrees", "free", "70 m"}) EXPECT_EQ(count(svg, words), 1u) << words;
}

}  // namespace
}  // namespace berm::picture::this_file
