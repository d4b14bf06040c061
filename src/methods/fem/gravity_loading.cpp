// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/fem/load_steps_test.cpp
#include "fem/fem_problem.hpp"

#include "os/error.hpp"
#include "problem/initial_state.hpp"

namespace berm::fem {
namespace {

/// The strain at a point where the unknown k of an element (x, y, x, y, ...) is 1.
SymTensor<2> strain_of_unknown(const ShapeAtPoint& shape, int k)
{
  const Vec<2>& gradient = shape.gradient[k / 2];
  SymTensor<2> strain{};
  strain[k % 2] = gradient[k % 2];
  strain[3] = gradient[1 - k % 2] / 2;
  return strain;
}

}  // namespace

void load_by_gravity(const settings::Case& c, const FemModel& model, FemState& state)
{
  const auto ground_at = [&](Index cell, int q) {
    const Real depth = model.place[cell][q].depth, above = model.soil_of(cell).vertical_stress(model.region_of(cell), model.place[cell][q]);
    return problem::ground_elasticity(model.soil_at(cell, q), *c.body[model.mesh.body[cell]].second.k0_at(depth, above));
  };
  std::vector<char> prescribed(model.unknowns(), 0);
  const NodeField<std::uint8_t>& fixed = model.mesh.fixed[model.model.conditions.table_of_stage[0]];
  for (Index k = 0; k < model.unknowns(); ++k) prescribed[k] = k >= model.rigid_unknown() || (fixed[k / 2] >> k % 2 & 1) != 0;

  std::vector<Real> matrix(model.pattern.entry_count(), 0.), unknowns(model.unknowns(), 0.);
  for (Index cell = 0; cell < model.mesh.cell_count(); ++cell) {
    const auto& nodes = model.mesh.nodes[cell];
    for (int q = 0; q < triangle_points; ++q) {
      const ShapeAtPoint& shape = model.shape[cell][q];
      const problem::GroundElasticity ground = ground_at(cell, q);
      const Real density = model.density[cell][q];
      int entry = 0;
      for (int i = 0; i < 12; ++i) {
        unknowns[2 * nodes[i / 2] + i % 2] += shape.area * shape.value[i / 2] * density * model.model.gravity[i % 2];
        const SymTensor<2> stress = stress_of<2>(ground, strain_of_unknown(shape, i));
        for (int j = 0; j <= i; ++j)
          matrix[model.cell_entries[cell][entry++]] += shape.area * double_dot(stress, strain_of_unknown(shape, j));
      }
    }
  }
  for (Index row = 0; row < model.pattern.size(); ++row) {
    if (prescribed[row]) unknowns[row] = 0;
    for (Index k = model.pattern.first[row]; k < model.pattern.first[row + 1]; ++k)
      if (prescribed[row] || prescribed[model.pattern.column[k]]) matrix[k] = model.pattern.column[k] == row ? 1 : 0;
  }
  DirectSolver solver(model.pattern);
  if (!solver.factorize(matrix))
    throw KeyError("initial_state: there is no equilibrium under gravity: supports of the first stage must hold the soil");
  solver.solve(unknowns);

  for (Index cell = 0; cell < model.mesh.cell_count(); ++cell)
    for (int q = 0; q < triangle_points; ++q) {
      SymTensor<2> strain{};
      for (int k = 0; k < 12; ++k) {
        const SymTensor<2> of_unknown = strain_of_unknown(model.shape[cell][q], k);
        for (int s = 0; s < 4; ++s) strain[s] += unknowns[2 * model.mesh.nodes[cell][k / 2] + k % 2] * of_unknown[s];
      }
      state.points[cell][q].stress = stress_of<2>(ground_at(cell, q), strain);
    }
}

}  // namespace berm::fem
