// SPDX-License-Identifier: BSD-3-Clause
#include "fem/space_assembly.hpp"

#include "samples/space_footing.hpp"

#include <gtest/gtest.h>

namespace berm::fem::this_file {
namespace {

// Numbers of about 1 after sums of some hundred terms.
constexpr Real rounding = 1e-10;

void put(std::vector<Real>& change, Index node, const Vec<3>& u)
{
  std::copy_n(u.data(), 3, &change[3 * node]);
}

TEST(SpaceAssembly, passes_the_patch_test)
{
  // Under a linear displacement the stress is uniform, and nodes within carry nothing; inner corners lie where they like.
  mesh::Mesh<3> mesh = mesh::make_box<3>(std::get<mesh::BoxMesh>(block_in_space(elastic_soil()).mesh));
  for (Vec<3>& x : mesh.position)
    if ((x - Vec<3>(0.5, -0.5, 0.5)).norm() < 1e-9) x += Vec<3>(0.07, -0.11, 0.05);
  const SpaceProblem p = build_in_space(block_in_space(elastic_soil()), mesh);
  Matrix<3> gradient;
  gradient << 1, 0.3, -0.2, 0.5, -0.7, 0.1, 0.2, 0.4, 0.6;
  gradient *= 1e-3;
  std::vector<Real> change(static_cast<std::size_t>(p.model.unknowns()), 0.);
  for (Index node = 0; node < p.model.mesh.node_count(); ++node) put(change, node, gradient * p.model.mesh.position[node]);
  SpaceAssembly assembly(p.model);
  assembly.evaluate(p.state, change, {}, 0);
  for (Index node = 0; node < p.model.mesh.node_count(); ++node) {
    const Vec<3>& x = p.model.mesh.position[node];
    const bool within = x[0] > 0 && x[0] < 1 && x[2] > 0 && x[2] < 1 && x[1] < 0 && x[1] > -1;
    for (int d = 0; within && d < 3; ++d) EXPECT_NEAR(assembly.residual()[3 * node + d], 0, 1e3 * rounding);  // stresses of 1e3 Pa
  }
  SpaceState state = p.state;
  assembly.accept(state, change, {});
  const material::Elasticity elastic = elasticity(material::Material(elastic_soil()));
  const Matrix<3> expected = elastic.lame * gradient.trace() * Matrix<3>::Identity() + elastic.shear * (gradient + gradient.transpose());
  for (const auto& of_cell : state.points)
    for (const ElementSoil<3>& point : of_cell) {
      const SymTensor<3>& s = point.stress;
      EXPECT_NEAR(s[0], expected(0, 0), 1e3 * rounding);
      EXPECT_NEAR(s[1], expected(1, 1), 1e3 * rounding);
      EXPECT_NEAR(s[2], expected(2, 2), 1e3 * rounding);
      EXPECT_NEAR(s[3], expected(0, 1), 1e3 * rounding);
      EXPECT_NEAR(s[4], expected(1, 2), 1e3 * rounding);
      EXPECT_NEAR(s[5], expected(0, 2), 1e3 * rounding);
    }
}

TEST(SpaceAssembly, has_no_force_where_the_block_turns_as_a_whole)
{
  const SpaceProblem p = space_problem_of(block_in_space(elastic_soil()));
  std::vector<Real> change(static_cast<std::size_t>(p.model.unknowns()), 0.);
  for (Index node = 0; node < p.model.mesh.node_count(); ++node)
    put(change, node, bodies::cross(Vec<3>(1, 2, -3) * 1e-3, p.model.mesh.position[node]) + Vec<3>(4, 5, 6));
  SpaceAssembly assembly(p.model);
  assembly.evaluate(p.state, change, {}, 0);
  for (Index k = 0; k < p.model.rigid_unknown(); ++k) EXPECT_NEAR(assembly.residual()[k], 0, 1e4 * rounding);  // of 1e6 Pa, u = 6 m
}

TEST(SpaceAssembly, tangent_is_the_derivative_of_the_residual_with_tied_nodes)
{
  const SpaceFooting footing{.cells = 2, .far = 1.5, .soil = plastic_soil(1e3, 0, 0)};
  const SpaceProblem p = footing.problem();
  ElementLoads<3> loads;
  loads.moved = 0;
  for (auto& direction : loads.rigid) direction.by_force = true;
  SpaceAssembly assembly(p.model);
  constexpr Real viscosity = 1;
  const auto count = static_cast<std::size_t>(p.model.unknowns());
  std::vector<Real> change = random_numbers(p.model.unknowns(), 1e-3), entries(static_cast<std::size_t>(p.model.pattern.entry_count())),
                    right(count, 0.);
  assembly.carry_tied_nodes(change);
  assembly.evaluate(p.state, change, loads, viscosity);
  std::vector<Real> direction = random_numbers(p.model.unknowns(), 1);
  for (Index k = 0; k < p.model.unknowns(); ++k)
    if (assembly.prescribed(k)) direction[k] = 0;
  assembly.differentiate(p.state, change, viscosity, entries, right);
  std::vector<Real> product(count, 0.);
  for (Index row = 0; row < p.model.pattern.size(); ++row)
    for (Index k = p.model.pattern.first[row]; k < p.model.pattern.first[row + 1]; ++k) {
      const Index column = p.model.pattern.column[k];
      product[row] += entries[k] * direction[column];
      if (column != row) product[column] += entries[k] * direction[row];
    }
  assembly.carry_tied_nodes(direction);
  // A small step, so that hardly a point passes a corner of the yield surface.
  constexpr Real step = 1e-10;
  const auto residual_at = [&](Real part) {
    std::vector<Real> moved = change;
    for (std::size_t k = 0; k < count; ++k) moved[k] += part * direction[k];
    assembly.evaluate(p.state, moved, loads, viscosity);
    return assembly.residual();
  };
  const std::vector<Real> after = residual_at(step), before = residual_at(-step);
  Real error = 0, size = 0;
  for (std::size_t k = 0; k < count; ++k) {
    if (assembly.prescribed(static_cast<Index>(k))) continue;
    error = std::hypot(error, (after[k] - before[k]) / (2 * step) - product[k]);
    size = std::hypot(size, product[k]);
  }
  EXPECT_LT(error, 1e-4 * size);  // rounding of residuals of 1e3 N over steps of 1e-4 N is 1e-9; min_stiffness 1e-6
}

}  // namespace
}  // namespace berm::fem::this_file
