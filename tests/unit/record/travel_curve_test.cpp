// SPDX-License-Identifier: BSD-3-Clause
#include "record/travel_curve.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace berm::record::this_file {
namespace {

RC_GTEST_PROP(TravelCurve, follows_a_straight_line_exactly_for_any_spacing_of_rows, ())
{
  std::vector<Real> s{0}, y{3};
  const int rows = *rc::gen::inRange(3, 60);
  for (int k = 1; k < rows; ++k) {
    s.push_back(s.back() + 0.001 * *rc::gen::inRange(1, 100));
    y.push_back(3 - 2 * s.back());
  }
  const TravelCurve curve(s, y);
  const Real at = s.back() * *rc::gen::inRange(0, 101) / 100;
  RC_ASSERT(std::abs(curve.at(at, 0.001 * *rc::gen::inRange(0, 500)) - (3 - 2 * at)) < 1e-9);
}

TEST(TravelCurve, is_averaged_over_the_same_length_at_its_begin_and_at_its_end)
{
  std::vector<Real> s, y, mirrored;
  for (int k = 0; k <= 100; ++k)
    s.push_back(k / 100.), y.push_back(std::sin(20 * s.back())), mirrored.push_back(std::sin(20 * (1 - s.back())));
  const TravelCurve curve(s, y), other(s, mirrored);
  for (const Real at : {0., 0.02, 0.05, 0.1, 0.5}) EXPECT_NEAR(curve.at(at, 0.1), other.at(1 - at, 0.1), 1e-12) << at;
}

TEST(TravelCurve, is_smoothed_at_its_travels_and_of_long_curves_at_2000_of_them)
{
  const auto wave = [](int rows) {
    std::vector<Real> s, y;
    for (int k = 0; k < rows; ++k) s.push_back(Real(k) / (rows - 1)), y.push_back(std::sin(10 * s.back()) + (k % 2 == 0 ? 0.1 : -0.1));
    return TravelCurve(s, y);
  };
  const TravelCurve short_one = wave(500), long_one = wave(200001);
  EXPECT_EQ(short_one.smoothed(0.01).travel(), short_one.travel());
  EXPECT_EQ(short_one.smoothed(0.01).value()[77], short_one.at(short_one.travel()[77], 0.01));
  const TravelCurve smooth = long_one.smoothed(0.01);
  EXPECT_EQ(smooth.travel().size(), 2000U);
  EXPECT_EQ(smooth.end(), long_one.end());
  for (const Real s : {0.2, 0.31234, 0.9999})
    EXPECT_NEAR(smooth.at(s, 0), std::sin(10 * s), 2e-3);  // the window lowers it by 100 x 0.01^2 / 6
}

TEST(TravelCurve, leaves_out_rows_that_go_back_and_does_not_reach_beyond_its_ends)
{
  const TravelCurve curve({0, 1, 0.5, 1, 2}, {0, 10, 99, 99, 20});
  EXPECT_EQ(curve.travel(), (std::vector<Real>{0, 1, 2}));
  EXPECT_DOUBLE_EQ(curve.at(0.5, 0), 5);
  EXPECT_TRUE(std::isnan(curve.at(2.1, 1)));
  EXPECT_TRUE(std::isnan(curve.at(-0.1, 1)));
  EXPECT_TRUE(std::isnan(TravelCurve({}, {}).at(0, 1)));
}

/// A resistance that grows with the travel and has jumped to 100 within its first hundredth, rows 0.1 mm apart over 0.1 m.
struct Jump {
  std::vector<Real> s, y;
  Jump()
  {
    for (int k = 0; k <= 1000; ++k) s.push_back(1e-4 * k), y.push_back(k < 10 ? 10. * k : 100 + 1000 * s.back());
  }
};

TEST(TravelCurve, is_drawn_from_its_first_row_on)
{
  const Jump jump;
  const TravelCurve curve(jump.s, jump.y);
  EXPECT_GT(curve.at(0, 0.005), 50) << "the line fitted beyond the jump begins above it";
  EXPECT_EQ(curve.drawn(0.005).value().front(), 0);
  EXPECT_EQ(drawn_along(jump.s, jump.y, 0.005).front(), 0);
  EXPECT_NEAR(curve.drawn(0.005).value().back(), 200, 1e-9) << "at its end it follows the rows, as numbers at the end do";
}

TEST(TravelCurve, of_a_short_travel_is_drawn_with_its_bend)
{
  std::vector<Real> s, y;
  for (int k = 0; k <= 100; ++k) s.push_back(1e-5 * k), y.push_back(std::sqrt(Real(k)));
  // A window of all the travel makes it a straight line; one of a tenth is off by its curvature, h^2 y''/6 at most.
  EXPECT_NEAR(drawn_along(s, y, 0.01)[50], std::sqrt(50.), 0.01);
  EXPECT_GT(std::abs(TravelCurve(s, y).at(s[50], 0.01) - std::sqrt(50.)), 0.2);
}

TEST(TravelCurve, of_a_travel_that_goes_back_and_forth_is_not_drawn)
{
  std::vector<Real> s, y;
  for (int k = 0; k <= 400; ++k) s.push_back(0.1 * std::sin(0.05 * k) * (1 + 0.001 * k)), y.push_back(std::cos(0.05 * k));
  for (const Real drawn : drawn_along(s, y, 0.002)) EXPECT_TRUE(std::isnan(drawn));
  EXPECT_EQ(drawn_along(s, y, 0), y) << "without noise the rows are the line";
  std::vector<Real> noisy, value;
  for (int k = 0; k <= 400; ++k) noisy.push_back(1e-3 * k - (k % 2) * 1.5e-3), value.push_back(k);
  EXPECT_NEAR(drawn_along(noisy, value, 0.01)[200], 200, 2) << "a row that is less than half a window behind is noise";
}

}  // namespace
}  // namespace berm::record::this_file
