// SPDX-License-Identifier: BSD-3-Clause
#include "soil_plot/isometric_raster.hpp"

#include "soil_plot/raster.hpp"

#include <gtest/gtest.h>

namespace berm::soil_plot::this_file {
namespace {

constexpr Rgb red = {255, 0, 0}, blue = {0, 0, 255};
constexpr std::array<int, 3> white = {255, 255, 255};

TEST(Isometric, axes_are_shortened_alike_and_stand_at_equal_angles)
{
  const Vec<2> x = isometric(Vec<3>::UnitX()), y = isometric(Vec<3>::UnitY()), z = isometric(Vec<3>::UnitZ());
  const Real length = std::sqrt(2. / 3);
  for (const Vec<2>& axis : {x, y, z}) EXPECT_NEAR(axis.norm(), length, 1e-15);
  EXPECT_NEAR(x.dot(y), -0.5 * length * length, 1e-15);  // 120 degrees
  EXPECT_NEAR(y.dot(z), -0.5 * length * length, 1e-15);
  EXPECT_NEAR(y[0], 0, 1e-15);  // up
  EXPECT_GT(y[1], 0);
  EXPECT_GT(x[0], 0);  // to the right
  EXPECT_LT(z[0], 0);
}

/// The colour where a point of the unit cube is seen in a picture of that cube.
std::array<int, 3> color_at(const IsometricRaster& raster, const Vec<3>& x)
{
  const Vec<2> from = isometric(x) - Vec<2>(-std::sqrt(0.5), -2 / std::sqrt(6.));
  return raster.at(static_cast<Index>(from[0] * raster.pixels_per_metre()), static_cast<Index>(from[1] * raster.pixels_per_metre()));
}

TEST(IsometricRaster, what_is_nearer_to_the_eye_hides_what_is_behind_it_whatever_is_painted_first)
{
  const Vec<3> front(0.7, 0.7, 0.7), back(0.3, 0.3, 0.3);  // on one line of sight
  for (const bool front_first : {true, false}) {
    IsometricRaster raster({0, 0, 0}, {1, 1, 1}, 200);
    raster.paint_ball(front_first ? front : back, 0.1, front_first ? red : blue);
    raster.paint_ball(front_first ? back : front, 0.1, front_first ? blue : red);
    EXPECT_GT(color_at(raster, front)[0], 100);
    EXPECT_EQ(color_at(raster, front)[2], 0);
    EXPECT_EQ(raster.at(0, 0), white);
  }
}

TEST(IsometricRaster, nothing_outside_the_box_is_painted)
{
  IsometricRaster raster({0, 0, 0}, {1, 1, 1}, 200);
  raster.paint_ball({0.5, 0.5, 1.01}, 0.1, red);
  raster.paint_triangle({Vec<3>(0.2, 0.2, 0.2), Vec<3>(0.2, 0.2, 1.8), Vec<3>(0.2, 0.9, 0.2)}, blue);
  EXPECT_EQ(color_at(raster, {0.5, 0.5, 1}), white);
  EXPECT_EQ(color_at(raster, {0.2, 0.25, 0.9})[0], 0) << "the part inside is";
  IsometricRaster none({0, 0, 0}, {1, 1, 1}, 200);
  none.paint_triangle({Vec<3>(0.2, 0.2, 1.2), Vec<3>(0.2, 0.2, 1.8), Vec<3>(0.2, 0.9, 1.2)}, blue);
  EXPECT_EQ(none.bytes(), std::string(static_cast<std::size_t>(3) * none.columns() * none.rows(), '\xff'));
}

TEST(IsometricRaster, a_cube_is_as_wide_as_its_picture_and_as_high_as_three_edges_at_30_degrees)
{
  const IsometricRaster raster({0, 0, 0}, {1, 1, 1}, 1000);
  EXPECT_NEAR(raster.pixels_per_metre(), 1000 / std::sqrt(2.), 1e-9);
  EXPECT_EQ(raster.rows(), std::lround(1000 / std::sqrt(2.) * 4 / std::sqrt(6.)));
}

TEST(Viridis, goes_from_its_first_to_its_last_colour_and_not_beyond)
{
  EXPECT_EQ(viridis(0), (Rgb{0x44, 0x01, 0x54}));
  EXPECT_EQ(viridis(-3), viridis(0));
  EXPECT_EQ(viridis(1), (Rgb{0xfd, 0xe7, 0x25}));
  EXPECT_EQ(viridis(2), viridis(1));
  EXPECT_NEAR(viridis(1. / 18)[0], (0x44 + 0x48) / 2., 1e-9);  // between the first two
}

TEST(ColorRange, begins_at_zero_and_leaves_one_value_in_a_hundred_beyond_its_end)
{
  std::vector<Real> values(1000, 0.3);
  values[7] = 40;
  EXPECT_EQ(color_range(values), (std::pair<Real, Real>(0, 0.3)));
  EXPECT_EQ(color_range({0, 0, 0}), (std::pair<Real, Real>(0, 1)));
  EXPECT_EQ(color_range({-2, 3}), (std::pair<Real, Real>(-2, 3)));
}

}  // namespace
}  // namespace berm::soil_plot::this_file
