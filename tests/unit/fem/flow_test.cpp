// SPDX-License-Identifier: BSD-3-Clause
#include "fem/flow.hpp"

#include "material/undrained.hpp"
#include "os/error.hpp"
#include "samples/fem_sample_problem.hpp"

#include <gtest/gtest.h>

namespace berm::fem::this_file {
namespace {

material::LinearElastic wet_soil(Real permeability = 1e-6)
{
  material::LinearElastic law = elastic_soil();
  law.water = material::PoreWater{};
  law.water->drainage = material::Drainage::consolidation;
  law.water->porosity = 0.4;
  law.water->permeability = permeability;
  return law;
}

/// c_v, m2/s, of wet_soil, whose water has 30 times the stiffness of its skeleton.
Real consolidation_coefficient(Real permeability)
{
  return permeability * oedometer_modulus / material::unit_weight_of_water / (1 + 1 / material::stiffness_over_skeleton);
}

/// A column of 0.5 m under 10 kPa on a base that is closed.
settings::Case column(const material::Material& soil, Real time)
{
  settings::Case c = block_of(soil, {4, 20});
  c.support[2].second.fixed = {"y"};
  boundary::TractionSettings load;
  load.boundary = "top";
  load.stress = {0, -10e3};
  c.traction = {{"load", load}};
  c.stage = {resting(time)};
  return c;
}

FemProblem run(const settings::Case& c)
{
  FemProblem problem = fem_problem_of(c);
  LoadSteps steps(problem.model, problem.state);
  steps.find_first_equilibrium();
  do {
    while (!stage_ended(problem.model.model, problem.state.state)) steps.advance();
  } while (steps.next_stage());
  return problem;
}

/// Excess pore pressure of the node nearest to x, Pa.
Real pressure_at(const FemProblem& problem, const Vec<2>& x)
{
  Real nearest = infinity, pressure = nan;
  for (Index node = 0; node < problem.model.mesh.node_count(); ++node)
    if (const Index unknown = problem.model.flow.unknown[node]; unknown != none)
      if (const Real away = (problem.model.mesh.position[node] - x).norm(); away < nearest)
        nearest = away, pressure = problem.state.displacement[unknown];
  return pressure;
}

Real settlement(const FemProblem& problem)
{
  Real lowest = 0;
  for (Index node = 0; node < problem.model.mesh.node_count(); ++node) lowest = std::min(lowest, problem.state.displacement[2 * node + 1]);
  return -lowest;
}

/// Terzaghi's series: pressure over the first one at the closed end of a drainage path, at the time factor T.
Real terzaghi_at_base(Real T)
{
  Real sum = 0;
  for (int m = 0; m < 100; ++m) {
    const Real M = pi * (m + 0.5);
    sum += (m % 2 == 0 ? 2 : -2) / M * std::exp(-M * M * T);
  }
  return sum;
}

TEST(Flow, functions_of_the_corners_are_linear_on_a_triangle_with_straight_sides)
{
  const AtSixNodes<Vec<2>> nodes{Vec<2>{1, 1}, Vec<2>{4, 2}, Vec<2>{2, 5}, Vec<2>{2.5, 1.5}, Vec<2>{3, 3.5}, Vec<2>{1.5, 3}};
  const auto field = [](const Vec<2>& x) { return 7 - 2 * x[0] + 3 * x[1]; };
  for (int q = 0; q < triangle_points; ++q) {
    const ShapeAtPoint shape = shape_at(nodes, q);
    const CornerShape corners = corner_shape(shape);
    Vec<2> x = Vec<2>::Zero(), slope = Vec<2>::Zero();
    for (int k = 0; k < 6; ++k) x += shape.value[k] * nodes[k];
    Real value = 0;
    for (int k = 0; k < 3; ++k) {
      value += corners.value[k] * field(nodes[k]);
      slope += field(nodes[k]) * corners.gradient[k];
    }
    EXPECT_NEAR(value, field(x), 1e-13);
    EXPECT_NEAR(slope[0], -2, 1e-13);
    EXPECT_NEAR(slope[1], 3, 1e-13);
  }
}

class WaterOf : public testing::TestWithParam<settings::Geometry> {};

TEST_P(WaterOf, soil_has_a_symmetric_matrix_that_is_the_derivative_of_its_residual)
{
  settings::Case c = plate_on_block(wet_soil(), 1, {2, 1});
  c.geometry = GetParam();
  FemProblem problem = fem_problem_of(c);
  const FemModel& model = problem.model;
  std::vector<Real> change = random_numbers(model.unknowns(), 1e-4);
  for (Index k = model.pressure_unknown(); k < model.unknowns(); ++k) change[k] *= 1e7;
  FemLoads loads;
  loads.dt = 1;
  Assembly assembly(model), moved(model);
  assembly.evaluate(problem.state, change, loads, 0);
  assembly.differentiate(problem.state, change, 0);
  const std::vector<Real> entries = assembly.matrix();
  for (Index column = 0; column < model.unknowns(); ++column) {
    if (assembly.prescribed(column)) continue;
    const Real step = column < model.pressure_unknown() ? 1e-6 : 1;
    std::vector<Real> there = change;
    there[column] += step;
    moved.evaluate(problem.state, there, loads, 0);
    for (Index row = column; row < model.unknowns(); ++row) {
      if (assembly.prescribed(row)) continue;
      const auto begin = model.pattern.column.begin() + model.pattern.first[row],
                 end = model.pattern.column.begin() + model.pattern.first[row + 1];
      const bool stored = std::binary_search(begin, end, column);
      const Real entry = stored ? entries[model.pattern.index_of(row, column)] : 0;
      const Real slope = (moved.soil_residual()[row] - assembly.soil_residual()[row]) / step;
      const Real scale = row < model.pressure_unknown() ? (column < model.pressure_unknown() ? oedometer_modulus : 1) : 1e-6;
      EXPECT_NEAR(entry, slope, 1e-5 * scale) << row << " by " << column;
    }
  }
}
INSTANTIATE_TEST_SUITE_P(Geometry, WaterOf, testing::Values(settings::Geometry::plane_strain, settings::Geometry::axisymmetric));

TEST_P(WaterOf, a_loaded_layer_drains_as_terzaghi_says)
{
  constexpr Real k = 1e-6, T = 0.5;
  settings::Case c = column(wet_soil(k), T * 0.25 / consolidation_coefficient(k));
  c.geometry = GetParam();
  const FemProblem problem = run(c);
  constexpr Real first = 10e3 * material::stiffness_over_skeleton / (1 + material::stiffness_over_skeleton);
  EXPECT_NEAR(pressure_at(problem, {0.5, 0}) / first, terzaghi_at_base(T),
              0.015 * terzaghi_at_base(T));  // increments and long elements: 1 %
  EXPECT_EQ(pressure_at(problem, {0.5, 0.5}), 0);
  const problem::Totals<2>& totals = problem.state.state.ledger.totals;
  EXPECT_NEAR(totals.internal, totals.external, 1e-6 * totals.external);
}

TEST(Flow, leaves_at_a_drained_support_too)
{
  constexpr Real k = 1e-6, T = 0.5;  // over a path of half the height
  settings::Case c = column(wet_soil(k), T * 0.0625 / consolidation_coefficient(k));
  c.support[2].second.drained = true;
  const FemProblem problem = run(c);
  EXPECT_EQ(pressure_at(problem, {0.5, 0}), 0);
  constexpr Real first = 10e3 * material::stiffness_over_skeleton / (1 + material::stiffness_over_skeleton);
  EXPECT_NEAR(pressure_at(problem, {0.5, 0.25}) / first, terzaghi_at_base(T), 0.015 * terzaghi_at_base(T));
}

TEST(Flow, is_drained_soil_where_water_meets_no_resistance_and_undrained_soil_where_it_cannot_flow)
{
  const FemProblem drained = run(column(elastic_soil(), 1)), open = run(column(wet_soil(1), 1));
  EXPECT_NEAR(settlement(open), settlement(drained), 1e-5 * settlement(drained));
  material::LinearElastic soil = wet_soil();
  soil.water->drainage = material::Drainage::undrained;
  soil.water->permeability.reset();
  soil.water->porosity.reset();
  const FemProblem undrained = run(column(soil, 1)), tight = run(column(wet_soil(1e-15), 1));
  const Real pressure = undrained.state.points[0][0].law_state[0];
  EXPECT_NEAR(pressure_at(tight, {0.5, 0}), pressure, 0.01 * pressure);  // the uppermost elements have no pressure at the top
}

TEST(Flow, of_a_permeability_that_follows_the_porosity_slows_as_the_pores_close)
{
  material::LinearElastic soil = wet_soil(1e-6);
  const Real time = 0.2 * 0.25 / consolidation_coefficient(1e-6);
  const FemProblem constant = run(column(soil, time));
  soil.water->kozeny_carman = true;
  EXPECT_GT(pressure_at(run(column(soil, time)), {0.5, 0}), pressure_at(constant, {0.5, 0}) * 1.001);
}

TEST(Flow, does_not_cross_a_rigid_plate)
{
  settings::Case c = plate_on_block(wet_soil(1e-6), 1);
  c.stage = {pushing()};
  c.stage[0].velocity = 1e-3;
  c.stage[0].until.embedment = 1e-4;
  const FemProblem problem = run(c);  // the plate closes the top, and nothing is open
  Real least = infinity;
  for (Index unknown = problem.model.pressure_unknown(); unknown < problem.model.unknowns(); ++unknown)
    least = std::min(least, problem.state.displacement[unknown]);
  EXPECT_NEAR(least, material::stiffness_over_skeleton * oedometer_modulus * 1e-4 / 0.5, 0.02 * least);  // the contact's springs
}

// As a layer under a load; 2 %: increments, long elements, and the springs of the contact.
TEST(Flow, crosses_a_drained_rigid_plate)
{
  constexpr Real k = 1e-6, T = 0.5;
  settings::Case c = plate_on_block(wet_soil(k), 1, {4, 20});
  c.support[2].second.fixed = {"y"};
  c.contact[0].second.drained = true;
  c.stage = {pushing()};
  c.stage[0].velocity.reset();
  c.stage[0].force = 10e3;
  c.stage[0].ramp = 1e-3;
  c.stage[0].until.time = T * 0.25 / consolidation_coefficient(k);
  const FemProblem problem = run(c);
  constexpr Real first = 10e3 * material::stiffness_over_skeleton / (1 + material::stiffness_over_skeleton);
  EXPECT_NEAR(pressure_at(problem, {0.5, 0}) / first, terzaghi_at_base(T), 0.02 * terzaghi_at_base(T));
  EXPECT_EQ(pressure_at(problem, {0.5, 0.5}), 0);
}

TEST(Flow, of_water_that_cavitates_is_refused)
{
  material::LinearElastic soil = wet_soil();
  soil.water->min_pressure = -1e3;
  settings::Case c = column(soil, 1);
  c.traction[0].second.stress = {0, 10e3};
  EXPECT_THROW(run(c), RunError);
}

TEST(Flow, lets_friction_grow_while_water_leaves)
{
  const auto drag_after = [](Real time) {
    settings::Case c = plate_on_block(wet_soil(1e-6), 0.5, {8, 4});
    c.contact[0].second.friction_angle = std::atan(0.3);
    c.stage = {pushing(), dragging(settings::Vertical::hold)};
    c.stage[0].velocity.reset();
    c.stage[0].force = 1e3;
    c.stage[0].ramp = 1e-3;
    c.stage[0].until.time = time;
    c.stage[1].until.displacement = 0.01;
    const FemProblem problem = run(c);
    const Vec<2>& reaction = problem.state.state.rigid_bodies[0].reaction;
    EXPECT_NEAR(reaction[1], 1e3, 1);
    return std::abs(reaction[0]) / reaction[1];
  };
  constexpr Real drained = 0.3, days = 1e5;
  EXPECT_LT(drag_after(1e-2), 0.5 * drained);
  EXPECT_GT(drag_after(days), 0.85 * drained);  // the drag itself is too fast for the water
  EXPECT_LE(drag_after(days), 1.001 * drained);
}

}  // namespace
}  // namespace berm::fem::this_file
