// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/fem/watch_test.cpp
#include "fem/point_locator.hpp"

#include <algorithm>

namespace berm::fem {

Vec<2> place_in(const AtSixNodes<Vec<2>>& nodes, const Vec<2>& at)
{
  const AtSixNodes<Real> part = shape_functions(at);
  Vec<2> from_first = Vec<2>::Zero();
  for (int k = 1; k < 6; ++k) from_first += part[k] * (nodes[k] - nodes[0]);
  return nodes[0] + from_first;
}

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

std::array<Real, triangle_points> linear_weights(const Vec<2>& at)
{
  const Real corners[3] = {1 - at[0] - at[1], at[0], at[1]};
  std::array<Real, triangle_points> weights;
  for (int q = 0; q < triangle_points; ++q) weights[q] = 2 * corners[q] - 1. / 3;  // element.cpp has the points
  return weights;
}

PointLocator::PointLocator(const QuadraticMesh& mesh, const NodeField<Vec<2>>& position) : mesh_(mesh), position_(position)
{
  Vec<2> upper = position[0];
  lower_ = upper;
  for (const Vec<2>& x : position) lower_ = lower_.cwiseMin(x), upper = upper.cwiseMax(x);
  const Vec<2> size = upper - lower_;
  // About one element a bin.
  const Real side = std::sqrt(size[0] * size[1] / static_cast<Real>(mesh.cell_count()));
  for (int d = 0; d < 2; ++d) {
    bins_[d] = std::max(Index(1), static_cast<Index>(size[d] / side));
    bin_size_[d] = size[d] / static_cast<Real>(bins_[d]);
  }
  cells_.resize(static_cast<std::size_t>(bins_[0]) * static_cast<std::size_t>(bins_[1]));
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
    Vec<2> low = position[mesh.nodes[cell][0]], high = low;
    for (const Index node : mesh.nodes[cell]) low = low.cwiseMin(position[node]), high = high.cwiseMax(position[node]);
    const auto first = bin_of(low), last = bin_of(high);
    for (Index j = first[1]; j <= last[1]; ++j)
      for (Index i = first[0]; i <= last[0]; ++i) cells_[static_cast<std::size_t>(j * bins_[0] + i)].push_back(cell);
  }
}

std::array<Index, 2> PointLocator::bin_of(const Vec<2>& x) const
{
  std::array<Index, 2> bin;
  for (int d = 0; d < 2; ++d) bin[d] = std::clamp(static_cast<Index>((x[d] - lower_[d]) / bin_size_[d]), Index(0), bins_[d] - 1);
  return bin;
}

AtSixNodes<Vec<2>> PointLocator::nodes_of(Index cell) const
{
  AtSixNodes<Vec<2>> nodes;
  for (int k = 0; k < 6; ++k) nodes[k] = position_[mesh_.nodes[cell][k]];
  return nodes;
}

MeshPoint PointLocator::find(const Vec<2>& x) const
{
  constexpr Real rounding = 1e-9;
  const auto [column, row] = bin_of(x);
  MeshPoint nearest;
  Real least = infinity;
  // Ring by ring; outside of the mesh one ring more than where the first element was met.
  for (Index ring = 0, last = bins_[0] + bins_[1]; ring <= last; ++ring)
    for (Index j = std::max(Index(0), row - ring); j <= std::min(bins_[1] - 1, row + ring); ++j)
      for (Index i = std::max(Index(0), column - ring); i <= std::min(bins_[0] - 1, column + ring); ++i) {
        if (std::max(std::abs(i - column), std::abs(j - row)) != ring) continue;
        for (const Index cell : cells_[static_cast<std::size_t>(j * bins_[0] + i)]) {
          const AtSixNodes<Vec<2>> nodes = nodes_of(cell);
          const Vec<2> at = nearest_in(nodes, x);
          const Real away = (place_in(nodes, at) - x).norm();
          if (!(away < least)) continue;
          if (nearest.cell == none) last = std::min(last, ring + 1);
          least = away;
          nearest = {cell, at};
          if (away < rounding * (nodes[1] - nodes[0]).norm()) return nearest;
        }
      }
  return nearest;
}

}  // namespace berm::fem
