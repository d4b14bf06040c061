// SPDX-License-Identifier: BSD-3-Clause
#include "problem/equilibrium.hpp"

#include "os/error.hpp"
#include "samples/sample_case.hpp"

#include <gtest/gtest.h>
#include <numbers>

namespace berm::problem::this_file {
namespace {

constexpr Real depth = 2, density = 1000, young = 1e6, g = 10;  // of the box of pipe_over_box

settings::Case resting_box(std::optional<Real> damping, Real of_body = 0)
{
  settings::Case c = pipe_over_box({stage_of(settings::StageKind::geostatic, "rest")});
  c.gravity = {0, -g};
  c.surface = 2;
  c.stage[0].until.time.reset();
  c.stage[0].damping = damping;
  c.body[0].second.damping = of_body;
  c.support = {{"base", {"bottom", {"x", "y"}}}};
  return c;
}

/// 4 H / c_S of the box, whose Poisson's ratio is that of LinearElastic.
Real period_of(const settings::Case& c)
{
  return 4 * depth / std::sqrt(elasticity(c.material[0].second).shear / density);
}

TEST(Equilibrium, takes_the_time_in_which_damping_takes_away_the_swing_of_the_deepest_soil)
{
  const settings::Case c = resting_box(0.7);
  const Problem<2> problem = build<2>(c, ".", ".");
  EXPECT_NEAR(problem.model.longest_period, period_of(c), 1e-12 * period_of(c));
  // A swing falls by exp(-2 alpha) a period at least: to 0.01 in ln(100) / 1.4 periods, and four times as many for soil that yields.
  EXPECT_NEAR(*problem.model.stages[0].until.time, 4 * std::log(100.) / 1.4 * period_of(c), 1e-12);
  EXPECT_TRUE(problem.model.stages[0].until.equilibrium);
  EXPECT_NEAR(velocity_at_rest(problem.model, problem.model.stages[0]), 0.01 * g * period_of(c) / (2 * std::numbers::pi), 1e-15);

  const Problem<2> of_body = build<2>(resting_box({}, 0.35), ".", ".");
  EXPECT_NEAR(*of_body.model.stages[0].until.time, 2 * *problem.model.stages[0].until.time, 1e-12);
}

// The law behind time_to_equilibrium: a mass on a spring with local damping, whose swing falls by (1 - alpha) / (1 + alpha) a period.
TEST(Equilibrium, is_found_by_a_swing_with_local_damping_in_that_time)
{
  for (const Real alpha : {0.1, 0.3, 0.7}) {
    constexpr Real dt = 1e-4;  // of the period
    Real x = 1, v = 0, time = 0;
    const Real omega = 2 * std::numbers::pi, limit = time_to_equilibrium(1, alpha, 0.01);
    for (; time < limit && (std::abs(x) > 0.01 || std::abs(v) > 0.01 * omega); time += dt) {
      const Real force = -omega * omega * x;
      v += dt * (force - (v == 0 ? 0 : alpha * std::abs(force) * (v > 0 ? 1 : -1)));
      x += dt * v;
    }
    EXPECT_LT(time, limit) << alpha;
    EXPECT_GT(time, limit / 12) << alpha << ": the limit is not of its size";
  }
}

TEST(Equilibrium, keeps_the_limit_that_the_input_names)
{
  settings::Case c = resting_box(0.7);
  c.stage[0].until.equilibrium = true;
  c.stage[0].until.time = 0.125;
  EXPECT_EQ(build<2>(c, ".", ".").model.stages[0].until.time, 0.125);
  c.stage[0].until.equilibrium = false;
  const Problem<2> fixed = build<2>(c, ".", ".");
  EXPECT_EQ(fixed.model.stages[0].until.time, 0.125);
  EXPECT_FALSE(settings::ends_at_equilibrium(fixed.model.stages[0])) << "a stage with a time ends by its time";
}

TEST(Equilibrium, is_no_sooner_than_a_wave_has_crossed_the_soil)
{
  Problem<2> problem = build<2>(resting_box(0.7), ".", ".");
  EXPECT_FALSE(in_balance(problem.model, problem.state, 0.));
  problem.state.time = 0.26 * problem.model.longest_period;
  EXPECT_TRUE(in_balance(problem.model, problem.state, 0.009));
  EXPECT_FALSE(in_balance(problem.model, problem.state, 0.011));
}

TEST(Equilibrium, is_no_sooner_than_all_of_gravity_acts)
{
  settings::Case c = resting_box(0.7);
  const Real without = *build<2>(c, ".", ".").model.stages[0].until.time;
  c.gravity_ramp = 3 * period_of(c);
  Problem<2> problem = build<2>(c, ".", ".");
  EXPECT_NEAR(*problem.model.stages[0].until.time, c.gravity_ramp + without, 1e-12);
  problem.state.time = 0.99 * c.gravity_ramp;
  EXPECT_FALSE(in_balance(problem.model, problem.state, 0.)) << "it follows a ramp so slow all the way";
  problem.state.time = 1.01 * c.gravity_ramp;
  EXPECT_TRUE(in_balance(problem.model, problem.state, 0.));
}

}  // namespace
}  // namespace berm::problem::this_file
