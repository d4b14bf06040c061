// SPDX-License-Identifier: BSD-3-Clause
// What tells the contact schemes and detections apart.
#include "pipe_in_sand.hpp"

#include <gtest/gtest.h>

namespace berm::this_file {
namespace {

/// A block of 0.4 m x 0.2 m with 4 particles a square on a plane that leans by `angle` against the mesh; gravity of 10 m/s2 grows within 0.1 s.
settings::Case block_on_incline(contact::Scheme scheme, contact::Detection detection, Real friction_angle)
{
  constexpr Real angle = pi / 6;
  settings::Case c = elastic_box(2, {2, 1.6}, {20, 16}, 1e6, 0.3, 1000);
  c.gravity = {0, -10};
  c.gravity_ramp = 0.1;
  const Vec<2> base(0.6, 1.1), along(std::cos(angle), -std::sin(angle)), up(std::sin(angle), std::cos(angle));
  const Vec<2> center = base + 0.1 * up;
  bodies::BlockSettings block;
  block.center = {center[0], center[1]};
  block.size = {0.4, 0.2};
  block.angle = -angle;
  block.spacing = 0.05;
  c.body[0].second.regions.clear();
  c.body[0].second.block = block;
  bodies::RigidSettings plane;
  plane.shape = bodies::HalfPlaneSettings{{base[0], base[1]}, {up[0], up[1]}};
  c.rigid = {{"plane", plane}};
  contact::ContactSettings contact;
  contact.body = "body";
  contact.rigid = "plane";
  contact.friction_angle = friction_angle;
  contact.scheme = scheme;
  contact.detection = detection;
  c.contact = {{"base", contact}};
  return c;
}

struct Slide {
  Real acceleration, sinking, slip;
};

/// Mean acceleration along the plane from 0.2 s to 0.6 s, how far the block's middle has come nearer to it, and how far it has gone along it in that
/// time. m/s2, m
Slide slide(const settings::Case& c)
{
  const Vec<2> along(std::cos(pi / 6), -0.5), up(0.5, std::cos(pi / 6));
  Simulation<2> run(c);
  const auto first = mpm::sums_over(run.state().particles[0]);
  run.run_until(0.2);
  const Real begin = run.state().time;
  const auto before = mpm::sums_over(run.state().particles[0]);
  run.run_until(0.6);
  const auto after = mpm::sums_over(run.state().particles[0]);
  return {(after.momentum - before.momentum).dot(along) / after.mass / (run.state().time - begin),
          (first.moment - after.moment).dot(up) / after.mass, (after.moment - before.moment).dot(along) / after.mass};
}

TEST(BlockOnIncline, slides_as_coulomb_says_across_the_mesh_with_4_particles_a_square)
{
  const Real friction_angle = std::atan(0.3), exact = 10 * (0.5 - 0.3 * std::cos(pi / 6));
  for (const contact::Scheme scheme :
       {contact::Scheme::musl_coupled, contact::Scheme::musl_double, contact::Scheme::musl_single, contact::Scheme::usf})
    for (const contact::Detection detection : {contact::Detection::particle, contact::Detection::gap}) {
      SCOPED_TRACE(testing::Message() << "scheme " << static_cast<int>(scheme) << ", detection " << static_cast<int>(detection));
      const Slide result = slide(block_on_incline(scheme, detection, friction_angle));
      EXPECT_NEAR(result.acceleration, exact, 0.01 * exact);  // the mean of less than ten swings of the block
      EXPECT_NEAR(result.sinking, 0, 0.005);                  // a tenth of the particles' spacing
    }
}

TEST(BlockOnIncline, stays_where_friction_is_enough_and_where_it_is_stuck)
{
  // 2e-5 of a free slide. The block swings along the plane by some 1e-4 m/s, which says nothing of how it creeps.
  const settings::Case sticks = block_on_incline(contact::Scheme::musl_coupled, contact::Detection::particle, 31 * pi / 180);
  EXPECT_NEAR(slide(sticks).slip, 0, 2e-5 * 0.5 * 5 * 0.4 * 0.4);
  // One velocity field: it stays without any friction.
  EXPECT_NEAR(slide(block_on_incline(contact::Scheme::tied, contact::Detection::overlap, 0)).acceleration, 0, 0.05 * 5);
}

TEST(TwoSidedCorrection, makes_no_energy_in_a_block_that_rests)
{
  const auto kinetic_at_rest = [](contact::Scheme scheme) {
    Simulation<2> run(block_on_incline(scheme, contact::Detection::particle, 40 * pi / 180));
    run.run_until(1);
    return mpm::sums_over(run.state().particles[0]).kinetic;
  };
  const Real coupled = kinetic_at_rest(contact::Scheme::musl_coupled), published = kinetic_at_rest(contact::Scheme::musl_double);
  EXPECT_LT(coupled, 0.1 * published);
}

/// The mean distance at which soil touched the rigid body, by impulse.
Real mean_gap(const Simulation<2>& run)
{
  const contact::ContactSums<2>& sums = run.problem.state.ledger.contact_sums[0];
  return sums.impulse_times_gap / sums.impulse_sum;
}

TEST(Detection, by_overlap_holds_soil_farther_off_than_by_gap_and_by_particle)
{
  const auto gap_of = [](contact::Detection detection) {
    settings::Case c = pipe_in_sand();
    c.contact[0].second.detection = detection;
    Simulation<2> run(c);
    take_steps(run, 400);
    return mean_gap(run);
  };
  const Real overlap = gap_of(contact::Detection::overlap);
  EXPECT_LT(gap_of(contact::Detection::gap), 0.8 * overlap);
  EXPECT_LT(gap_of(contact::Detection::particle), 0.8 * overlap);
}

TEST(ParticleRim, that_wears_lets_soil_that_is_sheared_nearer_to_a_pipe_and_makes_no_energy)
{
  const auto run_with = [](contact::ParticleRim rim) {
    settings::Case c = pipe_in_sand();
    c.contact[0].second.particle_rim = rim;
    Simulation<2> run(c);
    take_steps(run, 300);
    next_stage(run);
    take_steps(run, 900);
    return run;
  };
  Simulation<2> whole = run_with(contact::ParticleRim::whole), worn = run_with(contact::ParticleRim::worn);
  // Nearly all of a rim goes; soil that the pipe has just reached has most of it.
  EXPECT_LT(mean_gap(worn), 0.5 * mean_gap(whole));
  EXPECT_LT(mpm::momentum_error(worn.state()), 1e-12);
  const problem::Totals<2>& t = worn.state().ledger.totals;
  const Real kinetic = mpm::sums_over(worn.state().particles[0]).kinetic;
  EXPECT_LT(std::abs(kinetic + t.internal + t.damping + t.filter + t.friction - t.external), 0.01 * t.external);
}

TEST(UpdateStressFirst, keeps_the_energy_of_a_free_block_that_swings)
{
  // The floor is far away: contact plays no part but to choose the order of the step.
  const auto energy_after = [](contact::Scheme scheme) {
    settings::Case c = block_on_incline(scheme, contact::Detection::gap, 0.3);
    c.gravity.clear();
    bodies::InitialVelocity wave;
    wave.amplitude = {0.5, 0};
    wave.wave_number = {10, 0};
    c.body[0].second.initial_velocity = {wave};
    c.rigid[0].second.shape = bodies::HalfPlaneSettings{{0, 0.1}, {0, 1}};
    Simulation<2> run(c);
    const Real first = mpm::sums_over(run.state().particles[0]).kinetic;
    run.run_until(0.02);
    return (mpm::sums_over(run.state().particles[0]).kinetic + run.state().ledger.totals.internal) / first;
  };
  EXPECT_NEAR(energy_after(contact::Scheme::usf), 1, 0.05);
  EXPECT_NEAR(energy_after(contact::Scheme::musl_double), 1, 0.05);
  EXPECT_NE(energy_after(contact::Scheme::usf), energy_after(contact::Scheme::musl_double));
}

}  // namespace
}  // namespace berm::this_file
