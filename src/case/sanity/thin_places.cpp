// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/sanity/thin_questions_test.cpp
#include "sanity/thin_places.hpp"

#include <memory>

namespace berm::sanity {
namespace {

template <int dim>
Vec<dim> vec_of(const Place& place)
{
  Vec<dim> x;
  for (int d = 0; d < dim; ++d) x[d] = place[d];
  return x;
}
template <int dim>
Place place_of(const Vec<dim>& x)
{
  Place place = {};
  for (int d = 0; d < dim; ++d) place[d] = x[d];
  return place;
}

/// The cell at a point; none outside the mesh.
template <int dim>
Index cell_at(const mesh::Mesh<dim>& mesh, const Vec<dim>& x, Index& start)
{
  if ((x.array() < mesh.lower.array()).any() || (x.array() > mesh.upper.array()).any()) return none;
  const mesh::Location place = locate(mesh, x, start);
  if (!place.inside) return none;
  return start = place.cell;
}

/// Length of a cell along a unit vector n, m: the root of the sum of (e n)^2 over its edges e, over what the half of a square (the sixth of a cube) of edge 1 has at most along its own edges: 2 (4).
template <int dim>
Real length_along(const mesh::Mesh<dim>& mesh, Index cell, const Vec<dim>& n)
{
  Real sum = 0;
  for (int a = 0; a <= dim; ++a)
    for (int b = 0; b < a; ++b) sum += std::pow((mesh.position[mesh.nodes[cell][a]] - mesh.position[mesh.nodes[cell][b]]).dot(n), 2);
  return std::sqrt(sum / (dim == 2 ? 2 : 4));
}

/// From a point of the surface into the body to where it ends: the thickness, and the normal there.
template <int dim>
std::pair<Real, Vec<dim>> across(const bodies::RigidShape<dim>& shape, const Vec<dim>& x, const Vec<dim>& normal, Real size)
{
  const Real least = 1e-5 * size;
  for (Real depth = least; depth < 4 * size;) {
    const bodies::SurfacePoint<dim> at = surface_at<dim>(shape, Vec<dim>(x - depth * normal));
    if (at.distance >= 0) return {depth - at.distance, at.normal};
    depth += std::max(least, -at.distance);
  }
  return {infinity, normal};
}

/// The points of a lattice around the body, each moved to the nearest point of the surface: visit(x, normal).
template <int dim, class Visit>
void for_each_surface_point(const bodies::RigidShape<dim>& shape, const mesh::Mesh<dim>& mesh, bool endless, const Visit& visit)
{
  constexpr Index points = dim == 2 ? 60 : 24, layers = 3;  // along an axis; of a body that is the same all along z
  Vec<dim> lower, step;
  std::array<Index, dim> count;
  for (int d = 0; d < dim; ++d) {
    const Vec<dim> axis = Vec<dim>::Unit(d);
    const bool same = dim == 3 && d == 2 && endless;
    lower[d] = same ? mesh.lower[d] : lowest_level<dim>(shape, axis);
    const Real upper = same ? mesh.upper[d] : -lowest_level<dim>(shape, Vec<dim>(-axis));
    count[d] = same ? layers : points;
    step[d] = (upper - lower[d]) / static_cast<Real>(count[d]);
  }
  Index all = 1;
  for (const Index n : count) all *= n;
  for (Index k = 0; k < all; ++k) {
    Vec<dim> x = lower;
    Index rest = k;
    for (int d = 0; d < dim; ++d, rest /= count[d - 1]) x[d] += (static_cast<Real>(rest % count[d]) + 0.5) * step[d];
    const bodies::SurfacePoint<dim> at = surface_at<dim>(shape, x);
    if (std::abs(at.distance) < step.norm()) visit(Vec<dim>(x - at.distance * at.normal), at.normal);
  }
}

template <int dim>
std::vector<ThinPlace> thin_places_of(const problem::Model<dim>& model, const bodies::RigidShape<dim>& shape, bool endless)
{
  constexpr Real facing = -0.7;  // n1 n2 of faces that look away from each other
  std::vector<ThinPlace> places;
  if (!bodies::is_bounded<dim>(shape)) return places;
  const Real size = reach_of<dim>(shape);
  for_each_surface_point(shape, model.mesh, endless, [&](const Vec<dim>& x, const Vec<dim>& normal) {
    const auto [thickness, opposite] = across(shape, x, normal, size);
    if (!(thickness < infinity) || opposite.dot(normal) > facing) return;
    Vec<dim> arm = x - center_of<dim>(shape);
    if (endless && dim == 3) arm[dim - 1] = 0;
    places.push_back({place_of<dim>(x), place_of<dim>(normal), thickness, (arm - arm.dot(normal) * normal).norm()});
  });
  return places;
}

}  // namespace

template <int dim>
void look_for_thin_places(const problem::Model<dim>& model, const std::vector<std::vector<Index>>& cells, Scene& scene)
{
  const auto start = std::make_shared<Index>(0);
  scene.cell_along = [&model, start](const Place& place, const Place& along) {
    const Index cell = cell_at<dim>(model.mesh, vec_of<dim>(place), *start);
    return cell == none ? nan : length_along<dim>(model.mesh, cell, vec_of<dim>(along));
  };
  std::vector<std::vector<char>> takes(cells.size(), std::vector<char>(static_cast<std::size_t>(model.mesh.cell_count()), 0));
  for (std::size_t b = 0; b < cells.size(); ++b)
    for (const Index cell : cells[b]) takes[b][static_cast<std::size_t>(cell)] = 1;
  scene.soil_at = [&model, start, takes = std::move(takes)](Index body, const Place& place) {
    const Index cell = cell_at<dim>(model.mesh, vec_of<dim>(place), *start);
    return cell != none && takes[static_cast<std::size_t>(body)][static_cast<std::size_t>(cell)] != 0;
  };
  scene.distance = [&model](Index rigid, const Place& place) {
    return surface_at<dim>(model.rigid_bodies[rigid].shape, vec_of<dim>(place)).distance;
  };
  scene.thin_places = [&model, &c = scene.c](Index rigid) {
    return thin_places_of<dim>(model, model.rigid_bodies[rigid].shape, bodies::is_endless(c.rigid[rigid].second.shape));
  };
}

template void look_for_thin_places(const problem::Model<2>&, const std::vector<std::vector<Index>>&, Scene&);
template void look_for_thin_places(const problem::Model<3>&, const std::vector<std::vector<Index>>&, Scene&);

}  // namespace berm::sanity
