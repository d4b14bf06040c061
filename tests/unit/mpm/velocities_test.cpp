// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/velocities.hpp"

#include "random_body.hpp"

namespace berm::mpm::this_file {
namespace {

template <class Dimension>
using Velocities = OfRandomBody<Dimension>;
TYPED_TEST_SUITE(Velocities, Dimensions);

TYPED_TEST(Velocities, new_velocities_are_those_of_particles_that_took_the_nodes_accelerations)
{
  constexpr int dim = TypeParam::value;
  for (const Real place : places) {
    SCOPED_TRACE(place);
    RandomBody<dim> random(place);
    random.to_the_nodes(false);
    std::mt19937 numbers(3);
    for (Index i : random.grid().nodes)
      random.grid().acceleration[i] = random_point<dim>(numbers, Vec<dim>::Constant(-9), Vec<dim>::Constant(9));
    spread_new_momentum(random.mesh(), random.particles(), random.state().dt, random.grid());
    gather_new_velocities(random.problem.model, {}, random.grid());

    NodeField<Vec<dim>> momentum(random.mesh().node_count(), Vec<dim>::Zero());
    random.particles().visit([&](Index cell, Index b, int l) {
      const bodies::Block<dim>& p = random.particles().block(b);
      const auto& nodes = random.mesh().nodes[cell];
      const Vec<dim> x = position(p, l);
      Vec<dim> v = velocity(p, l);
      for (int k = 0; k <= dim; ++k) v += random.state().dt * random.mesh().shape(cell).value(k, x) * random.grid().acceleration[nodes[k]];
      for (int k = 0; k <= dim; ++k) momentum[nodes[k]] += p.mass[l] * random.mesh().shape(cell).value(k, x) * v;
    });
    for (Index i : random.grid().nodes)
      EXPECT_NEAR((random.grid().mapped_velocity[i] - momentum[i] / random.grid().mass[i]).norm(), 0, 1e-12);
  }
}

TYPED_TEST(Velocities, held_directions_have_no_new_velocity)
{
  constexpr int dim = TypeParam::value;
  RandomBody<dim> random;
  for (Index i = 0; i < random.mesh().node_count(); ++i)
    random.problem.model.conditions.tables[0].held[i] = static_cast<std::uint8_t>(i % (1 << dim));
  random.to_the_nodes(true);
  spread_new_momentum(random.mesh(), random.particles(), random.state().dt, random.grid());
  gather_new_velocities(random.problem.model, {}, random.grid());
  for (Index i : random.grid().nodes)
    for (int d = 0; d < dim; ++d) EXPECT_EQ(random.grid().mapped_velocity[i][d] == 0, (i % (1 << dim) >> d & 1) != 0);
}

}  // namespace
}  // namespace berm::mpm::this_file
