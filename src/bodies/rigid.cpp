// SPDX-License-Identifier: BSD-3-Clause
#include "bodies/rigid.hpp"

#include <algorithm>

namespace berm::bodies {
namespace {

template <int dim>
Vec<dim> to_vec(const std::vector<Real>& numbers)
{
  Vec<dim> v;
  for (int d = 0; d < dim; ++d) v[d] = numbers[d];
  return v;
}

Real cross(const Vec<2>& a, const Vec<2>& b)
{
  return a[0] * b[1] - a[1] * b[0];
}

/// Visits visit(a, b, cross(a, b)) for the ends of each side.
template <class Visit>
void visit_sides(const std::vector<Vec<2>>& corners, const Visit& visit)
{
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vec<2>&a = corners[k], &b = corners[(k + 1) % corners.size()];
    visit(a, b, cross(a, b));
  }
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
  return Box<dim>{to_vec<dim>(s.center), to_vec<dim>(s.size) / 2, turn<dim>(s.angle)};
}
template <int dim>
RigidShape<dim> make(const PolygonSettings& s)
{
  // The sums are taken from the first corner, so that they lose no digits where the polygon is far from the origin.
  std::vector<Vec<2>> corners;
  for (std::size_t k = 0; k < s.x.size(); ++k) corners.emplace_back(s.x[k] - s.x[0], s.y[k] - s.y[0]);
  Real twice_area = 0;
  Vec<2> moment = Vec<2>::Zero();
  visit_sides(corners, [&](const Vec<2>& a, const Vec<2>& b, Real part) {
    twice_area += part;
    moment += part * (a + b) / 3;
  });
  const Vec<2> centroid = moment / twice_area;
  for (Vec<2>& corner : corners) corner -= centroid;
  if (twice_area < 0) std::reverse(corners.begin(), corners.end());
  Vec<dim> center = Vec<dim>::Zero();
  center[0] = s.x[0] + centroid[0];
  center[1] = s.y[0] + centroid[1];
  return Polygon<dim>{center, Matrix<dim>::Identity(), std::make_shared<const std::vector<Vec<2>>>(std::move(corners))};
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
SurfacePoint<dim> surface_at(const Polygon<dim>& polygon, const Vec<dim>& x)
{
  const Vec<2> local = (polygon.axes.transpose() * (x - polygon.center)).template head<2>();
  const std::vector<Vec<2>>& corners = *polygon.corners;
  const std::size_t n = corners.size();
  Real min = infinity, distance = 0;
  Vec<2> normal = Vec<2>::Zero();
  for (std::size_t k = 0; k < n; ++k) {
    const Vec<2>&a = corners[k], along = corners[(k + 1) % n] - a, reach = local - a;
    const Real t = std::clamp(reach.dot(along) / along.squaredNorm(), Real(0), Real(1));
    const Vec<2> from = reach - t * along;
    const Real square = from.squaredNorm();
    if (square >= min) continue;
    min = square;
    const Vec<2> outwards = Vec<2>(along[1], -along[0]).normalized();
    if ((t > 0 && t < 1) || square == 0) {
      distance = outwards.dot(reach);
      normal = outwards;
    } else {  // what is nearest to a corner is outside where the corner sticks out, and inside where it is a notch
      const Vec<2> before = t == 0 ? Vec<2>(a - corners[(k + n - 1) % n]) : along;
      const Vec<2> behind = t == 0 ? along : Vec<2>(corners[(k + 2) % n] - a - along);
      const Real sign = cross(before, behind) < 0 ? -1 : 1;
      distance = sign * std::sqrt(square);
      normal = from / distance;
    }
  }
  Vec<dim> in_space = Vec<dim>::Zero();
  in_space.template head<2>() = normal;
  return {distance, polygon.axes * in_space};
}

template <int dim>
Vec<dim> center_now(const RigidBody<dim>& rigid, const RigidState<dim>& state)
{
  return center_of<dim>(rigid.shape) + state.displacement;
}

template <int dim>
RigidShape<dim> placed(const RigidBody<dim>& rigid, const RigidState<dim>& state)
{
  RigidShape<dim> shape = rigid.shape;
  if (auto* circle = std::get_if<Circle<dim>>(&shape)) {
    circle->center += state.displacement;
    circle->angle += state.angle;
  }
  if (auto* plane = std::get_if<HalfPlane<dim>>(&shape)) plane->point += state.displacement;
  const auto place = [&](auto* turned) {
    if (turned == nullptr) return;
    turned->center += state.displacement;
    turned->axes = turn<dim>(state.angle) * turned->axes;
  };
  place(std::get_if<Box<dim>>(&shape));
  place(std::get_if<Polygon<dim>>(&shape));
  return shape;
}

template <int dim>
Real lowest_level(const RigidShape<dim>& shape)
{
  if (const auto* circle = std::get_if<Circle<dim>>(&shape)) return circle->center[1] - circle->radius;
  if (const auto* plane = std::get_if<HalfPlane<dim>>(&shape)) return plane->point[1];
  if (const auto* polygon = std::get_if<Polygon<dim>>(&shape)) {
    Real lowest = infinity;
    for (const Vec<2>& corner : *polygon->corners)
      lowest = std::min(lowest, polygon->center[1] + polygon->axes(1, 0) * corner[0] + polygon->axes(1, 1) * corner[1]);
    return lowest;
  }
  const auto& box = std::get<Box<dim>>(shape);
  return box.center[1] - box.axes.row(1).cwiseAbs().dot(box.half.transpose());
}

template <int dim>
Vec<dim> center_of(const RigidShape<dim>& shape)
{
  if (const auto* circle = std::get_if<Circle<dim>>(&shape)) return circle->center;
  if (const auto* plane = std::get_if<HalfPlane<dim>>(&shape)) return plane->point;
  if (const auto* polygon = std::get_if<Polygon<dim>>(&shape)) return polygon->center;
  return std::get<Box<dim>>(shape).center;
}

template <int dim>
Real width_of(const RigidShape<dim>& shape)
{
  if (const auto* circle = std::get_if<Circle<dim>>(&shape)) return 2 * circle->radius;
  if (const auto* box = std::get_if<Box<dim>>(&shape)) return 2 * box->half[0];
  if (const auto* polygon = std::get_if<Polygon<dim>>(&shape)) {
    Real left = infinity, right = -infinity;
    for (const Vec<2>& corner : *polygon->corners) left = std::min(left, corner[0]), right = std::max(right, corner[0]);
    return right - left;
  }
  return 0;
}

template <int dim>
Real reach_of(const RigidShape<dim>& shape)
{
  if (const auto* circle = std::get_if<Circle<dim>>(&shape)) return circle->radius;
  if (const auto* box = std::get_if<Box<dim>>(&shape)) return box->half.template head<2>().norm();
  Real reach = 0;
  if (const auto* polygon = std::get_if<Polygon<dim>>(&shape))
    for (const Vec<2>& corner : *polygon->corners) reach = std::max(reach, corner.norm());
  return reach;
}

template <int dim>
Real inertia_over_mass(const RigidShape<dim>& shape)
{
  if (const auto* circle = std::get_if<Circle<dim>>(&shape)) return circle->radius * circle->radius / 2;
  if (const auto* box = std::get_if<Box<dim>>(&shape)) return box->half.template head<2>().squaredNorm() / 3;
  const auto* polygon = std::get_if<Polygon<dim>>(&shape);
  if (polygon == nullptr) return 0;
  // The sum over the triangles between the centre and each side.
  Real second = 0, twice_area = 0;
  visit_sides(*polygon->corners, [&](const Vec<2>& a, const Vec<2>& b, Real part) {
    second += part * (a.dot(a) + a.dot(b) + b.dot(b));
    twice_area += part;
  });
  return second / (6 * twice_area);
}

#define BERM_INSTANTIATE(dim)                                                                                                              \
  template RigidShape<dim> make_shape<dim>(const RigidShapeSettings&);                                                                     \
  template SurfacePoint<dim> surface_at<dim>(const Circle<dim>&, const Vec<dim>&);                                                         \
  template SurfacePoint<dim> surface_at<dim>(const HalfPlane<dim>&, const Vec<dim>&);                                                      \
  template SurfacePoint<dim> surface_at<dim>(const Box<dim>&, const Vec<dim>&);                                                            \
  template SurfacePoint<dim> surface_at<dim>(const Polygon<dim>&, const Vec<dim>&);                                                        \
  template Vec<dim> center_now<dim>(const RigidBody<dim>&, const RigidState<dim>&);                                                        \
  template RigidShape<dim> placed<dim>(const RigidBody<dim>&, const RigidState<dim>&);                                                     \
  template Real reach_of<dim>(const RigidShape<dim>&);                                                                                     \
  template Real inertia_over_mass<dim>(const RigidShape<dim>&);                                                                            \
  template Vec<dim> center_of<dim>(const RigidShape<dim>&);                                                                                \
  template Real lowest_level<dim>(const RigidShape<dim>&);                                                                                 \
  template Real width_of<dim>(const RigidShape<dim>&);
BERM_INSTANTIATE(2)
BERM_INSTANTIATE(3)
#undef BERM_INSTANTIATE

}  // namespace berm::bodies
