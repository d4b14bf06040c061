// SPDX-License-Identifier: BSD-3-Clause
// Soil far from a driven body rests (mpm.active_distance): what is left out of the steps keeps its state, and what is counted stays whole.
#include "mpm/inactive.hpp"
#include "pipe_in_sand.hpp"

#include <gtest/gtest.h>

namespace berm::this_file {
namespace {

constexpr Real round_off = 1e-12;  // as in momentum.cpp
constexpr Real distance = 0.025;   // m, 1.25 D

/// The pipe of 20 mm in a bed that is three times as long, so that there is soil far from it on both sides.
settings::Case pipe_in_long_bed(std::optional<Real> active_distance)
{
  settings::Case c = pipe_in_sand();
  auto& mesh = std::get<mesh::BoxMesh>(c.mesh);
  mesh.size[0] = 0.36;
  mesh.cells[0] = 90;
  c.body[0].second.block->center[0] = 0.18;
  c.body[0].second.block->size[0] = 0.36;
  std::get<bodies::CircleSettings>(c.rigid[0].second.shape).center[0] = 0.14;
  c.mpm.active_distance = active_distance;
  c.mpm.courant = 0.5;
  settings::StageSettings first, last;
  first.name = "at rest";
  first.until.time = infinity;
  last = first;
  last.name = "at rest again";
  c.stage.insert(c.stage.begin(), first);
  c.stage.push_back(last);
  return c;
}

/// Through all stages but the last: the drag, which the pipe begins 4 mm deep, goes some 13 um a step.
void push_and_drag(Simulation<2>& run, int steps_of_drag = 700)
{
  take_steps(run, 40);
  next_stage(run);
  take_steps(run, 300);
  next_stage(run);
  take_steps(run, steps_of_drag);
}

/// By number of the particle: 1 where it rests.
std::vector<char> rests(const bodies::Particles<2>& particles)
{
  std::vector<char> all(static_cast<std::size_t>(particles.size()));
  particles.visit([&](Index cell, Index b, int l) { all.at(particles.block(b).id[l]) = particles.is_inactive(cell) ? 1 : 0; });
  return all;
}
Index resting_particles(const bodies::Particles<2>& particles)
{
  const std::vector<char> all = rests(particles);
  return static_cast<Index>(std::count(all.begin(), all.end(), 1));
}

bool same(const bodies::Particle<2>& a, const bodies::Particle<2>& b)
{
  return a.id == b.id && a.x == b.x && a.v == b.v && a.volume == b.volume && a.mass == b.mass &&
         a.deviatoric_strain == b.deviatoric_strain && std::equal(a.stress.c, a.stress.c + 4, b.stress.c);
}

void expect_same(const problem::State<2>& a, const problem::State<2>& b)
{
  const auto ours = all_particles(a), theirs = all_particles(b);
  ASSERT_EQ(ours.size(), theirs.size());
  for (std::size_t k = 0; k < ours.size(); ++k) ASSERT_TRUE(same(ours[k], theirs[k])) << "particle " << k;
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.rigid_bodies[0].displacement, b.rigid_bodies[0].displacement);
  EXPECT_EQ(a.ledger.contact_sums[0].impulse, b.ledger.contact_sums[0].impulse);
  EXPECT_EQ(a.ledger.totals.internal, b.ledger.totals.internal);
  EXPECT_EQ(a.ledger.totals.external, b.ledger.totals.external);
  EXPECT_EQ(a.ledger.totals.damping, b.ledger.totals.damping);
  EXPECT_EQ(a.ledger.totals.support_impulse, b.ledger.totals.support_impulse);
  EXPECT_EQ(a.active_soil.stopped, b.active_soil.stopped);
}

TEST(RestingSoil, keeps_momentum_while_it_goes_with_a_pipe_and_wakes_where_nothing_is_driven)
{
  Simulation<2> run(pipe_in_long_bed(distance));
  const bodies::Particles<2>& particles = run.state().particles[0];
  take_steps(run, 40);
  EXPECT_EQ(resting_particles(particles), 0);  // nothing is driven yet
  next_stage(run);
  take_steps(run, 300);
  const std::vector<char> before = rests(particles);
  EXPECT_GT(resting_particles(particles), particles.size() / 2);
  EXPECT_LT(mpm::momentum_error(run.state()), round_off);
  next_stage(run);
  take_steps(run, 700);
  EXPECT_GT(run.state().rigid_bodies[0].displacement[0], 3 * 0.1 * distance);  // the active soil was found anew several times
  EXPECT_LT(mpm::momentum_error(run.state()), round_off);
  EXPECT_GT(mpm::sums_over(particles).kinetic, 0);
  const std::vector<char> after = rests(particles);
  Index woke = 0, came_to_rest = 0;
  for (std::size_t k = 0; k < after.size(); ++k) {
    woke += before[k] > after[k] ? 1 : 0;
    came_to_rest += after[k] > before[k] ? 1 : 0;
  }
  EXPECT_GT(woke, 0);
  EXPECT_GT(came_to_rest, 0);
  next_stage(run);
  take_steps(run, 40);
  EXPECT_EQ(resting_particles(particles), 0);
  EXPECT_LT(mpm::momentum_error(run.state()), round_off);
}

TEST(RestingSoil, keeps_its_state)
{
  Simulation<2> run(pipe_in_long_bed(distance));
  take_steps(run, 40);
  next_stage(run);
  take_steps(run, 16);
  const bodies::Particles<2>& particles = run.state().particles[0];
  const auto before = all_particles(run.state());
  const std::vector<char> rested = rests(particles);
  take_steps(run, 150);  // the pipe goes less than a tenth of the distance: no soil wakes
  ASSERT_LT(run.state().rigid_bodies[0].displacement.norm(), 0.1 * distance);
  const auto after = all_particles(run.state());
  Index moved = 0;
  for (std::size_t k = 0; k < after.size(); ++k) {
    if (rested[k] != 0) {
      ASSERT_TRUE(same(before[k], after[k])) << "particle " << k << " at " << before[k].x.transpose();
      EXPECT_EQ(after[k].v, Vec<2>(Vec<2>::Zero()));
    }
    moved += before[k].x != after[k].x ? 1 : 0;
  }
  EXPECT_GT(moved, (particles.size() - resting_particles(particles)) / 100 * 95);
}

// All soil is within ten metres: then nothing may differ from a run without the setting, to the last bit.
TEST(RestingSoil, changes_no_bit_where_all_soil_is_near)
{
  Simulation<2> far(pipe_in_long_bed(10)), without(pipe_in_long_bed(std::nullopt));
  push_and_drag(far);
  push_and_drag(without);
  EXPECT_FALSE(far.state().active_soil.everywhere);
  expect_same(far.state(), without.state());
}

TEST(RestingSoil, does_not_depend_on_threads)
{
  const auto state_with = [](int threads) {
    const int before = omp_get_max_threads();
    omp_set_num_threads(threads);
    Simulation<2> run(pipe_in_long_bed(distance));
    push_and_drag(run, 300);
    omp_set_num_threads(before);
    return run.state();
  };
  const problem::State<2> one = state_with(1);
  expect_same(one, state_with(2));
}

// What a checkpoint holds is enough: the cells that rest follow from the poses of the rigid bodies in it, which are not those of now.
TEST(RestingSoil, goes_on_from_the_state_alone)
{
  Simulation<2> run(pipe_in_long_bed(distance));
  push_and_drag(run);
  while (run.state().step % 16 != 5) take_steps(run, 1);
  ASSERT_NE(run.state().rigid_bodies[0].displacement, run.state().active_soil.poses[0].displacement);
  problem::State<2> state = run.state();
  for (auto& particles : state.particles) particles.set_inactive(nullptr);
  mpm::set_inactive_cells(run.model(), state);
  mpm::Workspace<2> workspace(run.model(), state);
  for (int n = 0; n < 200; ++n) {
    step(run.model(), state, workspace);
    take_steps(run, 1);
  }
  expect_same(state, run.state());
}

// Soil that moves when the active soil is found: what it has goes to the supports and to what damping takes.
TEST(RestingSoil, gives_away_its_momentum_and_energy_when_it_comes_to_rest)
{
  Simulation<2> run(pipe_in_long_bed(distance));
  take_steps(run, 32);
  next_stage(run);
  run.set_velocities([](const Vec<2>& x, const Vec<2>&) { return Vec<2>(0.1 + x[1], 0.2 * x[0]); });
  const auto before = mpm::sums_over(run.state().particles[0]);
  const problem::Totals<2> totals = run.state().ledger.totals;
  mpm::update_inactive_cells(run.model(), run.state(), run.workspace);
  const auto after = mpm::sums_over(run.state().particles[0]);
  EXPECT_GT(resting_particles(run.state().particles[0]), 0);
  EXPECT_LT(after.kinetic, 0.6 * before.kinetic);
  EXPECT_GT(after.kinetic, 0);
  EXPECT_NEAR(run.state().active_soil.stopped, before.kinetic - after.kinetic, round_off * before.kinetic);
  EXPECT_NEAR(run.state().ledger.totals.damping - totals.damping, before.kinetic - after.kinetic, round_off * before.kinetic);
  const Vec<2> lost = before.momentum - after.momentum;
  EXPECT_NEAR((run.state().ledger.totals.support_impulse - totals.support_impulse + lost).norm(), 0, round_off * before.momentum.norm());
}

}  // namespace
}  // namespace berm::this_file
