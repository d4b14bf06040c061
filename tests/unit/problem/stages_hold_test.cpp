// SPDX-License-Identifier: BSD-3-Clause
// What a stage holds of the force that the soil had on the body when it began.
#include "samples/sample_driver.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace berm::problem::this_file {
namespace {

constexpr Real diameter = 0.4, velocity = 0.02, end = 0.1 * diameter;  // m, m/s

/// V of soil that a body is pushed into, N/m.
Real V_at(Real w)
{
  return 1000 * std::sqrt(w / end);
}

/// The force that a drag holds after a push in so many steps, over V at its end. The force of each step is a tenth higher or lower, every fifth step another.
Real held_after_push(int steps)
{
  Driver run({push(velocity), drag(velocity)});
  run.problem.model.rigid_bodies[0].fading = {0.01 * diameter, 0.1};
  const Real step = end / velocity / steps;
  begin_stage(run.problem.model, run.problem.state);
  for (int n = 1; n <= steps; ++n) {
    drive_rigids(run.problem.model, run.problem.state, step);
    run.pipe.reaction = {0, V_at(n * step * velocity) * (n / 5 % 2 == 0 ? 0.9 : 1.1)};
    run.problem.state.dt = step;
    move_rigids(run.problem.model, run.problem.state);
    run.problem.state.time += step;
  }
  run.next_stage();
  EXPECT_TRUE(run.problem.state.stage.drive[1].by_force);
  return -run.problem.state.stage.drive[1].to / V_at(end);
}

// V bends by -V/(4 w^2): over the travel s = D/100 that is V (s/2w)^2 = 0.25 %. Of a chatter of 10 %, five steps up and five down, a mean that takes the part a = 0.01 of each step (1000 steps in all) leaves a
// quarter of a swing, 10 % 2.5 a = 0.25 %, and the trend as much again.
TEST(Hold, is_of_the_force_at_the_end_of_a_push_whatever_the_step)
{
  for (const int steps : {1000, 2000, 10000}) EXPECT_NEAR(held_after_push(steps), 1, 0.01) << steps << " steps";
}

TEST(Hold, of_a_moment_is_of_that_without_its_chatter)
{
  settings::StageSettings turn = stage_of(settings::StageKind::drive), more = stage_of(settings::StageKind::drive);
  turn.drive.rotation.velocity = 0.1;
  more.drive.rotation.moment = 80;
  Driver run({turn, more});
  run.problem.model.rigid_bodies[0].fading = {infinity, 0.1};
  begin_stage(run.problem.model, run.problem.state);
  run.pipe.reaction = {0, 100};
  for (int n = 1; n <= 2000; ++n) {
    run.pipe.torque = 50 + (n % 2 == 0 ? 20 : -20);
    run.problem.state.dt = dt;
    move_rigids(run.problem.model, run.problem.state);
  }
  run.next_stage();
  EXPECT_NEAR(run.problem.state.stage.drive[2].from, -50, 0.5) << "20 N by a = 0.01, the part of a step, of two means";
  EXPECT_EQ(run.problem.state.stage.drive[2].to, 80);
}

/// Adds steps of a force that depends on the way of the body since it touched, at a speed that changes within the way.
template <class Force, class Speed>
bodies::RecentReaction<2> pushed(Real way, const Force& force, const Speed& speed)
{
  bodies::RecentReaction<2> recent;
  const bodies::Fading fading{0.005, 0.2};
  while (recent.way < way) {
    const Real step_way = dt * speed(recent.way);
    recent.add(Vec<2>(0, force(recent.way + step_way)), 0, step_way, dt, fading);
  }
  return recent;
}

TEST(RecentReaction, has_no_lag_where_a_force_grows_steadily_with_the_way_at_any_speed)
{
  const auto force = [](Real way) { return 1e5 * way; };
  for (const Real slower : {0., 0.9}) {
    const auto recent = pushed(0.1, force, [&](Real way) { return 0.02 * (1 - slower * way / 0.1); });
    EXPECT_NEAR(recent.force()[1] / force(recent.way), 1, 1e-9) << slower;
    EXPECT_LT(recent.mean_force[1] / force(recent.way), 0.999) << "its mean is late";
  }
}

TEST(RecentReaction, knows_a_force_that_has_only_begun)
{
  const auto recent = pushed(
      0.0005, [](Real way) { return 1e5 * way; }, [](Real) { return 0.02; });
  EXPECT_NEAR(recent.force()[1], 1e5 * recent.way, 1e-6) << "a tenth of the travel over which it fades";
}

TEST(RecentReaction, fades_by_travel_or_by_time_and_not_by_steps)
{
  const auto left_after = [](Real way, Real time, int steps) {
    const bodies::Fading fading{0.005, 0.2};
    auto recent = bodies::RecentReaction<2>::steady(Vec<2>(0, 1), 0);
    recent.way = 1;
    for (int n = 0; n < steps; ++n) recent.add(Vec<2>(1, 0), 0, way / steps, time / steps, fading);
    return recent.mean_force[1];
  };
  for (const int steps : {2000, 20000}) {
    EXPECT_NEAR(left_after(0, 0.2, steps), std::exp(-1), 1e-3);
    EXPECT_NEAR(left_after(0.005, 0.002, steps), std::exp(-1.01), 1e-3);
  }
}

TEST(RecentReaction, is_that_of_the_last_step_where_nothing_says_how_it_fades)
{
  auto recent = bodies::RecentReaction<2>::steady(Vec<2>(0, 1), 0);
  recent.add(Vec<2>(3, 4), 5, 1e-3, 1e-3, {});
  EXPECT_EQ(recent.force(), Vec<2>(3, 4));
  EXPECT_EQ(recent.torque(), 5);
}

}  // namespace
}  // namespace berm::problem::this_file
