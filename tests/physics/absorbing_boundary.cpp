// SPDX-License-Identifier: BSD-3-Clause
// What a boundary that absorbs sends back, against the exact answer at normal incidence: nothing.
#include "pipe_in_sand.hpp"

#include <gtest/gtest.h>

namespace berm::this_file {
namespace {

constexpr Real density = 1800, young_modulus = 50e6, poisson_ratio = 0.3;
constexpr Real shear_modulus = young_modulus / (2 * (1 + poisson_ratio));
constexpr Real oedometer_modulus = young_modulus * (1 - poisson_ratio) / ((1 + poisson_ratio) * (1 - 2 * poisson_ratio));

boundary::SupportSettings absorbing(const char* boundary)
{
  boundary::SupportSettings support{boundary, {"x", "y"}};
  support.absorbs = true;
  return support;
}

/// A strip of 1 m along x, in cells of 1/64 m, both of whose ends absorb.
settings::Case strip(const char* held_along)
{
  settings::Case c = elastic_box(2, {1, 1. / 32}, {64, 2}, young_modulus, poisson_ratio, density);
  c.body[0].second.particles_per_cell = 4;
  c.support = {
      {"left", absorbing("left")}, {"right", absorbing("right")}, {"bottom", {"bottom", {held_along}}}, {"top", {"top", {held_along}}}};
  return c;
}

template <int dim>
Real energy(Simulation<dim>& run)
{
  return mpm::sums_over(run.state().particles[0]).kinetic + run.state().ledger.totals.internal;
}

Real momentum_of(Simulation<2>& run)
{
  return mpm::sums_over(run.state().particles[0]).momentum[0];
}

/// A pulse of half a metre in the middle.
void start_pulse(int direction, Simulation<2>& run)
{
  run.set_velocities([&](const Vec<2>& x, const Vec<2>&) {
    Vec<2> v = Vec<2>::Zero();
    if (std::abs(x[0] - 0.5) < 0.25) v[direction] = 1e-3 * std::pow(std::cos(2 * pi * (x[0] - 0.5)), 2);
    return v;
  });
}

/// A pulse which runs to both ends and leaves: what is left of its energy once its slowest part has come to an end and back.
Real part_sent_back(int direction, Real speed, Simulation<2>& run)
{
  start_pulse(direction, run);
  const Real before = energy(run);
  run.run_until(1.0 / speed);
  return energy(run) / before;
}

TEST(AbsorbingBoundary, sends_back_less_than_a_hundredth_of_a_pressure_wave)
{
  Simulation<2> run(strip("y"));
  EXPECT_LT(part_sent_back(0, std::sqrt(oedometer_modulus / density), run), 0.01);
}

TEST(AbsorbingBoundary, sends_back_less_than_a_hundredth_of_a_shear_wave)
{
  Simulation<2> run(strip("x"));
  EXPECT_LT(part_sent_back(1, std::sqrt(shear_modulus / density), run), 0.01);
}

TEST(AbsorbingBoundary, leaves_the_strip_at_rest_five_hundred_steps_later)
{
  Simulation<2> run(strip("y"));
  const Real speed = std::sqrt(oedometer_modulus / density);
  start_pulse(0, run);
  const Real before = energy(run), momentum = momentum_of(run);
  run.run_until(1.0 / speed);
  const BigIndex then = run.state().step + 500;
  while (run.state().step < then) step(run.model(), run.state(), run.workspace);
  EXPECT_LT(energy(run) / before, 1e-3) << "what is left are velocities that differ from cell to cell";
  EXPECT_LT(std::abs(momentum_of(run)), 1e-3 * momentum);
}

// Held ends send all of it back: the test above can fail.
TEST(AbsorbingBoundary, that_only_holds_sends_all_of_it_back)
{
  settings::Case c = strip("y");
  c.support[0].second.absorbs = c.support[1].second.absorbs = false;
  Simulation<2> run(c);
  EXPECT_GT(part_sent_back(0, std::sqrt(oedometer_modulus / density), run), 0.9);
}

TEST(AbsorbingBoundary, in_space_sends_back_less_than_a_hundredth)
{
  settings::Case c = elastic_box(3, {1, 1. / 32, 1. / 32}, {64, 2, 2}, young_modulus, poisson_ratio, density);
  boundary::SupportSettings end = absorbing("left");
  end.fixed = {"x", "y", "z"};
  c.support = {
      {"left", end}, {"bottom", {"bottom", {"y"}}}, {"top", {"top", {"y"}}}, {"front", {"front", {"z"}}}, {"back", {"back", {"z"}}}};
  end.boundary = "right";
  c.support.emplace_back("right", end);
  Simulation<3> run(c);
  const Real speed = std::sqrt(oedometer_modulus / density);
  run.set_velocities([&](const Vec<3>& x, const Vec<3>&) {
    return std::abs(x[0] - 0.5) < 0.25 ? Vec<3>(1e-3 * std::pow(std::cos(2 * pi * (x[0] - 0.5)), 2), 0, 0) : Vec<3>(0, 0, 0);
  });
  const Real before = energy(run);
  run.run_until(1.0 / speed);
  EXPECT_LT(energy(run) / before, 0.01);
}

// The walls of a bed at rest keep the thrust that they had while they held, to what the stress of the start is out of balance.
TEST(AbsorbingBoundary, keeps_the_thrust_of_a_bed_at_rest)
{
  constexpr Real gravity = 10, k0 = 0.43;
  settings::Case c = elastic_box(2, {1, 0.5}, {8, 4}, young_modulus, poisson_ratio, density);
  c.gravity = {0, -gravity};
  c.surface = 0.5;
  c.body[0].second.k0 = k0;
  c.body[0].second.damping = 0.3;  // acts on what is out of balance with the thrust
  c.mpm.volumetric_projection = false;
  c.output.support_reactions = true;
  c.stage.insert(c.stage.begin(), c.stage.front());
  c.stage[0].name = "rest";
  c.stage[0].kind = settings::StageKind::geostatic;
  boundary::SupportSettings left = absorbing("left"), right = absorbing("right");
  left.fixed = right.fixed = {"x"};
  c.support = {{"base", {"bottom", {"y"}}}, {"left", left}, {"right", right}};
  Simulation<2> run(c);
  run.run_until(0.01);
  run.state().stage.index = 1;
  begin_stage(run.model(), run.state());
  const Vec<2> before = run.state().ledger.support_impulses[1];
  const Real begin = run.state().time;
  run.run_until(begin + 0.1);
  const Real thrust = k0 * density * gravity * 0.5 * 0.5 / 2;
  EXPECT_NEAR((run.state().ledger.support_impulses[1] - before)[0] / (run.state().time - begin), thrust, 1e-3 * thrust);
  EXPECT_LT(mpm::sums_over(run.state().particles[0]).fastest, 1e-6);
  EXPECT_LT(mpm::momentum_error(run.state(), run.model().mesh.metric), 1e-11);
}

}  // namespace
}  // namespace berm::this_file
