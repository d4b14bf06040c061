// SPDX-License-Identifier: BSD-3-Clause
// Soil between rollers that is released on one side: from zero strain along x to zero stress along x.
#include "simulate.hpp"

#include <gtest/gtest.h>

namespace berm::this_file {
namespace {

constexpr Real young_modulus = 1e6, poisson_ratio = 0.3, height = 0.5, length = 1, pressure = 1e3;

/// A weightless block under pressure on its top; the right roller holds in the first stage only.
settings::Case released_block()
{
  settings::Case c = elastic_box(2, {length, height}, {8, 4}, young_modulus, poisson_ratio, 1000);
  c.body[0].second.damping = 0.3;
  c.support = {{"base", {"bottom", {"y"}}}, {"left", {"left", {"x"}}}, {"right", {"right", {"x"}, {"held"}}}};
  c.stage.push_back(c.stage[0]);
  c.stage[0].name = "held";
  c.stage[1].name = "released";
  boundary::TractionSettings load;
  load.boundary = "top";
  load.pressure = pressure;
  load.ramp = 0.1;
  c.traction = {{"load", load}};
  return c;
}

struct Means {
  SymTensor<2> stress;
  Vec<2> top;  ///< mean displacement of the loaded surface
};
Means means_of(const Simulation<2>& run, const std::vector<problem::LoadPointState<2>>& first)
{
  Means means{{}, Vec<2>::Zero()};
  Real volume = 0;
  const bodies::Particles<2>& particles = run.problem.state.particles[0];
  particles.visit([&](Index, Index b, int l) {
    const bodies::Block<2>& p = particles.block(b);
    for (int k = 0; k < 4; ++k) means.stress[k] += p.volume[l] * p.stress[k][l];
    volume += p.volume[l];
  });
  for (int k = 0; k < 4; ++k) means.stress[k] /= volume;
  const auto& now = run.problem.state.load_points;
  for (std::size_t l = 0; l < now.size(); ++l) means.top += (now[l].x - first[l].x) / static_cast<Real>(now.size());
  return means;
}

// Strains are 1e-3, which changes of length and of area make relative errors of the same size of.
constexpr Real small_strain = 4e-3;

TEST(ReleasedSupport, takes_the_stress_along_x_away_and_lets_the_soil_settle_as_in_uniaxial_plane_strain)
{
  Simulation<2> run(released_block());
  const auto first = run.state().load_points;
  run.run_until(1);
  const Real k0 = poisson_ratio / (1 - poisson_ratio),
             modulus = young_modulus * (1 - poisson_ratio) / ((1 + poisson_ratio) * (1 - 2 * poisson_ratio));
  const Means held = means_of(run, first);
  EXPECT_NEAR(held.stress[1], -pressure, small_strain * pressure);
  EXPECT_NEAR(held.stress[0], -k0 * pressure, small_strain * pressure);
  EXPECT_NEAR(held.top[1], -height * pressure / modulus, small_strain * height * pressure / modulus);

  run.state().stage.index = 1;
  begin_stage(run.model(), run.state());
  run.run_until(3);
  const Means released = means_of(run, first);
  EXPECT_NEAR(released.stress[1], -pressure, small_strain * pressure);
  EXPECT_NEAR(released.stress[0], 0, small_strain * pressure);
  EXPECT_NEAR(released.stress[2], -poisson_ratio * pressure, small_strain * pressure);
  const Real plane_modulus = young_modulus / (1 - poisson_ratio * poisson_ratio);  // sigma_yy over e_yy where sigma_xx = 0 and e_zz = 0
  EXPECT_NEAR(released.top[1], -height * pressure / plane_modulus, small_strain * height * pressure / plane_modulus);

  // All work is stored or damped.
  const problem::Totals<2>& t = run.state().ledger.totals;
  EXPECT_NEAR((t.internal + t.damping + t.filter + mpm::sums_over(run.state().particles[0]).kinetic) / t.external, 1, 0.01);
  EXPECT_LT(mpm::momentum_error(run.state()), 1e-12);
}

}  // namespace
}  // namespace berm::this_file
