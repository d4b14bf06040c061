// SPDX-License-Identifier: BSD-3-Clause
#include "fem/moved_cell.hpp"

namespace berm::fem {
namespace {

ShapeAtPoint shape_in(const AtSixNodes<Vec<2>>& nodes, int point, mesh::Metric metric)
{
  ShapeAtPoint shape = shape_at(nodes, point);
  if (metric == mesh::Metric::axisymmetric && shape.area > 0) turn_around_axis(shape, position_of(shape, nodes));
  return shape;
}

}  // namespace

MovedCell move_cell(const AtSixNodes<Vec<2>>& nodes, const AtSixNodes<Vec<2>>& change, mesh::Metric metric)
{
  AtSixNodes<Vec<2>> middle, end;
  for (int k = 0; k < 6; ++k) {
    middle[k] = nodes[k] + change[k] / 2;
    end[k] = nodes[k] + change[k];
  }
  MovedCell moved;
  for (int q = 0; q < triangle_points && !moved.inverted; ++q) {
    moved.middle[q] = shape_in(middle, q, metric);
    moved.end[q] = shape_in(end, q, metric);
    moved.inverted = !(moved.middle[q].area > 0 && moved.end[q].area > 0);
    Real curl = 0;  // twice the spin
    for (int k = 0; k < 6; ++k) curl += moved.middle[q].gradient[k][0] * change[k][1] - moved.middle[q].gradient[k][1] * change[k][0];
    // The tangent of half the angle is half the spin.
    const Real t = curl / 4, cosine = (1 - t * t) / (1 + t * t), sine = 2 * t / (1 + t * t);
    moved.rotation[q] = {cosine * cosine - sine * sine, 2 * sine * cosine};
  }
  return moved;
}

SymTensor<2> rotated(const SymTensor<2>& stress, const Rotation& rotation)
{
  const auto [cosine, sine] = rotation;
  const Real mean = (stress[0] + stress[1]) / 2, half = (stress[0] - stress[1]) / 2;
  SymTensor<2> turned = stress;
  turned[0] = mean + half * cosine - stress[3] * sine;
  turned[1] = mean - half * cosine + stress[3] * sine;
  turned[3] = half * sine + stress[3] * cosine;
  return turned;
}

}  // namespace berm::fem
