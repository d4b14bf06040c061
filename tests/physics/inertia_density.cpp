// SPDX-License-Identifier: BSD-3-Clause
// Submerged soil has the weight of its submerged density and the inertia of the saturated soil and the water that it moves.
#include "simulate.hpp"

#include <gtest/gtest.h>

namespace berm::this_file {
namespace {

constexpr Real weight_density = 900, inertia = 2400, gravity = 10;

settings::Case submerged_block(bool held)
{
  settings::Case c = elastic_box(2, {1, 1}, {8, 8}, 1e6, 0.2, weight_density);
  c.material[0].second.get<material::LinearElastic>().inertia_density = inertia;
  c.gravity = {0, -gravity};
  c.body[0].second.regions.clear();
  bodies::BlockSettings block;
  block.center = {0.5, held ? 0.25 : 0.7};
  block.size = {1, 0.5};
  block.spacing = 0.0625;
  c.body[0].second.block = block;
  if (held) c.support = {{"base", {"bottom", {"y"}}}};
  return c;
}

TEST(InertiaDensity, slows_a_free_fall_down_to_the_weight_over_the_inertia)
{
  Simulation<2> run(submerged_block(false));
  run.run_until(0.1);
  const Real t = run.state().time, acceleration = gravity * weight_density / inertia;
  const mpm::BodySums<2> sums = mpm::sums_over(run.state().particles[0]);
  EXPECT_NEAR(sums.mass, inertia * 0.5, 1e-9);
  EXPECT_NEAR(sums.momentum[1] / sums.mass, -acceleration * t, 1e-10);
  EXPECT_NEAR(run.state().ledger.totals.external, sums.kinetic, 1e-10 * sums.kinetic);
  EXPECT_LT(mpm::momentum_error(run.state()), 1e-12);
}

TEST(InertiaDensity, leaves_the_weight_on_the_ground_as_it_is)
{
  settings::Case c = submerged_block(true);
  c.body[0].second.damping = 0.5;
  Simulation<2> run(c);
  run.run_until(1);
  const Vec<2> before = run.state().ledger.totals.support_impulse;
  const Real begin = run.state().time;
  run.run_until(1.2);
  const Real on_base = (run.state().ledger.totals.support_impulse - before)[1] / (run.state().time - begin);
  EXPECT_NEAR(on_base, weight_density * gravity * 0.5, 1e-3 * weight_density * gravity * 0.5);  // some of its vibration may be left
}

TEST(InertiaDensity, slows_the_waves_that_the_time_step_comes_from)
{
  Simulation<2> run(submerged_block(true));
  step(run.model(), run.state(), run.workspace);
  const Real slow = run.state().dt;
  settings::Case c = submerged_block(true);
  c.material[0].second.get<material::LinearElastic>().inertia_density.reset();
  Simulation<2> quick(c);
  step(quick.model(), quick.state(), quick.workspace);
  EXPECT_NEAR(slow / quick.state().dt, std::sqrt(inertia / weight_density), 1e-12);
}

}  // namespace
}  // namespace berm::this_file
