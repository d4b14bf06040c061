// SPDX-License-Identifier: BSD-3-Clause
#include "settings/water_loads.hpp"

#include "samples/sample_driver.hpp"
#include "settings/load_checks.hpp"

#include <gtest/gtest.h>

namespace berm::problem::this_file {
namespace {

constexpr Real D = 0.4, mass = 2;  // of the sample pipe, which hangs above the seabed

settings::StageSettings in_water(std::vector<Real> times, std::vector<Real> velocities)
{
  settings::StageSettings stage = stage_of(settings::StageKind::drag, "storm");
  stage.load_times = std::move(times);
  stage.loads.of("water") = std::move(velocities);
  stage.water = settings::WaterSettings{.density = 1000, .weight = 1e-6};
  return stage;
}

TEST(WaterForce, is_morisons_of_the_relative_velocity_less_what_the_embedment_takes)
{
  const settings::WaterSettings water{.density = 1025, .drag = 0.9, .inertia = 3.29, .lift = 0.8, .weight = 400, .permeable = true};
  const settings::WaterForce at_rest = water_force(water, {-1.2, 0.7}, 0.25, 0, 0);
  EXPECT_NEAR(at_rest.H, -0.5 * 1025 * 0.25 * 0.9 * 1.44 + 1025 * pi / 4 * 0.0625 * 3.29 * 0.7, 1e-9);
  EXPECT_NEAR(at_rest.V, 400 - 0.7 * 0.5 * 1025 * 0.25 * 0.8 * 1.44, 1e-9);
  const settings::WaterForce moving = water_force(water, {-1.2, 0.7}, 0.25, -0.4, 0.05);  // w = 0.2 D
  EXPECT_NEAR(moving.H, 0.72 * (-0.5 * 1025 * 0.25 * 0.9 * 0.64 + 1025 * pi / 4 * 0.0625 * 3.29 * 0.7), 1e-9);
  EXPECT_NEAR(moving.V, 400 - 0.87 * 0.7 * 0.5 * 1025 * 0.25 * 0.8 * 0.64, 1e-9);
  const settings::WaterForce above = water_force(water, {-1.2, 0.7}, 0.25, 0, -0.1);
  EXPECT_EQ(above.H, at_rest.H) << "a pipe off the seabed counts as one that lies on it";
  EXPECT_NEAR(mass_in_water(water, 0.25), 400 / 9.80665 + 3.29 * 1025 * pi / 4 * 0.0625, 1e-9);
}

// m dv/dt = c (U - v)^2: v = U - U/(1 + c U t/m). Explicit steps err by dt/2 of dv/dt at most.
TEST(Water, that_flows_takes_a_pipe_along)
{
  constexpr Real U = 0.8, c = 1000 * D / 2 * 0.05;
  settings::StageSettings stage = in_water({0, 10}, {U, U});
  stage.water->drag = 0.05;
  Driver run({stage});
  for (int n = 1; n <= 2000; ++n) {
    run.step();
    ASSERT_NEAR(run.pipe.velocity[0], U - U / (1 + c * U * n * dt / mass), dt / 2 * c * U * U / mass) << n;
  }
  EXPECT_GT(run.pipe.velocity[0], 0.7 * U);
}

TEST(Water, that_accelerates_takes_along_a_pipe_that_has_the_mass_of_its_inertia)
{
  settings::StageSettings stage = in_water({0, 1, 2, 3}, {0.2, 1.2, -0.8, -0.8});
  stage.water->inertia = mass / (1000 * pi / 4 * D * D);
  Driver run({stage});
  for (int n = 1; n <= 2500; ++n) {
    run.step();
    const Real t = n * dt, water = t < 1 ? 0.2 + t : t < 2 ? 1.2 - 2 * (t - 1) : -0.8;
    ASSERT_NEAR(run.pipe.velocity[0], water - 0.2, 4 * dt) << n << ": a kink falls within a step";
  }
}

TEST(Water, presses_the_pipe_down_by_its_weight_less_the_lift)
{
  settings::StageSettings stage = in_water({0, 10}, {1, 1});
  stage.water->lift = 0.3, stage.water->weight = 50;
  Driver run({stage});
  run.step();
  EXPECT_NEAR(run.pipe.velocity[1], dt * (0.5 * 1000 * D * 0.3 - 50) / mass, 1e-12);
}

TEST(Water, that_makes_no_sense_is_refused_with_the_key)
{
  settings::Case c = pipe_over_box({in_water({0, 1}, {0, 1})});
  const auto fault = [&](const auto& change) {
    settings::Case changed = c;
    change(changed.stage[0], changed);
    return fault_of_loads(changed, changed.stage[0]);
  };
  using Stage = settings::StageSettings;
  using Case = settings::Case;
  EXPECT_EQ(fault([](Stage&, Case&) {}), "");
  EXPECT_TRUE(fault([](Stage& s, Case&) { s.water.reset(); }).starts_with("loads.water: needs [stage.water]"));
  EXPECT_TRUE(fault([](Stage& s, Case&) { s.loads.of("water").clear(), s.loads.of("H") = {0, 1}; }).starts_with("water: is for a load"));
  EXPECT_TRUE(fault([](Stage& s, Case&) { s.time_scale = 0.3; }).starts_with("time_scale: must be 1 with [stage.water]"));
  EXPECT_TRUE(fault([](Stage& s, Case&) { s.loads.of("V") = {0, 1}; }).starts_with("loads.V: cannot be combined with water"));
  EXPECT_TRUE(fault([](Stage& s, Case&) { s.vertical_force = 3; }).starts_with("loads.water: drives what another key"));
  EXPECT_TRUE(fault([](Stage& s, Case&) { s.water->trench_depth = 1; }).starts_with("water.trench_angle: of a trench"));
  EXPECT_TRUE(fault([](Stage&, Case& of) {
                of.rigid[0].second.shape = bodies::CircleSettings{{1, 1.3}, 0.4};
                of.geometry = settings::Geometry::axisymmetric;
              }).starts_with("loads.water: drives nothing in this stage"));
}

}  // namespace
}  // namespace berm::problem::this_file
