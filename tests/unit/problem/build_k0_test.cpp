// SPDX-License-Identifier: BSD-3-Clause
// K0 that follows from the stress history, at the particles: (1 - sin phi) OCR^(sin phi), at most Kp (Mayne and Kulhawy 1982).
#include "samples/sample_case.hpp"

#include "material/mohr_coulomb.hpp"

#include <gtest/gtest.h>

namespace berm::problem::this_file {
namespace {

constexpr Real weight = 10e3, sine = 0.5, sine_below = 0.4;  // N/m3; of 30 and 23.58 degrees

material::MohrCoulomb sand(Real sin_friction)
{
  material::MohrCoulomb law;
  law.density = weight / 10;
  law.young_modulus = 20e6;
  law.poisson_ratio = 0.3;
  law.friction_angle = std::asin(sin_friction);
  return law;
}

/// A bed of 1 m of sand, its lower half of another one.
settings::Case bed_of_sand()
{
  settings::Case c = pipe_over_box({stage_of(settings::StageKind::free)});
  c.gravity = {0, -10};
  c.material = {{"solid", sand(sine)}, {"below", sand(sine_below)}};
  bodies::BlockSettings block;
  block.center = {1, 0.5};
  block.size = {2, 1};
  block.spacing = 0.1;
  bodies::BodySettings& body = c.body[0].second;
  body.regions.clear();
  body.block = block;
  body.sin_friction = sine;
  bodies::SoilLayerSettings layer;
  layer.top = 0.5;
  layer.material = "below";
  layer.sin_friction = sine_below;
  body.soil_layer = {layer};
  c.support = {{"base", {"bottom", {"x", "y"}}}, {"left", {"left", {"x"}}}, {"right", {"right", {"x"}}}};
  c.surface = 1;
  return c;
}

/// The largest difference of K0 at a particle from exact(depth, vertical stress).
template <class Exact>
Real error_of(const settings::Case& c, const Exact& exact)
{
  const Problem<2> problem = build<2>(c, ".", ".");
  Real error = 0;
  int count = 0;
  problem.state.particles[0].visit([&](Index, Index b, int l) {
    const bodies::Particle<2> p = problem.state.particles[0].read(b, l);
    const Real depth = 1 - p.x[1];
    EXPECT_NEAR(p.stress[1], -weight * depth, 1e-9 * weight);
    EXPECT_EQ(p.stress[0], p.stress[2]);
    error = std::max(error, std::abs(p.stress[0] / p.stress[1] - exact(depth, weight * depth)));
    ++count;
  });
  EXPECT_EQ(count, 200);
  return error;
}

TEST(K0, follows_from_one_overconsolidation_ratio_and_the_friction_of_each_layer)
{
  settings::Case c = bed_of_sand();
  c.body[0].second.k0_ocr = 4;
  const Real above = 0.5 * 2, below = 0.6 * std::pow(4, 0.4);  // 1 and 1.045
  EXPECT_LT(error_of(c, [&](Real depth, Real) { return depth < 0.5 ? above : below; }), 1e-12);
}

TEST(K0, of_a_layer_is_its_own)
{
  settings::Case c = bed_of_sand();
  c.body[0].second.k0 = 0.7;
  c.body[0].second.soil_layer[0].k0_ocr = 1;
  EXPECT_LT(error_of(c, [&](Real depth, Real) { return depth < 0.5 ? 0.7 : 1 - sine_below; }), 1e-12);
}

TEST(K0, falls_with_depth_under_a_pre_overburden_pressure_and_is_Kp_at_most)
{
  constexpr Real pop = 20e3;
  settings::Case c = bed_of_sand();
  c.body[0].second.soil_layer.clear();
  c.body[0].second.k0_pop = pop;
  const auto exact = [&](Real, Real vertical) { return std::min(3., 0.5 * std::sqrt((vertical + pop) / vertical)); };
  EXPECT_EQ(exact(0, weight * 0.05), 3) << "the limit is reached in the uppermost rows";
  EXPECT_LT(exact(0, weight * 0.95), 1);
  EXPECT_LT(error_of(c, exact), 1e-12);
}

// On ground that is not level the elastic equilibrium has the K0 of its depth below a level surface.
TEST(K0, by_gravity_loading_is_that_of_its_cells)
{
  settings::Case c = bed_of_sand();
  c.body[0].second.k0_ocr = 1;
  c.body[0].second.soil_layer.clear();
  c.initial_state = settings::InitialState::gravity_loading;
  Problem<2> problem = build<2>(c, ".", ".");
  Real sum = 0, count = 0;
  problem.state.particles[0].visit([&](Index, Index b, int l) {
    const bodies::Particle<2> p = problem.state.particles[0].read(b, l);
    if (std::abs(p.x[0] - 1) < 0.3 && p.x[1] < 0.5) sum += p.stress[0] / p.stress[1], count += 1;
  });
  EXPECT_NEAR(sum / count, 0.5, 0.02);
}

}  // namespace
}  // namespace berm::problem::this_file
