// SPDX-License-Identifier: BSD-3-Clause
#include "fem/assembly.hpp"

#include "material/hardening_soil.hpp"
#include "material/mohr_coulomb.hpp"
#include "samples/critical_state_soils.hpp"
#include "samples/fem_sample_bed.hpp"
#include "samples/fem_sample_problem.hpp"

#include <functional>
#include <gtest/gtest.h>
#include <set>

namespace berm::fem::this_file {
namespace {

/// One state of soil at which the matrix is looked at: it moves by `strain` (xx, yy, xy) and a little at random. No soil is at the border of yield.
struct Tried {
  std::string name;
  material::Material soil = elastic_soil();
  Real viscosity = 0;
  Vec<3> strain{0, 0, 0};
  SymTensor<2> first_stress = {};
  bool by_force = false, stiff = true, around_axis = false;
};

void PrintTo(const Tried& tried, std::ostream* out)
{
  *out << tried.name;
}

class MatrixOf : public testing::TestWithParam<Tried> {
protected:
  MatrixOf()
  {
    settings::Case c = plate_on_block(GetParam().soil, 1, {2, 1});
    if (GetParam().around_axis) c.geometry = settings::Geometry::axisymmetric;
    problem = fem_problem_of(c);
    loads.gravity = {0, -10};
    for (FemLoads::Direction& direction : loads.rigid) direction.by_force = GetParam().by_force;
    for (auto& points : problem.state.points)
      for (SoilPoint& point : points) point.stress = GetParam().first_stress;
    const Vec<3>& e = GetParam().strain;
    change = change_of(problem.model, [&](const Vec<2>& x) { return Vec<2>(e[0] * x[0] + e[2] * x[1], e[1] * x[1] + e[2] * x[0]); });
    const auto noise = random_numbers(problem.model.unknowns(), 2e-5);
    for (std::size_t k = 0; k < change.size(); ++k) change[k] += noise[k];
  }

  std::vector<Real> residual_at(Index unknown, Real step)
  {
    Assembly assembly(problem.model);
    std::vector<Real> moved = change;
    moved[unknown] += step;
    assembly.evaluate(problem.state, moved, loads, GetParam().viscosity);
    return assembly.soil_residual();
  }

