// SPDX-License-Identifier: BSD-3-Clause
// A rigid block on a Coulomb plane under a horizontal and a vertical force that vary together.
#include "material/mohr_coulomb.hpp"
#include "simulate.hpp"

#include <gtest/gtest.h>

namespace berm::this_file {
namespace {

constexpr Real mass = 50, friction = 0.2, calm = 0.1, end = 0.9;  // kg/m, -, s, s

/// V grows to 500 N/m while nothing else acts; then H swings by 200 N/m with a period of 0.4 s, and V by 30 % with one of 0.6 s: friction carries 100 N/m, less or
/// more, so that the block slides, sticks and slides back.
settings::StageSettings storm()
{
  settings::StageSettings stage;
  stage.name = "storm";
  stage.kind = settings::StageKind::drag;
  for (int k = 0; k <= 450; ++k) {
    const Real t = 0.002 * k, since = std::max(Real(0), t - calm);
    stage.load_times.push_back(t);
    stage.loads.of("H").push_back(200 * std::sin(2 * pi * since / 0.4));
    stage.loads.of("V").push_back(500 * std::min(Real(1), t / calm) * (1 - 0.3 * std::sin(2 * pi * since / 0.6)));
  }
  stage.until.time = end;
  return stage;
}

/// A box of 1.2 m whose flat face lies on a bed of 0.8 m x 0.1 m, so stiff that friction shears it by 0.3 um before the box slides, and too strong to yield: soil that
/// may yield has a bulk viscosity, without which the box would bounce on it and friction with that.
settings::Case block_on_bed()
{
  settings::Case c = elastic_box(2, {1.6, 0.3}, {32, 6}, 1e8, 0.2, 1000);
  bodies::BlockSettings bed;
  bed.center = {0.8, 0.05};
  bed.size = {0.8, 0.1};
  bed.spacing = 0.05 / 3;
  c.body[0].second.regions.clear();
  c.body[0].second.block = bed;
  material::MohrCoulomb law;
  law.density = 1000;
  law.young_modulus = 1e8;
  law.poisson_ratio = 0.2;
  law.cohesion = 1e7;
  c.material[0].second = law;
  c.mpm.bulk_viscosity = 0.9;
  bodies::RigidSettings block;
  block.shape = bodies::BoxSettings{{0.8, 0.2}, {1.2, 0.2}};
  block.mass = mass;
  c.rigid = {{"block", block}};
  contact::ContactSettings contact;
  contact.body = "body";
  contact.rigid = "block";
  contact.friction_angle = std::atan(friction);
  c.contact = {{"base", contact}};
  c.support = {{"base", {"bottom", {"x", "y"}}}};
  c.stage = {storm()};
  return c;
}

/// Displacement of a rigid block on a rigid plane, m: m dv/dt = H - mu V sign(v), at rest where |H| is not more than mu V. In steps so small that they do not count.
struct CoulombBlock {
  settings::StageSettings stage = storm();
  Real time = 0, v = 0, u = 0;

  void run_until(Real until)
  {
    constexpr Real dt = 2e-6;
    const std::size_t H_column = 0, V_column = 1;
    for (; time < until; time += dt) {
      const Real H = settings::load_of_column(stage, H_column, time),
                 resistance = friction * settings::load_of_column(stage, V_column, time);
      const Real driven = v + dt * H / mass, stopped = dt * resistance / mass;
      v = std::abs(driven) <= stopped ? 0 : driven - std::copysign(stopped, driven);
      u += dt * v;
    }
  }
};

TEST(LoadHistory, of_H_and_V_moves_a_block_on_a_plane_as_coulombs_law_has_it)
{
  Simulation<2> run(block_on_bed());
  CoulombBlock exact;
  Real largest = 0, worst = 0;
  for (Real t = calm; t < end; t += 0.01) {
    run.run_until(t);
    exact.run_until(run.state().time);
    largest = std::max(largest, std::abs(exact.u));
    worst = std::max(worst, std::abs(run.state().rigid_bodies[0].displacement[0] - exact.u));
  }
  EXPECT_GT(largest, 0.02) << "it slides";
  EXPECT_LT(worst, 0.01 * largest)
      << "where it turns round the bed shears back and gives it mu V / sqrt(k m) = 0.8 mm/s, k the bed's stiffness";
}

}  // namespace
}  // namespace berm::this_file
