// SPDX-License-Identifier: BSD-3-Clause
#include "fem/element.hpp"

namespace berm::fem {
namespace {

/// What does not depend on the nodes.
template <int dim>
struct ReferencePoint {
  AtElementNodes<dim, Real> value;
  AtElementNodes<dim, Vec<dim>> derivative;
};

/// Each integration point is nearest to one corner: its barycentric coordinate of that corner; in space (5 + 3 sqrt(5))/20.
template <int dim>
constexpr Real far = 2. / 3;
template <>
constexpr Real far<3> = 0.58541019662496845446;
/// The others.
template <int dim>
constexpr Real near = 1. / 6;
template <>
constexpr Real near<3> = 0.13819660112501051518;

template <int dim>
const std::array<ReferencePoint<dim>, element_points<dim>>& reference_points()
{
  static const std::array<ReferencePoint<dim>, element_points<dim>> points = [] {
    std::array<ReferencePoint<dim>, element_points<dim>> made;
    for (int q = 0; q < element_points<dim>; ++q) {
      Vec<dim> at = Vec<dim>::Constant(near<dim>);
      if (q > 0) at[q - 1] = far<dim>;
      made[q] = {shape_functions<dim>(at), shape_derivatives<dim>(at)};
    }
    return made;
  }();
  return points;
}

}  // namespace

template <int dim>
ElementPoint<dim> shape_at(const AtElementNodes<dim, Vec<dim>>& nodes, int point)
{
  constexpr Real points_per_unit = dim == 2 ? 6 : 24;  // of the reference element, whose area is 1/2, or volume 1/6
  const ReferencePoint<dim>& reference = reference_points<dim>()[static_cast<std::size_t>(point)];
  const Matrix<dim> j = jacobian<dim>(nodes, reference.derivative), to_place = j.inverse().transpose();
  ElementPoint<dim> shape;
  shape.value = reference.value;
  for (int k = 0; k < element_nodes<dim>; ++k) shape.gradient[k] = to_place * reference.derivative[k];
  shape.area = j.determinant() / points_per_unit;
  shape.per_radius = 0;
  return shape;
}

template ElementPoint<2> shape_at<2>(const AtElementNodes<2, Vec<2>>&, int);
template ElementPoint<3> shape_at<3>(const AtElementNodes<3, Vec<3>>&, int);

void turn_around_axis(ShapeAtPoint& shape, const Vec<2>& position)
{
  shape.per_radius = 1 / position[0];
  shape.area *= position[0];
}

}  // namespace berm::fem