  FemProblem problem;
  FemLoads loads;
  std::vector<Real> change;
};

TEST_P(MatrixOf, is_the_derivative_of_the_soils_residual_and_the_identity_where_given)
{
  const FemModel& model = problem.model;
  const Index n = model.unknowns();
  Assembly assembly(model);
  assembly.evaluate(problem.state, change, loads, GetParam().viscosity);
  assembly.differentiate(problem.state, change, GetParam().viscosity);
  const std::vector<Real> entries = assembly.matrix();
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
  for (Index row = 0; row < n; ++row)
    for (Index k = model.pattern.first[row]; k < model.pattern.first[row + 1]; ++k)
      if (const Index column = model.pattern.column[k]; column == row)
        matrix(row, row) = entries[k];
      else
        matrix(row, column) = entries[k], matrix(column, row) = entries[model.unsymmetric ? model.pattern.entry_count() + k : k];
  // The matrix keeps a millionth of the elastic stiffness (entries up to some 5e6 N/m2 where the modulus is that of elastic_soil) of which the residual knows
  // nothing. Central differences are off by rounding of 1e-11 N/m over the step, 1e-3, and by the square of the step over the strain increments.
  constexpr Real step = 1e-8;
  const Real allowed = 20 * p_wave_modulus(elasticity(GetParam().soil)) / oedometer_modulus;
  Real largest = 0;
  for (Index column = 0; column < n; ++column) {
    const auto after = residual_at(column, step), before = residual_at(column, -step);
    for (Index row = 0; row < n; ++row) {
      const Real slope = assembly.prescribed(row) || assembly.prescribed(column) ? row == column : (after[row] - before[row]) / (2 * step);
      EXPECT_NEAR(matrix(row, column), slope, allowed) << row << ", " << column;
      largest = std::max(largest, std::abs(slope));
    }
  }
  EXPECT_EQ(largest > 1e5, GetParam().stiff);  // there is something to compare
  EXPECT_EQ(assembly.prescribed(model.rigid_unknown()), !GetParam().by_force);
}

const SymTensor<2> pressed{{-2e4, -4e4, -2e4, 0}};

material::HardeningSoil hardening_soil()
{
  material::HardeningSoil law;
  law.density = 1000;
  law.friction_angle = 36 * pi / 180;
  law.dilation_angle = 4 * pi / 180;
  law.secant_modulus = law.oedometer_modulus = 2.5e7;
  law.unloading_modulus = 7.5e7;
  law.stiffness_exponent = 0.5;
  law.poisson_ratio = 0.2;
  law.max_pressure = 4e5;
  return law;
}

/// Soil whose matrix is unsymmetric; it shears.
Tried sheared(const char* name, const material::Material& soil, bool around_axis = false)
{
  return {.name = name, .soil = soil, .strain = {4e-4, -1e-3, 3e-4}, .first_stress = pressed, .around_axis = around_axis};
}

INSTANTIATE_TEST_SUITE_P(
    At, MatrixOf,
    testing::Values(
        Tried{.name = "elastic_soil"}, Tried{.name = "free_rigid_directions", .by_force = true},
        Tried{.name = "associated_flow", .soil = plastic_soil(1e3, 30, 30), .strain = {5e-2, -1e-1, 3e-2}},
        Tried{.name = "undrained_flow", .soil = plastic_soil(1e3, 0, 0), .strain = {5e-2, -1e-1, 3e-2}},
        Tried{.name = "stand_in_for_flow_without_dilation",
              .soil = plastic_soil(0, 35, 0),
              .strain = {5e-2, -6e-2, 3e-2},
              .first_stress = pressed},
        Tried{.name = "stand_in_with_viscosity",
              .soil = plastic_soil(0, 35, 10),
              .viscosity = 0.1,
              .strain = {5e-2, -6e-2, 3e-2},
              .first_stress = pressed},
        Tried{.name = "soil_that_comes_apart", .soil = plastic_soil(0, 35, 0), .strain = {0.1, 0.1, 0}, .stiff = false},
        sheared("hypoplastic_sand", sample_hypoplastic()), sheared("hardening_soil", hardening_soil()),
        sheared("hypoplastic_sand_around_an_axis", sample_hypoplastic(), true),
        sheared("hardening_soil_around_an_axis", hardening_soil(), true), Tried{.name = "elastic_soil_around_an_axis", .around_axis = true},
        Tried{.name = "associated_flow_around_an_axis",
              .soil = plastic_soil(1e3, 30, 30),
              .strain = {5e-2, -1e-1, 3e-2},
              .around_axis = true},
        Tried{.name = "undrained_flow_around_an_axis", .soil = plastic_soil(1e3, 0, 0), .strain = {5e-2, -1e-1, 3e-2}, .around_axis = true},
        Tried{.name = "viscosity_around_an_axis",
              .soil = plastic_soil(0, 35, 10),
              .viscosity = 0.1,
              .strain = {5e-2, -6e-2, 3e-2},
              .first_stress = pressed,
              .around_axis = true}),
    [](const auto& row) { return row.param.name; });

TEST(Assembly, linear_displacement_makes_constant_stress_and_balance_inside)
{
  // Triangles of every shape around a circle, whose sides are curved.
  settings::Case c = bed_around(pipe_at(0.3));
  c.stage = {resting(1)};
  FemProblem problem = fem_problem_of(c);
  const FemModel& model = problem.model;
  const Real e[2][2] = {{1e-3, -4e-4}, {7e-4, -2e-3}};
  const auto change = change_of(
      model, [&](const Vec<2>& x) { return Vec<2>(0.01 + e[0][0] * x[0] + e[0][1] * x[1], -0.02 + e[1][0] * x[0] + e[1][1] * x[1]); });
  Assembly assembly(model);
  assembly.evaluate(problem.state, change, {}, 0);
  std::set<Index> outside;
  for (const BoundarySide& side : model.mesh.boundary_sides) outside.insert({side.from, side.to, side.middle});
  ASSERT_LT(static_cast<Index>(outside.size()), model.mesh.node_count() / 2);
  // Forces of single elements are stress times size, at most 2e3 Pa x 0.2 m.
  for (Index node = 0; node < model.mesh.node_count(); ++node) {
    if (outside.contains(node)) continue;
    for (int d = 0; d < 2; ++d) EXPECT_NEAR(assembly.residual()[2 * node + d], 0, 1e-10 * 400);
  }

  assembly.accept(problem.state, change, {});
  const material::Elasticity elastic = elasticity(model.model.bodies[0].soil.materials.front());
  const Real volume = e[0][0] + e[1][1];
  const SymTensor<2> stress{{elastic.lame * volume + 2 * elastic.shear * e[0][0], elastic.lame * volume + 2 * elastic.shear * e[1][1],
                             elastic.lame * volume, elastic.shear * (e[0][1] + e[1][0])}};
  for (const auto& points : problem.state.points)
    for (const SoilPoint& point : points)
      for (int k = 0; k < 4; ++k) EXPECT_NEAR(point.stress[k], stress[k], 1e-10 * 2e3);
  // The work of the stresses is half of stress times strain, over the area of the mesh.
  const SymTensor<2> strain{{e[0][0], e[1][1], 0, (e[0][1] + e[1][0]) / 2}};
  EXPECT_NEAR(problem.state.state.ledger.totals.internal / (area_of(model.mesh) * double_dot(stress, strain) / 2), 1, 1e-12);
}

// u_r = c r, u_y = d y has the strains c, d, c: a uniform stress, which leaves no force at nodes within the soil (three points of integration are exact).
TEST(Assembly, displacement_in_proportion_to_the_radius_makes_uniform_stress_and_balance_inside)
{
  settings::Case c = block_of(elastic_soil(), {4, 4});
  c.geometry = settings::Geometry::axisymmetric;
  FemProblem problem = fem_problem_of(c);
  const FemModel& model = problem.model;
  const auto change = change_of(model, [](const Vec<2>& x) { return Vec<2>(3e-3 * x[0], -1e-3 * x[1]); });
  Assembly assembly(model);
  assembly.evaluate(problem.state, change, {}, 0);
  FemState end = problem.state;
  assembly.accept(end, change, {});
  const SymTensor<2>& first = end.points[0][0].stress;
  EXPECT_NEAR(first[0], first[2], 1e-9 * std::abs(first[0]));
  Real outside = 0;
  for (Index cell = 0; cell < model.mesh.cell_count(); ++cell)
    for (int q = 0; q < triangle_points; ++q)
      for (int k = 0; k < 4; ++k) EXPECT_NEAR(end.points[cell][q].stress[k], first[k], 1e-9 * std::abs(first[0]));
  int inner = 0;
  for (Index node = 0; node < model.mesh.position.size(); ++node) {
    const Vec<2>& x = model.mesh.position[node];
    const Vec<2> force(assembly.residual()[2 * node], assembly.residual()[2 * node + 1]);
    outside = std::max(outside, force.norm());
    if (x[0] < 1e-9 || x[0] > model.model.mesh.upper[0] - 1e-9 || x[1] < model.model.mesh.lower[1] + 1e-9 ||
        x[1] > model.model.mesh.upper[1] - 1e-9)
      continue;
    EXPECT_NEAR(force.norm(), 0, 1e-9 * std::abs(first[0])) << x.transpose();
    ++inner;
  }
  EXPECT_GT(inner, 20);
  EXPECT_GT(outside, 1e-3 * std::abs(first[0]));
}

TEST(Assembly, a_bed_with_k0_stresses_is_in_balance_but_for_the_hole)
{
  settings::Case c = bed_around(pipe_at(0.3));
  c.stage = {resting(1)};
  c.gravity = {0, -10};
  c.body[0].second.k0 = 0.5;
  const FemProblem problem = fem_problem_of(c);
  const FemModel& model = problem.model;
  Assembly assembly(model);
  FemLoads loads;
  loads.gravity = {0, -10};
  assembly.evaluate(problem.state, std::vector<Real>(model.unknowns(), 0.), loads, 0);
  // Elements that touch the circle are curved: three points do not integrate their weight exactly, and nothing holds the circle.
  std::set<Index> at_circle;
  for (const FemContactPoint& point : model.contact) at_circle.insert(point.node);
  std::set<Index> near_circle;
  for (const auto& nodes : model.mesh.nodes)
    if (std::any_of(nodes.begin(), nodes.end(), [&](Index node) { return at_circle.contains(node); }))
      near_circle.insert(nodes.begin(), nodes.end());
  int compared = 0;
  for (Index node = 0; node < model.mesh.node_count(); ++node)
    for (int d = 0; d < 2; ++d)
      if (!near_circle.contains(node) && !assembly.prescribed(2 * node + d)) {
        EXPECT_NEAR(assembly.residual()[2 * node + d], 0, 1e-13 * model.weight) << model.mesh.position[node].transpose();
        ++compared;
      }
  EXPECT_GT(compared, 200);
}

class PlateOnBlock : public testing::Test {
protected:
  PlateOnBlock()
  {
    settings::Case c = plate_on_block(plastic_soil(1e3, 30, 10), 0.5);
    c.contact[0].second.friction_angle = 0.3;
    c.support.clear();
    problem = fem_problem_of(c);
    change = random_numbers(problem.model.unknowns(), 1e-3);
    change[problem.model.rigid_unknown() + 1] = -1e-2;
  }
  FemProblem problem;
  std::vector<Real> change;
};

TEST_F(PlateOnBlock, forces_and_moments_of_soil_and_plate_cancel)
{
  const FemModel& model = problem.model;
  Assembly assembly(model);
  assembly.evaluate(problem.state, change, {}, 0.1);
  const auto& r = assembly.residual();
  Vec<2> sum(r[model.rigid_unknown()], r[model.rigid_unknown() + 1]);
  const Vec<2> centre(0.5, 0.6);
  Real moment = r[model.rigid_unknown() + 2], size = 0;
  for (Index node = 0; node < model.mesh.node_count(); ++node) {
    const Vec<2> force(r[2 * node], r[2 * node + 1]), arm = model.mesh.position[node] - centre;
    sum += force;
    moment += arm[0] * force[1] - arm[1] * force[0];
    size += force.norm();
  }
  EXPECT_GT(size, 1e3);
  EXPECT_LT(sum.norm(), 1e-13 * size);
  EXPECT_NEAR(moment, 0, 1e-13 * size);
}

TEST_F(PlateOnBlock, reaction_is_minus_the_tractions_on_the_soil_and_the_residual_of_a_free_plate)
{
  const FemModel& model = problem.model;
  Assembly assembly(model);
  FemLoads loads;
  for (FemLoads::Direction& direction : loads.rigid) direction = {true, 7};
  assembly.evaluate(problem.state, change, loads, 0);
  assembly.accept(problem.state, change, loads);
  Vec<2> sum = Vec<2>::Zero();
  Real magnitudes = 0;
  for (std::size_t k = 0; k < model.contact.size(); ++k) {
    sum -= model.contact[k].area * problem.state.contact[k].traction;
    magnitudes += model.contact[k].area * problem.state.contact[k].traction.norm();
  }
  EXPECT_GT(sum[1], 1e3);
  EXPECT_LT((assembly.reaction() - sum).norm(), 1e-13 * sum.norm());
  EXPECT_NEAR(assembly.contact_force() / magnitudes, 1, 1e-13);
  const auto& r = assembly.residual();
  for (int d = 0; d < 2; ++d) EXPECT_NEAR(r[model.rigid_unknown() + d], -sum[d] - 7, 1e-13 * sum.norm());
  EXPECT_NEAR(r[model.rigid_unknown() + 2], -assembly.torque() - 7, 1e-13 * sum.norm());
}

TEST_F(PlateOnBlock, unbalanced_forces_are_those_of_nodes_and_of_the_free_plate)
{
  const FemModel& model = problem.model;
  Assembly assembly(model);
  for (const bool by_force : {false, true}) {
    FemLoads loads;
    loads.rigid[0].by_force = loads.rigid[1].by_force = by_force;
    assembly.evaluate(problem.state, change, loads, 0);
    const auto& r = assembly.residual();
    Real sum = 0;
    for (Index node = 0; node < model.mesh.node_count(); ++node) sum += std::hypot(r[2 * node], r[2 * node + 1]);
    if (by_force) sum += std::abs(r[model.rigid_unknown()]) + std::abs(r[model.rigid_unknown() + 1]);
    EXPECT_NEAR(assembly.unbalanced() / sum, 1, 1e-13);
  }
}

TEST_F(PlateOnBlock, soil_that_is_pushed_in_a_second_time_goes_on_from_its_state)
{
  // Without plasticity two halves are the whole.
  FemProblem elastic = fem_problem_of(plate_on_block(elastic_soil(), 0.5));
  FemProblem twice = elastic;
  const auto go = [](FemProblem& p, Real part, const std::vector<Real>& whole) {
    std::vector<Real> moved = whole;
    for (Real& m : moved) m *= part;
    Assembly assembly(p.model);
    assembly.evaluate(p.state, moved, {}, 0);
    assembly.accept(p.state, moved, {});
    return assembly.reaction();
  };
  const Vec<2> whole = go(elastic, 1, change);
  go(twice, 0.5, change);
  EXPECT_LT((go(twice, 0.5, change) - whole).norm(), 1e-12 * whole.norm());
  EXPECT_NEAR(twice.state.state.ledger.totals.internal / elastic.state.state.ledger.totals.internal, 1, 1e-12);
  for (std::size_t k = 0; k < change.size(); ++k) EXPECT_NEAR(twice.state.displacement[k], change[k], 1e-15);
}

TEST(Assembly, viscosity_mixes_the_laws_stress_with_the_elastic_one_and_tells_the_overstress)
{
  FemProblem problem = fem_problem_of(block_of(plastic_soil(1e3, 0, 0)));
  const FemModel& model = problem.model;
  const auto shear = change_of(model, [](const Vec<2>& x) { return Vec<2>(1e-2 * x[1], 0); });
  // Shear modulus 4e5 Pa: the elastic stress is 4 kPa, the law's is its strength of 1 kPa.
  Assembly assembly(model);
  assembly.evaluate(problem.state, shear, {}, 0.25);
  assembly.accept(problem.state, shear, {});
  for (const auto& points : problem.state.points)
    for (const SoilPoint& point : points) {
      EXPECT_NEAR(point.stress[3], (1000 + 0.25 * 4000) / 1.25, 1e-9);
      EXPECT_NEAR(point.overstress, std::sqrt(2.) * 600, 1e-9);
    }
  EXPECT_NEAR(problem.state.overstress, 600. / 1600, 1e-12);
}

TEST(Assembly, strength_that_follows_the_pressure_of_the_increment_lags_no_more)
{
  // Lame's constants are 4e5 Pa. Soil under 1 kPa all round carries a shear stress of 500 Pa; squeezed by 1e-4 in both directions it has 1160 Pa and carries
  // 580 Pa. The elastic shear stress is 1 kPa; what it is beyond the strength, over the shear modulus, is plastic strain. The area is 0.5 m2.
  FemProblem problem = fem_problem_of(block_of(plastic_soil(0, 30, 0)));
  for (auto& points : problem.state.points)
    for (SoilPoint& point : points) point.stress = {{-1000, -1000, -1000, 0}};
  const auto change = change_of(problem.model, [](const Vec<2>& x) { return Vec<2>(-1e-4 * x[0] + 2.5e-3 * x[1], -1e-4 * x[1]); });
  Assembly assembly(problem.model);
  const auto expect_strength = [&](Real strength) {
    assembly.evaluate(problem.state, change, {}, 0);
    const StrengthLag lag = assembly.strength_lag(problem.state, change);
    const Real flow = 0.5 * (1000 - strength) / 4e5;
    EXPECT_NEAR(lag.dissipated / (strength * flow), 1, 1e-9);
    EXPECT_NEAR(lag.missing, (580 - strength) * flow, 1e-9);
    EXPECT_NEAR(lag.part(), 580 / strength - 1, 1e-9);
  };
  expect_strength(500);
  assembly.update_strength(1);
  expect_strength(580);
  assembly.undo_strength_update();
  expect_strength(500);
  assembly.update_strength(0.5);
  expect_strength(540);
  assembly.update_strength(0.5);
  expect_strength(560);
  assembly.undo_strength_update();
  expect_strength(540);
  assembly.reset_strength();
  expect_strength(500);
}

TEST(Assembly, tangents_of_elastic_soil_keep_their_bits)
{
  FemProblem problem = fem_problem_of(block_of(plastic_soil(1e3, 30, 0)));
  Assembly assembly(problem.model);
  const auto stiffness_after = [&](Real shear, Real viscosity) {
    const auto change = change_of(problem.model, [&](const Vec<2>& x) { return Vec<2>(shear * x[1], 0); });
    assembly.evaluate(problem.state, change, {}, viscosity);
    assembly.differentiate(problem.state, change, viscosity);
    return assembly.stiffness()[0];
  };
  const CellStiffness first = stiffness_after(1e-5, 1e-3);
  EXPECT_NE(stiffness_after(1e-2, 1e-3), first);  // flows
  EXPECT_EQ(stiffness_after(2e-5, 1e-2), first);
}

TEST(Assembly, soil_that_does_not_flow_has_no_lag_of_strength)
{
  for (const material::Material& soil : {material::Material(elastic_soil()), material::Material(plastic_soil(1e6, 30, 0))}) {
    FemProblem problem = fem_problem_of(block_of(soil));
    const auto shear = change_of(problem.model, [](const Vec<2>& x) { return Vec<2>(1e-3 * x[1], 0); });
    Assembly assembly(problem.model);
    assembly.evaluate(problem.state, shear, {}, 0);
    EXPECT_NEAR(assembly.strength_lag(problem.state, shear).dissipated, 0, 1e-9);
  }
  EXPECT_EQ(StrengthLag{}.part(), 0);
}

TEST(Assembly, held_back_forces_keep_the_first_state_in_balance)
{
  settings::Case c = block_of(elastic_soil());
  c.gravity = {0, -10};
  FemProblem problem = fem_problem_of(c);
  Assembly assembly(problem.model);
  FemLoads loads;
  loads.gravity = {0, -10};
  assembly.store_initial_imbalance(problem.state, loads);
  EXPECT_GT(assembly.unbalanced(), 0.5 * problem.model.weight);
  loads.initial_imbalance_factor = 1;
  assembly.evaluate(problem.state, std::vector<Real>(problem.model.unknowns(), 0.), loads, 0);
  EXPECT_LT(assembly.unbalanced(), 1e-15 * problem.model.weight);
}

TEST(Soil, has_the_friction_of_its_element_where_bands_have_a_width)
{
  material::MohrCoulomb sand;
  sand.density = 1800;
  sand.young_modulus = 1e7;
  sand.poisson_ratio = 0.3;
  sand.friction_angle = 35 * degree;
  sand.band_width = 0.1;
  const FemProblem problem = fem_problem_of(plate_on_block(sand, 1, {2, 1}));
  const FemModel& model = problem.model;
  for (Index cell = 0; cell < model.mesh.nodes.size(); ++cell) {
    const auto here = model.soil_at(cell, 0).get<material::MohrCoulomb>();
    EXPECT_EQ(here.friction_angle, regularised_for(sand, model.model.mesh.size(cell)).friction_angle);
    EXPECT_LT(here.friction_angle, sand.friction_angle);
  }
}

}  // namespace
}  // namespace berm::fem::this_file
