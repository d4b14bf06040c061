// SPDX-License-Identifier: BSD-3-Clause
#include "fem/load_steps.hpp"

#include "os/error.hpp"
#include "samples/fem_sample_problem.hpp"

#include <gtest/gtest.h>

namespace berm::fem::this_file {
namespace {

/// A case on its way: each call of to_end_of_stage() goes through one stage.
struct Way {
  FemProblem problem;
  LoadSteps steps;
  int increments = 0;

  explicit Way(const settings::Case& c) : problem(fem_problem_of(c)), steps(problem.model, problem.state)
  {
    steps.find_first_equilibrium();
  }

  template <class Look>
  void to_end_of_stage(const Look& look)
  {
    do {
      const IncrementEnd end = steps.advance();
      ++increments;
      look(end);
    } while (!stage_ended(problem.model.model, problem.state.state));
  }
  void to_end_of_stage()
  {
    to_end_of_stage([](const IncrementEnd&) {});
  }
  const bodies::RigidState<2>& rigid() const { return problem.state.state.rigid_bodies[problem.model.model.main_rigid]; }
  Real V() const { return rigid().reaction[1]; }
  Real energy_error() const
  {
    const problem::Totals<2>& t = problem.state.state.ledger.totals;
    return (t.internal + t.friction - t.external) / t.external;
  }
};

/// A rough plate of 0.4 m on clay of 1 kPa that is stiff enough to fail within 0.02 m, pushed in.
settings::Case plate_on_clay()
{
  settings::Case c = plate_on_block(plastic_soil(1e3, 0, 0), 0.4, {10, 5});
  c.contact[0].second.friction_angle = std::atan(0.5);
  c.stage = {pushing()};
  c.stage[0].until.embedment = 0.03;
  return c;
}

TEST(LoadSteps, stop_at_the_embedment_the_displacement_and_the_time)
{
  settings::Case c = plate_on_clay();
  c.stage[0].until.embedment = 0.0123;
  c.stage.push_back(dragging(settings::Vertical::fixed));
  c.stage[1].until.displacement = 0.00456;
  c.stage.push_back(resting(0.789));
  Way way(c);
  way.to_end_of_stage();
  EXPECT_NEAR(way.rigid().displacement[1], -0.0123, 1e-15);
  EXPECT_EQ(way.rigid().displacement[0], 0);
  ASSERT_TRUE(way.steps.next_stage());
  way.to_end_of_stage();
  EXPECT_NEAR(way.rigid().displacement[0], 0.00456, 1e-15);
  EXPECT_NEAR(way.rigid().displacement[1], -0.0123, 1e-15);
  EXPECT_NEAR(way.problem.state.state.time, 0.0123 + 0.00456, 1e-14);  // at 1 m/s
  ASSERT_TRUE(way.steps.next_stage());
  way.to_end_of_stage();
  EXPECT_NEAR(way.problem.state.state.time, 0.0123 + 0.00456 + 0.789, 1e-14);
  EXPECT_FALSE(way.steps.next_stage());
}

TEST(LoadSteps, follow_the_ramp_of_a_velocity)
{
  settings::Case c = plate_on_clay();
  c.stage[0].ramp = 0.01;  // of which half its time is lost
  Way way(c);
  way.to_end_of_stage();
  EXPECT_NEAR(way.problem.state.state.time, 0.03 + 0.005, 1e-12);
}

TEST(LoadSteps, stop_at_a_force)
{
  settings::Case c = plate_on_clay();
  c.stage[0].until.embedment = {};
  c.stage[0].until.force = 1234;
  Way way(c);
  way.to_end_of_stage();
  EXPECT_GE(way.V(), 1234);
  EXPECT_LE(way.V(), 1234 * (1 + 1e-4));  // what the stage allows beyond
}

TEST(LoadSteps, hold_the_vertical_force_in_a_drag_within_the_tolerance)
{
  settings::Case c = plate_on_clay();
  c.stage[0].until.embedment = {};
  c.stage[0].until.force = 900;
  c.stage.push_back(dragging(settings::Vertical::hold));
  c.stage[1].until.displacement = 0.02;
  Way way(c);
  way.to_end_of_stage();
  const Real held = way.V();
  ASSERT_TRUE(way.steps.next_stage());
  way.to_end_of_stage([&](const IncrementEnd&) { EXPECT_NEAR(way.V() / held, 1, 2 * way.problem.model.settings.tolerance); });
  EXPECT_GT(-way.rigid().reaction[0], 0.3 * held);  // the plate's friction is 0.5
  EXPECT_LE(-way.rigid().reaction[0], 0.5 * held * (1 + 1e-3));
}

TEST(LoadSteps, a_force_pushes_until_the_soil_answers_with_it)
{
  settings::Case c = plate_on_clay();
  c.stage[0].velocity = {};
  c.stage[0].force = 1000;
  c.stage[0].ramp = 1;
  c.stage[0].until.embedment = {};
  c.stage[0].until.time = 1;
  Way way(c);
  way.to_end_of_stage();
  EXPECT_NEAR(way.V() / 1000, 1, 2 * way.problem.model.settings.tolerance);
}

TEST(LoadSteps, a_plate_that_may_turn_carries_no_moment)
{
  // Half of the block is twice as stiff, so that a plate that cannot turn gets a moment.
  settings::Case c = plate_on_block(elastic_soil(), 0.4, {10, 5});
  c.rigid[0].second.shape = bodies::BoxSettings{{0.3, 0.6}, {0.4, 0.2}};
  c.contact[0].second.friction_angle = std::atan(0.5);
  c.stage = {pushing()};
  c.stage[0].until.embedment = 0.01;
  Way fixed(c);
  fixed.to_end_of_stage();
  EXPECT_GT(std::abs(fixed.rigid().torque), 1e-2 * fixed.V() * 0.4);
  EXPECT_EQ(fixed.rigid().orientation.angle, 0);
  c.rigid[0].second.rotation = bodies::Rotation::free;
  Way turns(c);
  turns.to_end_of_stage();
  EXPECT_LT(std::abs(turns.rigid().torque), turns.problem.model.settings.tolerance * turns.V() * 0.4);
  EXPECT_NE(turns.rigid().orientation.angle, 0);
}

void expect_top_to_sink_under_weight(const Way& way)
{
  // A column sinks by rho g h2 / (2 M), which quadratic elements find exactly.
  const Real exact = 1000 * 10 * 0.5 * 0.5 / (2 * oedometer_modulus);
  const FemModel& model = way.problem.model;
  int at_top = 0;
  for (Index node = 0; node < model.mesh.node_count(); ++node) {
    if (model.mesh.position[node][1] != 0.5) continue;
    EXPECT_NEAR(way.problem.state.displacement[2 * node + 1] / -exact, 1, model.settings.tolerance);
    ++at_top;
  }
  EXPECT_EQ(at_top, 9);
}

TEST(LoadSteps, settling_leaves_a_bed_with_k0_stresses_as_it_is)
{
  settings::Case c = block_of(plastic_soil(0, 35, 0));
  c.gravity = {0, -10};
  c.body[0].second.k0 = 0.43;
  Way way(c);
  way.to_end_of_stage();
  for (const Real u : way.problem.state.displacement) EXPECT_EQ(u, 0);
  EXPECT_LT(way.problem.state.unbalanced, 1e-12 * way.problem.model.weight);
}

TEST(LoadSteps, settling_brings_a_bed_without_stresses_under_its_weight)
{
  settings::Case c = block_of(elastic_soil());
  c.gravity = {0, -10};
  Way way(c);
  expect_top_to_sink_under_weight(way);
  EXPECT_NEAR(way.energy_error(), 0, 1e-3);
}

TEST(LoadSteps, a_bed_that_cannot_carry_its_weight_flows_and_its_overstress_tells)
{
  // A block of 0.5 m without walls needs 10 kPa x 0.5 / 4 = 1.25 kPa at least. The viscosity finds an equilibrium for any load.
  settings::Case c = block_of(plastic_soil(200, 0, 0));
  c.gravity = {0, -10};
  c.support = {{"base", {"bottom", {"x", "y"}}}};
  Way weak(c);
  weak.to_end_of_stage();
  EXPECT_GT(weak.problem.state.overstress, 0.1);  // the stress that it is compared with has its mean, too
  c.material = {{"soil", plastic_soil(2000, 0, 0)}};
  Way strong(c);
  strong.to_end_of_stage();
  EXPECT_LT(strong.problem.state.overstress, 1e-3);
}

TEST(LoadSteps, a_force_beyond_the_strength_of_the_soil_is_refused)
{
  // The plate carries (2 + pi) x 1 kPa x 0.4 m = 2.06 kN/m at most.
  settings::Case c = plate_on_clay();
  c.stage[0].velocity.reset();
  c.stage[0].force = 8e3;
  c.stage[0].ramp = 1;
  c.stage[0].until = {};
  c.stage[0].until.time = 2;
  Way way(c);
  try {
    way.to_end_of_stage();
    ADD_FAILURE() << "8 kN/m were carried, with an overstress of " << way.problem.state.overstress;
  } catch (const RunError& error) {
    EXPECT_NE(std::string(error.what()).find("cannot carry the force"), std::string::npos) << error.what();
  }
  EXPECT_GT(way.V(), 2e3);
}

TEST(LoadSteps, increments_are_short_while_strength_follows_a_growing_pressure)
{
  settings::Case c = plate_on_block(plastic_soil(500, 30, 0), 0.4, {10, 5});
  c.contact[0].second.friction_angle = std::atan(0.5);
  c.fem.largest_step = 0.5;
  c.stage = {pushing()};
  c.stage[0].until.embedment = 0.04;
  Way way(c);
  Real force = 0, time = 0, growth = 0;
  int grown = 0;
  way.to_end_of_stage([&](const IncrementEnd&) {
    // 0.005 of the width at the speed of 1 m/s is 2 ms.
    const Real dt = way.problem.state.state.time - time;
    EXPECT_LE(dt, growth > 0.02 ? 2e-3 * (1 + 1e-9) : 1) << "after a growth of " << growth;
    grown += growth > 0.02;
    growth = std::abs(way.V() - force) / way.V();
    force = way.V();
    time += dt;
  });
  EXPECT_GT(grown, 5);
}

TEST(LoadSteps, the_strength_that_follows_a_growing_pressure_lags_by_a_hundredth_at_most_and_so_does_the_force)
{
  settings::Case c = plate_on_block(plastic_soil(500, 30, 0), 0.4, {10, 5});
  c.contact[0].second.friction_angle = std::atan(0.5);
  c.stage = {pushing()};
  const auto force_after = [&](Real travel, Real largest_step) {
    c.stage[0].until.embedment = travel;
    c.fem.largest_step = largest_step;
    Way way(c);
    StrengthLag sum;
    way.to_end_of_stage([&](const IncrementEnd& end) {
      sum.missing += std::abs(end.lag.missing);
      sum.dissipated += end.lag.dissipated;
    });
    EXPECT_GT(sum.dissipated, 0);
    EXPECT_LT(sum.part(), 0.01);
    return way.V();
  };
  // Increments of 0.005 of the width at most, and a tenth of that: a hundredth for the lag, another for the path. The plate has failed by 0.02 m.
  for (const Real travel : {0.002, 0.005, 0.01}) EXPECT_NEAR(force_after(travel, 0.02) / force_after(travel, 5e-4), 1, 0.02) << travel;
}

TEST(LoadSteps, gravity_grows_over_its_ramp)
{
  settings::Case c = block_of(elastic_soil());
  c.gravity = {0, -10};
  c.gravity_ramp = 0.8;
  Way way(c);
  for (const Real u : way.problem.state.displacement) EXPECT_EQ(u, 0);
  way.to_end_of_stage();
  expect_top_to_sink_under_weight(way);
  EXPECT_NEAR(way.energy_error(), 0, 1e-3);
}

TEST(LoadSteps, work_is_stored_dissipated_or_lost_to_friction)
{
  settings::Case c = plate_on_clay();
  c.stage.push_back(dragging(settings::Vertical::hold));
  c.stage[1].until.displacement = 0.02;
  Way way(c);
  way.to_end_of_stage();
  // What is left is the unbalanced forces on the movement.
  EXPECT_NEAR(way.energy_error(), 0, 2 * way.problem.model.settings.tolerance);
  ASSERT_TRUE(way.steps.next_stage());
  way.to_end_of_stage();
  EXPECT_NEAR(way.energy_error(), 0, 2 * way.problem.model.settings.tolerance);
}

TEST(LoadSteps, the_plateau_does_not_depend_on_the_size_of_the_increments)
{
  settings::Case c = plate_on_clay();
  Way coarse(c);
  coarse.to_end_of_stage();
  c.fem.largest_step = 0.001;
  Way fine(c);
  fine.to_end_of_stage();
  EXPECT_GT(fine.increments, 70);  // 0.03 m in steps of at most 0.4 mm
  EXPECT_LT(coarse.increments, fine.increments);
  EXPECT_NEAR(coarse.V() / fine.V(), 1, 0.01);
  EXPECT_GT(coarse.V(), 5.14 * 1e3 * 0.4);  // Prandtl's strip
  EXPECT_LT(coarse.V(), 6.2 * 1e3 * 0.4);   // with four sides under it
  EXPECT_LT(coarse.problem.state.overstress, 1e-3);
}

TEST(LoadSteps, fail_with_the_stage_the_time_and_what_may_help)
{
  // The drag may be 0.5 of V at most.
  settings::Case c = plate_on_clay();
  c.stage[0].until.embedment = {};
  c.stage[0].until.force = 900;
  c.stage.push_back(dragging(settings::Vertical::hold));
  c.stage[1].velocity = {};
  c.stage[1].force = 800;
  c.stage[1].ramp = 1;
  c.stage[1].until.time = 1;
  Way way(c);
  way.to_end_of_stage();
  ASSERT_TRUE(way.steps.next_stage());
  try {
    way.to_end_of_stage();
    FAIL() << "an equilibrium was found with H = " << -way.rigid().reaction[0];
  } catch (const RunError& error) {
    const std::string message = error.what();
    for (const char* part : {"stage \"drag\": no equilibrium at t = ", "unbalanced forces", "fem.relaxation"})
      EXPECT_NE(message.find(part), std::string::npos) << message;
  }
  EXPECT_NEAR(-way.rigid().reaction[0] / 450, 1, 0.02);  // how far it came
}

}  // namespace
}  // namespace berm::fem::this_file
