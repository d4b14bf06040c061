// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/mesh/cell_part_test.cpp
#include "mesh/cell_part.hpp"

#include <Eigen/LU>

namespace berm::mesh {
namespace {

/// Section and centre of the positive part of a triangle, from the triangles between its first corner and its other sides.
void measure(const Mesh<2>& mesh, Index cell, const std::array<Real, 3>& value, CellPart<2>& part)
{
  std::array<Vec<2>, 4> corners;
  int count = 0;
  for (int a = 0; a < 3; ++a) {
    const int b = (a + 1) % 3;
    const Vec<2>&from = mesh.position[mesh.nodes[cell][a]], &to = mesh.position[mesh.nodes[cell][b]];
    if (value[a] >= 0) corners[count++] = from;
    if ((value[a] < 0) != (value[b] < 0)) corners[count++] = from + value[a] / (value[a] - value[b]) * (to - from);
  }
  Vec<2> moment = Vec<2>::Zero();
  for (int k = 2; k < count; ++k) {
    const Vec<2> a = corners[k - 1] - corners[0], b = corners[k] - corners[0];
    const Real area = std::abs(a[0] * b[1] - a[1] * b[0]) / 2;
    part.section += area;
    moment += area / 3 * (a + b);
  }
  part.center = part.section > 0 ? Vec<2>(corners[0] + moment / part.section) : mesh.centroid(cell);
}

/// The part of its volume that two corners of a tetrahedron have in common with a linear field's positive side, the others being on the other: a wedge, as three
/// tetrahedra.
Real fraction_of_wedge(const std::array<Real, 4>& value)
{
  using Place = Eigen::Vector4d;  // by corner
  std::array<int, 2> in{}, out{};
  int ins = 0, outs = 0;
  for (int k = 0; k < 4; ++k)
    if (value[k] >= 0)
      in[ins++] = k;
    else
      out[outs++] = k;
  const auto between = [&](int a, int b) {
    const Real t = value[a] / (value[a] - value[b]);
    return Place((1 - t) * Place::Unit(a) + t * Place::Unit(b));
  };
  const std::array<std::array<Place, 3>, 2> ends{{{Place::Unit(in[0]), between(in[0], out[0]), between(in[0], out[1])},
                                                  {Place::Unit(in[1]), between(in[1], out[0]), between(in[1], out[1])}}};
  const auto of = [](const Place& a, const Place& b, const Place& c, const Place& d) {
    Eigen::Matrix4d corners;
    corners << a, b, c, d;
    return std::abs(corners.determinant());
  };
  return of(ends[0][0], ends[0][1], ends[0][2], ends[1][2]) + of(ends[0][0], ends[0][1], ends[1][2], ends[1][1]) +
         of(ends[0][0], ends[1][1], ends[1][2], ends[1][0]);
}

void measure(const Mesh<3>& mesh, Index cell, const std::array<Real, 4>& value, CellPart<3>& part)
{
  const auto negative = std::count_if(value.begin(), value.end(), [](Real v) { return v < 0; });
  // The corner that is alone on its side has a tetrahedron similar to no other: a product of parts of its three edges.
  const auto at_corner = [&](int alone) {
    Real product = 1;
    for (int k = 0; k < 4; ++k)
      if (k != alone) product *= value[alone] / (value[alone] - value[k]);
    return product;
  };
  const auto the_only = [&](bool is_negative) {
    return static_cast<int>(std::find_if(value.begin(), value.end(), [&](Real v) { return (v < 0) == is_negative; }) - value.begin());
  };
  const Real left = negative == 4   ? 0
                    : negative == 3 ? at_corner(the_only(false))
                    : negative == 2 ? fraction_of_wedge(value)
                    : negative == 1 ? 1 - at_corner(the_only(true))
                                    : 1;
  part.section = left * mesh.section(cell);
}

}  // namespace

template <int dim>
CellPart<dim> positive_part(const Mesh<dim>& mesh, Index cell, const std::array<Real, dim + 1>& at_corners)
{
  CellPart<dim> part;
  part.cut = std::any_of(at_corners.begin(), at_corners.end(), [](Real value) { return value < 0; });
  if (!part.cut) return part;
  measure(mesh, cell, at_corners, part);
  part.volume = mesh.metric == Metric::axisymmetric ? part.section * part.center[0] : part.section;
  return part;
}

template CellPart<2> positive_part(const Mesh<2>&, Index, const std::array<Real, 3>&);
template CellPart<3> positive_part(const Mesh<3>&, Index, const std::array<Real, 4>&);

}  // namespace berm::mesh
