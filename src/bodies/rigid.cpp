// SPDX-License-Identifier: BSD-3-Clause
#include "bodies/rigid.hpp"

namespace berm {
namespace {

template <int dim>
Vec<dim> to_vec(const std::vector<Real>& numbers)
{
  Vec<dim> v;
  for (int d = 0; d < dim; ++d) v[d] = numbers[d];
  return v;
}

template <int dim>
RigidShape<dim> make(const CircleSettings& s)
{
  return Circle<dim>{to_vec<dim>(s.center), s.diameter / 2};
}
template <int dim>
RigidShape<dim> make(const HalfPlaneSettings& s)
{
  return HalfPlane<dim>{to_vec<dim>(s.point), to_vec<dim>(s.normal).normalized()};
}
template <int dim>
RigidShape<dim> make(const BoxSettings& s)
{
  Matrix<dim> axes = Matrix<dim>::Identity();
  axes(0, 0) = axes(1, 1) = std::cos(s.angle);
  axes(1, 0) = std::sin(s.angle);
  axes(0, 1) = -axes(1, 0);
  return Box<dim>{to_vec<dim>(s.center), to_vec<dim>(s.size) / 2, axes};
}

}  // namespace

template <int dim>
RigidShape<dim> make_shape(const RigidShapeSettings& settings)
{
  return std::visit([](const auto& s) { return make<dim>(s); }, settings);
}

template <int dim>
SurfacePoint<dim> surface_at(const Circle<dim>& circle, const Vec<dim>& x)
{
  Vec<dim> from = x - circle.center;
  if constexpr (dim == 3) from[2] = 0;  // an endless cylinder along z
  const Real length = from.norm();
  if (length < 1e-12 * circle.radius) return {-circle.radius, Vec<dim>::UnitY()};
  return {length - circle.radius, from / length};
}

template <int dim>
SurfacePoint<dim> surface_at(const HalfPlane<dim>& plane, const Vec<dim>& x)
{
  return {plane.normal.dot(x - plane.point), plane.normal};
}

template <int dim>
SurfacePoint<dim> surface_at(const Box<dim>& box, const Vec<dim>& x)
{
  const Vec<dim> local = box.axes.transpose() * (x - box.center);
  const Vec<dim> beyond = local.cwiseAbs() - box.half;
  Vec<dim> normal = Vec<dim>::Zero();
  int side = 0;
  const Real inside = beyond.maxCoeff(&side);
  if (inside <= 0) {
    normal[side] = local[side] < 0 ? -1 : 1;
    return {inside, box.axes * normal};
  }
  const Vec<dim> outside = beyond.cwiseMax(0);
  const Real distance = outside.norm();
  for (int d = 0; d < dim; ++d) normal[d] = (local[d] < 0 ? -outside[d] : outside[d]) / distance;
  return {distance, box.axes * normal};
}

template <int dim>
RigidShape<dim> moved(const RigidShape<dim>& shape, const Vec<dim>& by)
{
  RigidShape<dim> result = shape;
  if (auto* circle = std::get_if<Circle<dim>>(&result)) circle->center += by;
  if (auto* plane = std::get_if<HalfPlane<dim>>(&result)) plane->point += by;
  if (auto* box = std::get_if<Box<dim>>(&result)) box->center += by;
  return result;
}

template <int dim>
Real lowest_level(const RigidShape<dim>& shape)
{
  if (const auto* circle = std::get_if<Circle<dim>>(&shape)) return circle->center[1] - circle->radius;
  if (const auto* plane = std::get_if<HalfPlane<dim>>(&shape)) return plane->point[1];
  const auto& box = std::get<Box<dim>>(shape);
  return box.center[1] - box.axes.row(1).cwiseAbs().dot(box.half.transpose());
}

template <int dim>
Vec<dim> center_of(const RigidShape<dim>& shape)
{
  if (const auto* circle = std::get_if<Circle<dim>>(&shape)) return circle->center;
  if (const auto* plane = std::get_if<HalfPlane<dim>>(&shape)) return plane->point;
  return std::get<Box<dim>>(shape).center;
}

template <int dim>
Real width_of(const RigidShape<dim>& shape)
{
  if (const auto* circle = std::get_if<Circle<dim>>(&shape)) return 2 * circle->radius;
  if (const auto* box = std::get_if<Box<dim>>(&shape)) return 2 * box->half[0];
  return 0;
}

#define BERM_INSTANTIATE(dim)                                                                                                              \
  template RigidShape<dim> make_shape<dim>(const RigidShapeSettings&);                                                                     \
  template SurfacePoint<dim> surface_at<dim>(const Circle<dim>&, const Vec<dim>&);                                                         \
  template SurfacePoint<dim> surface_at<dim>(const HalfPlane<dim>&, const Vec<dim>&);                                                      \
  template SurfacePoint<dim> surface_at<dim>(const Box<dim>&, const Vec<dim>&);                                                            \
  template RigidShape<dim> moved<dim>(const RigidShape<dim>&, const Vec<dim>&);                                                            \
  template Vec<dim> center_of<dim>(const RigidShape<dim>&);                                                                                \
  template Real lowest_level<dim>(const RigidShape<dim>&);                                                                                 \
  template Real width_of<dim>(const RigidShape<dim>&);
BERM_INSTANTIATE(2)
BERM_INSTANTIATE(3)
#undef BERM_INSTANTIATE

}  // namespace berm
