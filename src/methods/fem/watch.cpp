// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/fem/watch_test.cpp
#include "fem/fem_problem.hpp"
#include "fem/point_locator.hpp"

namespace berm::fem {

FemWatch make_watch(const QuadraticMesh& mesh, const std::string& name, const Vec<2>& point, Index body)
{
  FemWatch made{.name = name};
  Real nearest = infinity;
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
    if (mesh.body[cell] != body) continue;
    const AtSixNodes<Vec<2>> nodes = mesh.positions_of(cell);
    const Vec<2> at = nearest_in(nodes, point);
    const Real away = (place_in(nodes, at) - point).norm();
    if (!(away < nearest)) continue;
    nearest = away;
    made.cell = cell;
    made.of_nodes = shape_functions(at);
    made.of_points = linear_weights(at);
  }
  return made;
}

}  // namespace berm::fem
