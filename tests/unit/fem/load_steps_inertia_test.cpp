// SPDX-License-Identifier: BSD-3-Clause
// Tests of src/methods/fem/load_steps.cpp: a body that forces alone move, in large deformations.
#include "samples/fem_sample_bed.hpp"
#include "samples/fem_sample_problem.hpp"

#include <gtest/gtest.h>

namespace berm::fem::this_file {
namespace {

constexpr Real D = 0.4, mass = 40, V = 200, H = 150, duration = 0.25, slid = 0.03;

/// A pipe on soft elastic soil, pushed to V, dragged until it slides, and then pulled by H.
settings::Case pulled_pipe(Real friction)
{
  settings::Case c = bed_around(pipe_at(0));
  material::LinearElastic soil;
  soil.density = 1000, soil.young_modulus = 2e4, soil.poisson_ratio = 0.3;
  c.material[0].second = soil;
  c.rigid[0].second.mass = mass;
  c.contact[0].second.friction_angle = std::atan(friction);
  c.fem.large_deformation = true;
  c.fem.contact_size = 0.04;
  settings::StageSettings push = pushing(), slide = dragging(settings::Vertical::hold), pull = resting(duration);
  push.velocity = 0.1;
  push.until.force = V;
  slide.velocity = 0.1;
  slide.until.displacement = slid;
  pull.name = "pull";
  pull.kind = settings::StageKind::drag;
  pull.load_times = {0, duration};
  pull.loads.of("H") = {H, H};
  pull.loads.of("V") = {V, V};
  c.stage = {push, slide, pull};
  return c;
}

/// The pipe at the end.
bodies::RigidState<2> pulled(const settings::Case& c)
{
  const TemporaryFolder folder;
  FemProblem problem = build_fem(c, ".", folder.path().string());
  LoadSteps steps(problem.model, problem.state, Remesher(c, folder.path()));
  steps.find_first_equilibrium();
  do do
      steps.advance();
    while (!stage_ended(problem.model.model, problem.state.state));
  while (steps.next_stage());
  EXPECT_GT(steps.remeshings().count, 5);
  return problem.state.state.rigid_bodies[0];
}

// The dent of an elastic bed goes along with the pipe, and resists by friction alone. Two per cent: elements of D/10 leave a waviness of the reaction, and increments of 6 ms err by (0.6 - 1/2) dt/duration.
TEST(LoadStepsInertia, a_force_beyond_the_resistance_accelerates_the_mass_of_the_body)
{
  for (const Real friction : {0., 0.25}) {
    const bodies::RigidState<2> pipe = pulled(pulled_pipe(friction));
    const Real acceleration = (H - friction * V) / mass;
    EXPECT_NEAR(pipe.displacement[0] - slid, acceleration * duration * duration / 2, 0.02 * acceleration * duration * duration / 2);
    EXPECT_NEAR(pipe.velocity[0], acceleration * duration, 0.02 * acceleration * duration);
    EXPECT_NEAR(-pipe.reaction[0], friction * V, 0.02 * H);
  }
}

// m dv/dt = c (U - v)^2, c by the embedment: x = U t - m/c ln(1 + c U t/m). Two per cent as above.
TEST(LoadStepsInertia, water_takes_the_body_along)
{
  settings::Case c = pulled_pipe(0);
  constexpr Real U = 0.8;
  settings::StageSettings& pull = c.stage.back();
  pull.loads.of("H").clear(), pull.loads.of("V").clear();
  pull.loads.of("water") = {U, U};
  pull.water = settings::WaterSettings{.density = 1000, .drag = 1, .weight = V};
  const bodies::RigidState<2> pipe = pulled(c);
  const Real w = -pipe.displacement[1], left = 1 - 1.4 * w / D, per_mass = left * 1000 * D / 2 / mass;
  const Real way = U * duration - std::log(1 + per_mass * U * duration) / per_mass;
  EXPECT_NEAR(pipe.displacement[0] - slid, way, 0.02 * way);
  EXPECT_NEAR(pipe.velocity[0], U - U / (1 + per_mass * U * duration), 0.02 * U);
}

TEST(LoadStepsInertia, a_body_without_mass_has_nothing_that_stops_it)
{
  settings::Case c = pulled_pipe(0.25);
  c.rigid[0].second.mass = 0;
  EXPECT_THROW(pulled(c), NoEquilibrium);
}

}  // namespace
}  // namespace berm::fem::this_file
