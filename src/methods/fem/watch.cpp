// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/fem/watch_test.cpp
#include "fem/fem_problem.hpp"

namespace berm::fem {
namespace {

Vec<2> place_in(const AtSixNodes<Vec<2>>& nodes, const Vec<2>& at)
{
  const AtSixNodes<Real> part = shape_functions(at);
  Vec<2> from_first = Vec<2>::Zero();
  for (int k = 1; k < 6; ++k) from_first += part[k] * (nodes[k] - nodes[0]);
  return nodes[0] + from_first;
}

/// The point of the reference triangle that lies at x; where x is outside, one on its rim near it.
Vec<2> nearest_in(const AtSixNodes<Vec<2>>& nodes, const Vec<2>& x)
{
  constexpr int corrections = 4;  // of curved sides: the first is exact for straight ones
  Vec<2> at(1. / 3, 1. / 3);
  for (int k = 0; k < corrections; ++k) {
    at += jacobian(nodes, at).inverse() * (x - place_in(nodes, at));
    if (!(at.cwiseAbs().maxCoeff() < 2)) break;  // far away: there the sides may fold
  }
  at = at.cwiseMax(0).cwiseMin(1);
  return at / std::max(Real(1), at.sum());
}

}  // namespace

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
    // One at one integration point and zero at the two others (element.cpp).
    const Real corners[3] = {1 - at[0] - at[1], at[0], at[1]};
    for (int q = 0; q < triangle_points; ++q) made.of_points[q] = 2 * corners[q] - 1. / 3;
  }
  return made;
}

}  // namespace berm::fem
