// SPDX-License-Identifier: BSD-3-Clause
// Contact of many points gives the same bits on any number of threads.
#include "contact/strips.hpp"
#include "simulate.hpp"

#include <cstring>
#include <gtest/gtest.h>
#include <omp.h>

namespace berm::this_file {
namespace {

/// A soft block that drops onto a plane that leans, with friction and adhesion; in space it is 0.8 m wide.
settings::Case dropped_block(int dim, contact::Scheme scheme)
{
  settings::Case c =
      dim == 2 ? elastic_box(2, {5, 1}, {100, 20}, 1e5, 0.3, 1000) : elastic_box(3, {1.6, 1, 1.2}, {16, 10, 12}, 1e5, 0.3, 1000);
  c.gravity = {1, -10, 0};
  c.gravity.resize(dim);
  bodies::BlockSettings block;
  block.center = dim == 2 ? std::vector<Real>{2.5, 0.5} : std::vector<Real>{0.8, 0.5, 0.6};
  block.size = dim == 2 ? std::vector<Real>{4, 0.2} : std::vector<Real>{1, 0.2, 0.8};
  block.spacing = dim == 2 ? 0.02 : 0.04;
  c.body[0].second.regions.clear();
  c.body[0].second.block = block;
  bodies::RigidSettings plane;
  std::vector<Real> point = block.center, up = {-0.02, 1, 0};
  point[1] = 0.4;
  point.resize(dim), up.resize(dim);
  plane.shape = bodies::HalfPlaneSettings{point, up};
  c.rigid = {{"plane", plane}};
  contact::ContactSettings contact;
  contact.body = "body";
  contact.rigid = "plane";
  contact.friction_angle = 0.4;
  contact.adhesion = 100;
  contact.scheme = scheme;
  contact.detection = contact::Detection::particle;
  c.contact = {{"base", contact}};
  return c;
}

struct Outcome {
  std::vector<Real> numbers;
  std::size_t most_points = 0;
};

/// Positions and velocities of all particles, the reaction and the totals after 60 steps on so many threads.
template <int dim>
Outcome outcome(const settings::Case& c, int threads)
{
  const int before = omp_get_max_threads();
  omp_set_num_threads(threads);
  Simulation<dim> run(c);
  Outcome result;
  for (int k = 0; k < 60; ++k) {
    step(run.model(), run.state(), run.workspace);
    result.most_points = std::max(result.most_points, run.workspace.contact_points[0].list.size());
  }
  omp_set_num_threads(before);
  const bodies::Particles<dim>& particles = run.state().particles[0];
  particles.visit([&](Index, Index b, int l) {
    const bodies::Particle<dim> p = particles.read(b, l);
    result.numbers.insert(result.numbers.end(), p.x.begin(), p.x.end());
    result.numbers.insert(result.numbers.end(), p.v.begin(), p.v.end());
    result.numbers.insert(result.numbers.end(), p.extra, p.extra + particles.extra_size());
  });
  for (const bodies::RigidState<dim>& rigid : run.state().rigid_bodies)
    result.numbers.insert(result.numbers.end(), rigid.reaction.begin(), rigid.reaction.end());
  for (const contact::ContactSums<dim>& sums : run.state().ledger.contact_sums) {
    result.numbers.insert(result.numbers.end(), sums.impulse.begin(), sums.impulse.end());
    result.numbers.push_back(sums.impulse_times_gap);
  }
  for (const Vec<dim>& impulse : run.state().ledger.pair_impulses)
    result.numbers.insert(result.numbers.end(), impulse.begin(), impulse.end());
  result.numbers.push_back(run.state().ledger.totals.friction);
  result.numbers.push_back(run.state().ledger.totals.external);
  return result;
}

template <int dim>
void expect_same_bits(const settings::Case& c)
{
  const Outcome alone = outcome<dim>(c, 1);
  ASSERT_GE(alone.most_points, static_cast<std::size_t>(contact::min_points_for_threads)) << "the threads have nothing to share";
  for (const int threads : {2, 3}) {
    const Outcome shared = outcome<dim>(c, threads);
    ASSERT_EQ(shared.numbers.size(), alone.numbers.size());
    EXPECT_EQ(std::memcmp(shared.numbers.data(), alone.numbers.data(), alone.numbers.size() * sizeof(Real)), 0) << threads << " threads";
  }
}

TEST(ContactOnThreads, has_the_same_bits_with_every_scheme)
{
  for (const contact::Scheme scheme :
       {contact::Scheme::musl_coupled, contact::Scheme::musl_double, contact::Scheme::hybrid_usl, contact::Scheme::usf}) {
    SCOPED_TRACE(static_cast<int>(scheme));
    expect_same_bits<2>(dropped_block(2, scheme));
  }
}
TEST(ContactOnThreads, has_the_same_bits_in_space)
{
  expect_same_bits<3>(dropped_block(3, contact::Scheme::musl_coupled));
}
TEST(ContactOnThreads, has_the_same_bits_where_nodes_are_the_points)
{
  settings::Case c = dropped_block(2, contact::Scheme::musl_double);
  c.contact[0].second.detection = contact::Detection::gap;
  expect_same_bits<2>(c);
}
TEST(ContactOnThreads, has_the_same_bits_where_particles_remember)
{
  settings::Case c = dropped_block(2, contact::Scheme::musl_coupled);
  c.contact[0].second.tension = 50;
  c.contact[0].second.adhesion_sensitivity = 4;
  c.contact[0].second.adhesion_ductility = 1e-3;
  expect_same_bits<2>(c);
}
TEST(ContactOnThreads, has_the_same_bits_between_two_bodies_beside_a_rigid_one)
{
  settings::Case c = dropped_block(2, contact::Scheme::musl_coupled);
  auto above = c.body[0];
  above.first = "above";
  above.second.block->center[1] += 0.2;
  c.body.push_back(above);
  contact::ContactSettings contact;
  contact.body = "above";
  contact.other_body = "body";
  contact.friction_angle = 0.3;
  c.contact.insert(c.contact.begin(), {"between", contact});
  expect_same_bits<2>(c);
}

}  // namespace
}  // namespace berm::this_file
