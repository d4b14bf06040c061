// SPDX-License-Identifier: BSD-3-Clause
#include "soil_plot/raster.hpp"

#include <cstring>
#include <gtest/gtest.h>

namespace berm::soil_plot::this_file {
namespace {

constexpr Real digits = 1e-12;  // a few roundings of numbers near 1

// The shared side goes through middles of pixels.
TEST(Raster, paints_a_linear_field_exactly_at_the_middles_of_pixels_and_leaves_no_gap_at_a_shared_side)
{
  Raster raster({2, 1}, {4, 3}, 20, 20);
  const auto field = [](const Vec<2>& x) { return 3 * x[0] - x[1]; };
  const Vec<2> a(2, 1), b(4, 1), c(4, 3), d(2, 3);
  for (const std::array<Vec<2>, 3>& corners : {std::array{a, b, c}, std::array{a, d, c}})  // one each way round
    raster.paint(corners, {field(corners[0]), field(corners[1]), field(corners[2])});
  for (Index row = 0; row < 20; ++row)
    for (Index column = 0; column < 20; ++column)
      EXPECT_NEAR(raster.at(column, row), field({2 + 0.1 * (column + 0.5), 1 + 0.1 * (row + 0.5)}), 20 * digits) << column << ' ' << row;
}

TEST(Raster, paints_only_inside_the_triangle)
{
  Raster raster({0, 0}, {1, 1}, 10, 10);
  raster.paint({Vec<2>(0, 0), Vec<2>(1.02, 0), Vec<2>(0, 1.02)}, {7, 7, 7});
  for (Index row = 0; row < 10; ++row)
    for (Index column = 0; column < 10; ++column) {
      if (row + column <= 9)
        EXPECT_NEAR(raster.at(column, row), 7, 7 * digits);
      else
        EXPECT_TRUE(std::isnan(raster.at(column, row)));
    }
}

TEST(Raster, paints_nothing_of_triangles_beyond_it_or_without_area)
{
  Raster raster({0, 0}, {1, 1}, 4, 4);
  raster.paint({Vec<2>(2, 2), Vec<2>(3, 2), Vec<2>(2, 3)}, {1, 1, 1});
  raster.paint({Vec<2>(-1e12, -1), Vec<2>(-1e11, -1), Vec<2>(-1, -2)}, {1, 1, 1});
  raster.paint({Vec<2>(0, 0), Vec<2>(0.5, 0.5), Vec<2>(1, 1)}, {1, 1, 1});
  for (Index k = 0; k < 16; ++k) EXPECT_TRUE(std::isnan(raster.at(k % 4, k / 4)));
}

// An ellipse of 4 by 1 m that is turned by 30 degrees.
TEST(Raster, paints_the_middles_of_pixels_in_an_ellipse)
{
  Raster raster({-5, -5}, {5, 5}, 100, 200);
  const Vec<2> along(std::sqrt(3.) / 2, 0.5), across(-0.5, std::sqrt(3.) / 2);
  raster.paint_ellipse({0.5, 0}, 4 * along * along.transpose() + across * across.transpose(), 3);
  int painted = 0;
  for (Index row = 0; row < 200; ++row)
    for (Index column = 0; column < 100; ++column) {
      const Vec<2> x = Vec<2>(-5 + (column + 0.5) / 10, -5 + (row + 0.5) / 20) - Vec<2>(0.5, 0);
      const Real away = std::hypot(along.dot(x) / 4, across.dot(x));
      if (away < 1 - digits) {
        EXPECT_EQ(raster.at(column, row), 3);
      }
      if (away > 1 + digits) {
        EXPECT_TRUE(std::isnan(raster.at(column, row)));
      }
      painted += away < 1 ? 1 : 0;
    }
  EXPECT_NEAR(painted, 4 * pi * 200, 100);
}

TEST(Raster, gives_a_pixel_of_two_ellipses_the_value_of_the_nearer_centre)
{
  Raster raster({0, 0}, {3, 1}, 30, 10);
  raster.paint_ellipse({1, 0.5}, Matrix<2>::Identity(), 1);
  raster.paint_ellipse({2, 0.5}, Matrix<2>::Identity(), 2);
  for (Index column = 5; column < 25; ++column) EXPECT_EQ(raster.at(column, 5), column < 15 ? 1 : 2) << column;
}

TEST(Raster, as_floats_goes_row_by_row_from_the_lowest_up)
{
  Raster raster({0, 0}, {2, 2}, 2, 2);
  raster.paint({Vec<2>(0, 0), Vec<2>(2.1, 0), Vec<2>(0, 2.1)}, {0, 2.1, 4.2});
  const std::string bytes = raster.floats();
  std::array<float, 4> values;
  ASSERT_EQ(bytes.size(), sizeof(values));
  std::memcpy(values.data(), bytes.data(), sizeof(values));
  EXPECT_FLOAT_EQ(values[0], 1.5F);
  EXPECT_FLOAT_EQ(values[1], 2.5F);
  EXPECT_FLOAT_EQ(values[2], 3.5F);
  EXPECT_TRUE(std::isnan(values[3]));
}

}  // namespace
}  // namespace berm::soil_plot::this_file
