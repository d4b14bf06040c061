// SPDX-License-Identifier: BSD-3-Clause
// What the soil is given is what it has: momentum, mass and the reaction of a pipe.
#include "pipe_in_sand.hpp"

#include <gtest/gtest.h>

namespace berm::this_file {
namespace {

// Some 1e3 additions of forces that nearly cancel: 1e-16 times their number, with a wide margin.
constexpr Real round_off = 1e-12;

std::vector<Real> masses(const problem::State<2>& state)
{
  std::vector<Real> all;
  for (const auto& p : all_particles(state)) all.push_back(p.mass);
  return all;
}

TEST(Momentum, is_what_gravity_contact_supports_and_damping_gave_while_a_pipe_is_pushed_and_dragged)
{
  Simulation<2> run(pipe_in_sand());
  const auto mass = masses(run.state());
  take_steps(run, 300);
  EXPECT_LT(mpm::momentum_error(run.state()), round_off);
  next_stage(run);
  take_steps(run, 300);
  EXPECT_LT(mpm::momentum_error(run.state()), round_off);
  EXPECT_EQ(masses(run.state()), mass);
  // All four took part.
  const problem::Totals<2>& t = run.state().ledger.totals;
  for (const Vec<2>& impulse : {t.gravity_impulse, t.contact_impulse, t.support_impulse, t.damping_impulse})
    EXPECT_GT(impulse.norm(), 1e-3 * t.contact_impulse.norm());
  EXPECT_LT(t.contact_impulse[1], 0);  // the pipe pushes the soil down
}

TEST(Momentum, is_kept_by_every_scheme_with_every_detection)
{
  for (const contact::Scheme scheme : {contact::Scheme::musl_coupled, contact::Scheme::musl_double, contact::Scheme::musl_single,
                                       contact::Scheme::hybrid_usl, contact::Scheme::usf, contact::Scheme::tied})
    for (const contact::Detection detection :
         {contact::Detection::particle, contact::Detection::gap, contact::Detection::distance, contact::Detection::overlap}) {
      SCOPED_TRACE(testing::Message() << "scheme " << static_cast<int>(scheme) << ", detection " << static_cast<int>(detection));
      settings::Case c = pipe_in_sand();
      c.contact[0].second.scheme = scheme;
      c.contact[0].second.detection = detection;
      Simulation<2> run(c);
      const auto mass = masses(run.state());
      take_steps(run, 150);
      next_stage(run);
      take_steps(run, 100);
      EXPECT_LT(mpm::momentum_error(run.state()), round_off);
      EXPECT_EQ(masses(run.state()), mass);
      EXPECT_LT(run.state().ledger.totals.contact_impulse[1], 0);
      EXPECT_GE(run.state().ledger.totals.friction, 0);
    }
}

TEST(Momentum, is_what_gravity_floor_and_wall_gave_to_a_collapsing_column)
{
  Simulation<2> run(collapsing_column());
  const auto mass = masses(run.state());
  take_steps(run, 600);
  EXPECT_LT(mpm::momentum_error(run.state()), round_off);
  EXPECT_EQ(masses(run.state()), mass);
  const auto now = mpm::sums_over(run.state().particles[0]);
  EXPECT_GT(now.momentum[0], 0.05 * now.mass);  // it collapses: 0.05 m/s and more on the average
}

TEST(Reaction, is_the_momentum_that_the_soil_got_and_nothing_else_gave)
{
  Simulation<2> run(pipe_in_sand());
  const problem::State<2>& state = run.state();
  Vec<2> reaction = Vec<2>::Zero();
  const auto add_steps = [&](int count) {
    for (int n = 0; n < count; ++n) {
      take_steps(run, 1);
      reaction += state.dt * state.rigid_bodies[0].reaction;
    }
  };
  add_steps(300);
  next_stage(run);
  add_steps(300);
  const problem::Totals<2>& t = state.ledger.totals;
  const Vec<2> of_others = t.gravity_impulse + t.support_impulse + t.damping_impulse;
  const Vec<2> by_pipe = mpm::sums_over(state.particles[0]).momentum - t.first_momentum - of_others;
  EXPECT_NEAR((-reaction - by_pipe).norm() / reaction.norm(), 0, 1e-10);
  EXPECT_NEAR((-reaction - state.ledger.contact_sums[0].impulse).norm() / reaction.norm(), 0, 1e-12);
  EXPECT_GT(reaction[1], 0);
  EXPECT_LT(reaction[0], 0);  // the drag along +x is resisted
}

TEST(SecondCorrection, at_nodes_moves_particles_and_never_changes_their_momentum)
{
  settings::Case c = pipe_in_sand();
  c.contact[0].second.detection = contact::Detection::gap;
  Simulation<2> run(c);
  take_steps(run, 301);
  ASSERT_NE(run.state().step % 16, 0);  // a new time step would look at velocities of the step before
  const auto one_step = [&](contact::Scheme scheme, problem::State<2> state) {
    problem::Model<2> model = run.model();
    model.contacts[0].scheme = scheme;
    mpm::Workspace<2> workspace(model, state);
    step(model, state, workspace);
    return state;
  };
  const problem::State<2> once = one_step(contact::Scheme::musl_single, run.state()),
                          twice = one_step(contact::Scheme::musl_coupled, run.state());
  EXPECT_EQ(once.ledger.contact_sums[0].second_impulse, run.state().ledger.contact_sums[0].second_impulse);
  EXPECT_NE(twice.ledger.contact_sums[0].second_impulse, run.state().ledger.contact_sums[0].second_impulse);
  EXPECT_EQ(once.rigid_bodies[0].reaction, twice.rigid_bodies[0].reaction);
  EXPECT_GT(once.rigid_bodies[0].reaction.norm(), 0);
  const auto a = all_particles(once), b = all_particles(twice);
  Index elsewhere = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    EXPECT_EQ(a[k].v, b[k].v);
    elsewhere += a[k].x != b[k].x;
  }
  EXPECT_GT(elsewhere, 0);
}

/// The same number, bit by bit.
bool same(const bodies::Particle<2>& a, const bodies::Particle<2>& b)
{
  return a.id == b.id && a.x == b.x && a.v == b.v && a.volume == b.volume && a.mass == b.mass &&
         a.deviatoric_strain == b.deviatoric_strain && std::equal(a.stress.c, a.stress.c + 4, b.stress.c) &&
         std::equal(a.extra, a.extra + a.max_extra, b.extra);
}

TEST(Threads, do_not_change_one_bit_of_the_state)
{
  const auto state_with = [](int threads) {
    const int before = omp_get_max_threads();
    omp_set_num_threads(threads);
    Simulation<2> run(pipe_in_sand());
    take_steps(run, 200);
    next_stage(run);
    take_steps(run, 100);
    omp_set_num_threads(before);
    return run.state();
  };
  const problem::State<2> one = state_with(1);
  std::vector<std::int32_t> order;
  one.particles[0].visit([&](Index, Index b, int l) { order.push_back(one.particles[0].block(b).id[l]); });
  for (const int threads : {2, 3}) {
    const problem::State<2> several = state_with(threads);
    const auto a = all_particles(one), b = all_particles(several);
    for (std::size_t k = 0; k < a.size(); ++k) ASSERT_TRUE(same(a[k], b[k])) << "particle " << k << " with " << threads << " threads";
    std::size_t place = 0;
    several.particles[0].visit([&](Index, Index block, int l) {
      EXPECT_EQ(several.particles[0].block(block).id[l], order.at(place++)) << "order of the particles";
    });
    EXPECT_EQ(one.time, several.time);
    EXPECT_EQ(one.rigid_bodies[0].displacement, several.rigid_bodies[0].displacement);
    EXPECT_EQ(one.ledger.contact_sums[0].impulse, several.ledger.contact_sums[0].impulse);
    EXPECT_EQ(one.ledger.contact_sums[0].second_impulse, several.ledger.contact_sums[0].second_impulse);
    EXPECT_EQ(one.ledger.totals.internal, several.ledger.totals.internal);
    EXPECT_EQ(one.ledger.totals.external, several.ledger.totals.external);
    EXPECT_EQ(one.ledger.totals.friction, several.ledger.totals.friction);
    EXPECT_EQ(one.ledger.totals.damping, several.ledger.totals.damping);
    EXPECT_EQ(one.ledger.totals.support_impulse, several.ledger.totals.support_impulse);
  }
}

}  // namespace
}  // namespace berm::this_file
