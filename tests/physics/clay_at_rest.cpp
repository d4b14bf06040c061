// SPDX-License-Identifier: BSD-3-Clause
// Clay that shakes below its strength stays as it is, however long.
#include "material/clay.hpp"
#include "simulate.hpp"

#include <gtest/gtest.h>

namespace berm::this_file {
namespace {

constexpr Real density = 1700, strength = 5e3;

/// A bed of 1 m by 1 m between rollers, under its weight.
settings::Case bed_of_clay()
{
  settings::Case c = elastic_box(2, {1, 1}, {3, 3}, 1e6, 0.3, density);
  material::Clay clay;
  clay.density = density;
  clay.rigidity_index = 200;
  clay.poisson_ratio = 0.45;
  clay.undrained_strength = strength;
  clay.sensitivity = 3;
  clay.ductility = 10;
  clay.rate_parameter = 0.1;
  clay.reference_rate = 1e-6;
  c.material = {{"solid", clay}};
  c.gravity = {0, -10};
  c.surface = 1;
  c.body[0].second.particles_per_cell = 4;
  c.body[0].second.k0 = 0.9;  // (s1 - s3)/2 of 0.17 s_u at the base
  c.support = {{"left", {"left", {"x"}}}, {"right", {"right", {"x"}}}, {"bottom", {"bottom", {"x", "y"}}}};
  return c;
}

/// The largest absolute value of a state variable.
Real largest_state(const problem::State<2>& state, int variable)
{
  Real most = 0;
  const bodies::Particles<2>& particles = state.particles[0];
  particles.visit([&](Index, Index b, int l) { most = std::max(most, std::abs(particles.state(b)[variable][l])); });
  return most;
}

/// Sets the bed swinging along x, sin(pi y/2), at a speed (m/s); steps.
void shake(Simulation<2>& run, Real speed, int steps)
{
  run.set_velocities([&](const Vec<2>& x, const Vec<2>& v) { return Vec<2>(speed * std::sin(pi / 2 * x[1]), v[1]); });
  for (int n = 0; n < steps; ++n) step(run.model(), run.state(), run.workspace);
}

TEST(ClayAtRest, shaken_below_its_strength_for_100_000_steps_it_neither_softens_nor_hardens)
{
  Simulation<2> run(bed_of_clay());
  // Shear stress of the mode: G pi/2 v/omega with omega = pi/2 sqrt(G/density): v sqrt(G density) = 0.62 s_u at 75 mm/s.
  shake(run, 0.075, 100000);
  for (int variable = 0; variable < 3; ++variable) EXPECT_EQ(largest_state(run.state(), variable), 0) << variable;
}

TEST(ClayAtRest, shaken_beyond_its_strength_it_softens)
{
  Simulation<2> run(bed_of_clay());
  shake(run, 1, 2000);
  EXPECT_GT(largest_state(run.state(), 0), 0);
}

}  // namespace
}  // namespace berm::this_file
