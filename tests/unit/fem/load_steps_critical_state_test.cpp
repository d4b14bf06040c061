// SPDX-License-Identifier: BSD-3-Clause
#include "fem/load_steps.hpp"
#include "samples/critical_state_soils.hpp"
#include "samples/fem_sample_problem.hpp"

#include <gtest/gtest.h>

namespace berm::fem::this_file {
namespace {

/// A block of soil of 1 m x 1 m without weight between smooth sides and on a smooth base, under K0 and 10 kPa on its top, which grow by 30 kPa within 1 s.
settings::Case oedometer(const material::Material& soil, Real k0)
{
  settings::Case c;
  mesh::BoxMesh mesh;
  mesh.size = {1, 1};
  mesh.cells = {2, 2};
  c.mesh = mesh;
  c.method = settings::Method::fem;
  c.material = {{"soil", soil}};
  bodies::BodySettings body;
  body.material = "soil";
  body.regions = {"box"};
  body.initial_stress = {-k0 * 1e4, -1e4, -k0 * 1e4};
  c.body = {{"soil", body}};
  boundary::TractionSettings seating, load;
  seating.boundary = load.boundary = "top";
  seating.stress = {0, -1e4};
  load.stress = {0, -3e4};
  load.ramp = 1;
  c.traction = {{"seating", seating}, {"load", load}};
  c.support = {{"bottom", {"bottom", {"y"}}}, {"left", {"left", {"x"}}}, {"right", {"right", {"x"}}}};
  settings::StageSettings stage;
  stage.name = "compression";
  stage.kind = settings::StageKind::free;
  stage.until.time = 1.1;
  c.stage = {stage};
  return c;
}

/// Stress of the middle and settlement of the top at the end.
struct End {
  SymTensor<2> stress;
  Real settlement;
};

End end_of(const settings::Case& c)
{
  FemProblem problem = fem_problem_of(c);
  LoadSteps steps(problem.model, problem.state);
  steps.find_first_equilibrium();
  do steps.advance();
  while (!stage_ended(problem.model.model, problem.state.state));
  End end{problem.state.points[0][0].stress, 0};
  for (Index node = 0; node < problem.model.mesh.position.size(); ++node)
    end.settlement = std::max(end.settlement, -problem.state.displacement[2 * node + 1]);
  return end;
}

// Uniform strain is exact in quadratic elements, and the law is exact at the end of an increment of any size; the iteration ends within a thousandth.
constexpr Real accuracy = 1e-3;

TEST(LoadStepsCriticalState, cam_clay_settles_along_the_virgin_line_under_its_own_k0)
{
  material::ModifiedCamClay clay = sample_cam_clay();
  clay.max_pressure = 1e5;
  const Real k0 = virgin_k0(clay);
  const End end = end_of(oedometer(clay, k0));
  EXPECT_NEAR(end.stress[1], -4e4, accuracy * 4e4);
  EXPECT_NEAR(end.stress[0], -k0 * 4e4, accuracy * 4e4);
  EXPECT_NEAR(end.settlement, 0.1 * std::log(4), accuracy * 0.1 * std::log(4));
}

TEST(LoadStepsCriticalState, overconsolidated_cam_clay_settles_along_the_swelling_line)
{
  material::ModifiedCamClay clay = sample_cam_clay();
  clay.max_pressure = 1e5;
  clay.overconsolidation_ratio = 10;
  const Real k0 = 0.3 / 0.7;
  const End end = end_of(oedometer(clay, k0));
  EXPECT_NEAR(end.stress[0], -k0 * 4e4, accuracy * 4e4);
  EXPECT_NEAR(end.settlement, 0.02 * std::log(4), accuracy * 0.02 * std::log(4));
}

TEST(LoadStepsCriticalState, points_of_norsand_get_the_state_of_soil_at_rest)
{
  const FemProblem problem = fem_problem_of(oedometer(sample_norsand(), 0.5));
  Real expected[2] = {};
  initial_state(sample_norsand(), {{-5e3, -1e4, -5e3}}, expected);
  for (Index cell = 0; cell < problem.model.mesh.cell_count(); ++cell)
    for (int q = 0; q < triangle_points; ++q)
      for (int k = 0; k < 2; ++k) ASSERT_EQ(problem.state.points[cell][q].law_state[k], expected[k]);
}

}  // namespace
}  // namespace berm::fem::this_file
