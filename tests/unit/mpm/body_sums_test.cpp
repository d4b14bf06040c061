// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/body_sums.hpp"

#include "os/error.hpp"
#include "sample_problem.hpp"

#include <gtest/gtest.h>

namespace berm::mpm::this_file {
namespace {

/// Gives each particle v = drift + rate cross (x - center of mass).
template <int dim>
void rotate(bodies::Particles<dim>& particles, const Vec<3>& drift, const Vec<3>& rate)
{
  const Vec<dim> center = sums_over(particles).center();
  for_each_particle(particles, [&](bodies::Block<dim>& p, int l) {
    Vec<3> r = Vec<3>::Zero();
    r.template head<dim>() = position(p, l) - center;
    const Vec<3> v = drift + Vec<3>(rate[1] * r[2] - rate[2] * r[1], rate[2] * r[0] - rate[0] * r[2], rate[0] * r[1] - rate[1] * r[0]);
    set_velocity<dim>(p, l, v.template head<dim>());
  });
}

TEST(Measure, angular_momentum_is_about_the_center_of_mass_and_drift_is_no_part_of_it)
{
  auto problem = problem_on(criss_cross<2>(), sample_solid(), 4);
  bodies::Particles<2>& particles = problem.state.particles[0];
  rotate<2>(particles, {7, -3, 0}, {0, 0, 0.5});
  const Vec<2> center = sums_over(particles).center();
  Real inertia = 0;
  for_each_particle(particles, [&](bodies::Block<2>& p, int l) { inertia += p.mass[l] * (position(p, l) - center).squaredNorm(); });
  EXPECT_NEAR(sums_over(particles).angular_momentum()[2] / (0.5 * inertia), 1, 1e-10);
}
TEST(Measure, angular_momentum_in_space_has_three_components)
{
  auto problem = problem_on(make_box<3>(sample_box<3>()), sample_solid(), 8);
  bodies::Particles<3>& particles = problem.state.particles[0];
  const Vec<3> rate(0.3, -0.2, 0.5);
  rotate<3>(particles, {7, -3, 2}, rate);
  const Vec<3> center = sums_over(particles).center();
  Vec<3> expected = Vec<3>::Zero();
  for_each_particle(particles, [&](bodies::Block<3>& p, int l) {
    const Vec<3> r = position(p, l) - center;
    expected += p.mass[l] * (r.squaredNorm() * rate - r.dot(rate) * r);
  });
  EXPECT_LT((sums_over(particles).angular_momentum() - expected).norm(), 1e-10 * expected.norm());
}

TEST(Measure, extents_are_those_of_the_particles_and_not_of_empty_lanes)
{
  auto problem = problem_on(criss_cross<2>(), sample_solid(), 1);  // one particle a block: three empty lanes
  bodies::Particles<2>& particles = problem.state.particles[0];
  Vec<2> lower = Vec<2>::Constant(infinity), upper = -lower;
  for_each_particle(particles, [&](bodies::Block<2>& p, int l) {
    lower = lower.cwiseMin(position(p, l));
    upper = upper.cwiseMax(position(p, l));
    for (int empty = 1; empty < lanes; ++empty) p.x[0][empty] = p.x[1][empty] = 1e6;
  });
  const auto sums = sums_over(particles);
  EXPECT_EQ(sums.lower, lower);
  EXPECT_EQ(sums.upper, upper);
}

TEST(Measure, the_fastest_cell_is_found_however_small_a_part_of_the_body_it_is)
{
  auto problem = problem_on(criss_cross<2>(), sample_solid(), 4);
  bodies::Particles<2>& particles = problem.state.particles[0];
  rotate<2>(particles, {0, 0, 0}, {0, 0, 0});
  EXPECT_EQ(sums_over(particles).fastest, 0);
  const Index cell = particles.occupied().back();
  particles.visit([&](Index c, Index b, int l) {
    if (c == cell) set_velocity<2>(particles.block(b), l, {0.03, -0.04});
  });
  EXPECT_NEAR(sums_over(particles).fastest, 0.05, 1e-15);
}

TEST(MomentumError, is_told_against_the_motion_where_all_momenta_cancel)
{
  auto problem = problem_on(criss_cross<2>(), sample_solid(), 4);
  rotate<2>(problem.state.particles[0], {0, 0, 0}, {0, 0, 0.5});
  EXPECT_LT(momentum_error(problem.state), 1e-12);
  const BodySums<2> sums = sums_over(problem.state.particles[0]);
  problem.state.ledger.totals.contact_impulse[0] = 1e-3 * std::sqrt(2 * sums.mass * sums.kinetic);
  EXPECT_NEAR(momentum_error(problem.state), 1e-3 / 1.001, 1e-10);
}

TEST(Measure, finds_a_particle_by_its_id_and_refuses_an_id_that_there_is_not)
{
  auto problem = problem_on(criss_cross<2>(), sample_solid(), 4);
  bodies::Particles<2>& particles = problem.state.particles[0];
  for (std::int32_t id : {0, 5, particles.size() - 1}) EXPECT_EQ(particle_of(particles, id).id, id);
  EXPECT_THROW(particle_of(particles, particles.size()), RunError);
}

}  // namespace
}  // namespace berm::mpm::this_file
