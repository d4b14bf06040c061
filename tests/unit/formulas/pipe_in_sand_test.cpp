// SPDX-License-Identifier: BSD-3-Clause
#include "formulas/pipe_in_sand.hpp"

#include <gtest/gtest.h>
#include <vector>

namespace berm::formulas::this_file {
namespace {

PipeInSand pipe_at(Real relative_embedment, Real interface_angle = 0)
{
  return {.diameter = 0.02,
          .embedment = 0.02 * relative_embedment,
          .unit_weight = 430e3,
          .friction_angle = 35 * degree,
          .interface_angle = interface_angle};
}

constexpr Real weight = 430e3 * 0.02 * 0.02, two_thirds = 70 * degree / 3;

TEST(PipeInSand, characteristics_give_the_tabulated_loads)
{
  const Real table[][3] = {{0.05, 1.433, 3.100}, {0.10, 2.676, 5.915}, {0.25, 5.980, 13.37}, {0.50, 10.87, 23.98}};
  for (const auto& [x, smooth, frictional] : table) {
    EXPECT_NEAR(sand_vertical(pipe_at(x)).value / weight, smooth, 1e-9) << x;
    EXPECT_NEAR(sand_vertical(pipe_at(x, two_thirds)).value / weight, frictional, 1e-9) << x;
    EXPECT_TRUE(sand_vertical(pipe_at(x, two_thirds)).valid);
  }
}

TEST(PipeInSand, the_load_between_entries_follows_their_trend)
{
  // A parabola through 0.10, 0.25 and 0.50 in the logarithms gives 3.715 at 0.145 and 7.903 at 0.345: the broken line of powers is within 0.2 %.
  EXPECT_NEAR(sand_vertical(pipe_at(0.145)).value / weight / 3.715, 1, 0.003);
  EXPECT_NEAR(sand_vertical(pipe_at(0.345)).value / weight / 7.903, 1, 0.003);
  Real before = 0;
  for (int k = 1; k <= 60; ++k) {
    const Real V = sand_vertical(pipe_at(0.01 * k, two_thirds)).value;
    EXPECT_GT(V, before);
    before = V;
  }
}

TEST(PipeInSand, the_table_says_nothing_of_other_angles)
{
  PipeInSand other = pipe_at(0.1);
  other.friction_angle = 34 * degree;
  EXPECT_TRUE(std::isnan(sand_vertical(other).value));
  EXPECT_FALSE(sand_vertical(other).valid);
  EXPECT_FALSE(sand_vertical(pipe_at(0.1, 10 * degree)).valid);
  EXPECT_TRUE(sand_vertical(pipe_at(0.1, std::atan(0.4314))).valid);  // 2/3 phi as a coefficient with four digits
  EXPECT_FALSE(sand_vertical(pipe_at(0.04)).valid);
  EXPECT_TRUE(std::isfinite(sand_vertical(pipe_at(0.04)).value));
  EXPECT_FALSE(sand_vertical(pipe_at(0.51)).valid);
}

TEST(PipeInSand, embedment_grows_with_the_load_to_the_power_two_thirds)
{
  EXPECT_NEAR(sand_embedment(pipe_at(0), weight).value, 0.037 * 0.02, 1e-15);
  EXPECT_NEAR(sand_embedment(pipe_at(0), 8 * weight).value, 4 * 0.037 * 0.02, 1e-15);
  EXPECT_EQ(sand_embedment(pipe_at(0), 0).value, 0);
  EXPECT_FALSE(sand_embedment(pipe_at(0), -1).valid);
}

TEST(YieldSurface, has_its_apex_where_the_formula_says)
{
  for (const YieldSurface surface : {YieldSurface{0.4, 0.1}, YieldSurface{0.7, 0.}, YieldSurface{0.3, -0.05}}) {
    const Real apex_V = 1000 * (1 - surface.beta), apex_H = surface.mu * 500 * (1 + surface.beta) * (1 + surface.beta);
    const auto H = [&](Real V) { return zhang_envelope(surface, V, 2000).value; };
    EXPECT_NEAR(H(apex_V), apex_H, 1e-9);
    EXPECT_NEAR(H(apex_V + 1), H(apex_V - 1), 1e-9);  // a parabola is symmetric about it
    EXPECT_LT(H(apex_V + 1), apex_H);
    EXPECT_EQ(H(2000), 0);
    EXPECT_NEAR(H(0), surface.mu * surface.beta * 2000, 1e-9);
  }
  EXPECT_FALSE(zhang_envelope({0.4, 0.1}, 2001, 2000).valid);
  EXPECT_FALSE(zhang_envelope({0.4, 0.1}, -1, 2000).valid);
  EXPECT_TRUE(zhang_envelope({0.4, 0.1}, 0, 2000).valid);
}

TEST(YieldSurface, is_found_again_from_its_own_points)
{
  const YieldSurface surface{0.42, 0.13};
  std::vector<Real> V, H;
  for (int k = 0; k <= 8; ++k) {
    V.push_back(250. * k);
    H.push_back(zhang_envelope(surface, V.back(), 2000).value);
  }
  const YieldSurface found = fit_zhang(V, H, 2000);
  EXPECT_NEAR(found.mu, surface.mu, 1e-12);
  EXPECT_NEAR(found.beta, surface.beta, 1e-12);
}

TEST(YieldSurface, no_neighbour_is_nearer_to_scattered_points)
{
  const std::vector<Real> V{100, 500, 900, 1400, 1900}, H{130, 260, 250, 200, 10};
  const auto misfit = [&](const YieldSurface& surface) {
    Real sum = 0;
    for (std::size_t k = 0; k < V.size(); ++k) sum += std::pow(H[k] - zhang_envelope(surface, V[k], 2000).value, 2);
    return sum;
  };
  const YieldSurface best = fit_zhang(V, H, 2000);
  for (const Real step : {-0.01, 0.01}) {
    EXPECT_GT(misfit({best.mu + step, best.beta}), misfit(best));
    EXPECT_GT(misfit({best.mu, best.beta + step}), misfit(best));
  }
}

TEST(YieldSurface, cannot_be_found_from_points_at_one_load)
{
  EXPECT_TRUE(std::isnan(fit_zhang(std::vector<Real>{500, 500}, std::vector<Real>{100, 120}, 2000).mu));
  EXPECT_TRUE(std::isnan(fit_zhang(std::vector<Real>{500, 2000}, std::vector<Real>{100, 0}, 2000).mu));
  EXPECT_TRUE(std::isnan(fit_zhang({}, {}, 2000).mu));
}

}  // namespace
}  // namespace berm::formulas::this_file
