// SPDX-License-Identifier: BSD-3-Clause
#include "report/animation/film_flow.hpp"

#include <gtest/gtest.h>

namespace berm::report::this_file {
namespace {

/// Points in the middles of squares of 1 m that fill the lower half of a view of 36 m x 2 m, four in each square of the arrows' grid.
struct Strip {
  FilmBox view{{0, 0}, {36, 2}};
  FilmFrame frame;
  std::vector<float> sizes;

  template <class Flux>
  explicit Strip(const Flux& flux)
  {
    for (int i = 0; i < 72; ++i)
      for (int j = 0; j < 2; ++j) {
        const Vec<2> x(0.25 + 0.5 * i, 0.25 + 0.5 * j), w = flux(x);
        frame.x.push_back(static_cast<float>(x[0]));
        frame.y.push_back(static_cast<float>(x[1]));
        frame.flow_x.push_back(static_cast<float>(w[0]));
        frame.flow_y.push_back(static_cast<float>(w[1]));
        sizes.push_back(0.5F);
      }
  }
};

TEST(film_flow, is_the_mean_flux_of_the_soil_in_each_square)
{
  const Strip strip([](const Vec<2>& x) { return Vec<2>(1e-6 * x[0], -2e-6); });
  const std::optional<FilmFlow> flow = film_flow({&strip.frame}, strip.sizes, strip.view);
  ASSERT_TRUE(flow);
  EXPECT_EQ(flow->columns, 36);
  EXPECT_EQ(flow->rows, 2);
  EXPECT_DOUBLE_EQ(flow->side, 1);
  ASSERT_EQ(flow->largest.size(), 1u);
  EXPECT_NEAR(flow->largest[0], 35.5e-6, 1e-11);  // numbers in single precision
  ASSERT_EQ(flow->codes.size(), 2u * 36 * 2);
  const Real unit = flow->largest[0] / 127;
  for (std::size_t column = 0; column < 36; ++column) {
    EXPECT_NEAR(unit * flow->codes[2 * column], 1e-6 * (static_cast<Real>(column) + 0.5), unit / 2 * 1.001);
    EXPECT_NEAR(unit * flow->codes[2 * column + 1], -2e-6, unit / 2 * 1.001);
    EXPECT_EQ(flow->codes[2 * (36 + column)], 0) << "no soil above";
  }
}

TEST(film_flow, weighs_each_point_by_the_area_that_it_stands_for)
{
  // Both points lie in one square of 1 m, which their areas of 0.64 and 0.36 m2 fill; numbers are in single precision.
  FilmFrame frame;
  frame.x = {0.4F, 0.7F};
  frame.y = {0.4F, 0.7F};
  frame.flow_x = {1e-6F, 2e-6F};
  frame.flow_y = {0, 0};
  const std::optional<FilmFlow> flow = film_flow({&frame}, {0.8F, 0.6F}, {{0, 0}, {36, 2}});
  ASSERT_TRUE(flow);
  EXPECT_NEAR(flow->largest[0], 0.64 * 1e-6 + 0.36 * 2e-6, 1e-12);
}

TEST(film_flow, has_a_scale_of_its_own_in_each_frame)
{
  const auto strip_of = [](Real size) { return Strip([size](const Vec<2>&) { return Vec<2>(0, size); }); };
  const Strip early = strip_of(1e-3), late = strip_of(1e-9), still = strip_of(0);
  const std::optional<FilmFlow> flow = film_flow({&early.frame, &late.frame, &still.frame}, early.sizes, early.view);
  ASSERT_TRUE(flow);
  EXPECT_NEAR(flow->largest[1], 1e-9, 1e-15);
  EXPECT_EQ(flow->largest[2], 0);
  EXPECT_EQ(flow->codes[2 * 72 + 1], 127);
  EXPECT_EQ(flow->codes[4 * 72 + 1], 0);
  EXPECT_FALSE(film_flow({&still.frame}, still.sizes, still.view));
}

TEST(film_flow, is_not_there_where_no_water_flows)
{
  FilmFrame dry;
  dry.x = dry.y = {1};
  EXPECT_FALSE(film_flow({&dry}, {1}, {{0, 0}, {1, 1}}));
}

}  // namespace
}  // namespace berm::report::this_file
