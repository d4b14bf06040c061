// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/problem/cells_at_body_test.cpp
#include "problem/cells_at_body.hpp"

#include <numbers>

namespace berm::problem {
namespace {

constexpr int points = 24;  // along the lower half of the surface

/// The nearest point of the surface to one of a circle around the body, in the plane of the travel; in space in the middle of the mesh where the body has no end.
template <int dim>
Vec<dim> point_at(const Model<dim>& model, const bodies::RigidShape<dim>& shape, Real angle)
{
  const Axes<dim>& axes = model.axes;
  Vec<dim> x = center_of<dim>(shape);
  for (int d = 0; d < dim; ++d)
    if (d != axes.up && d != axes.along && (x[d] <= model.mesh.lower[d] || x[d] >= model.mesh.upper[d]))
      x[d] = (model.mesh.lower[d] + model.mesh.upper[d]) / 2;
  const Real radius = reach_of<dim>(shape);
  x[axes.along] += radius * std::cos(angle);
  x[axes.up] -= axes.sign * radius * std::sin(angle);
  const bodies::SurfacePoint<dim> nearest = surface_at<dim>(shape, x);
  constexpr Real outside = 0.02;  // of its size: within the body finite elements have no cells
  return x - (nearest.distance - outside * radius) * nearest.normal;
}

}  // namespace

template <int dim>
Real cell_size_at(const Model<dim>& model, const bodies::RigidShape<dim>& shape, Index& start)
{
  Real largest = nan;
  if (!bodies::is_bounded<dim>(shape)) return largest;
  const Axes<dim>& axes = model.axes;
  constexpr Real of_width = 0.55;  // half of it, and what point_at keeps off the surface
  const Real bed = axes.sign * model.surface_at(center_of<dim>(shape)), lowest = bodies::lowest_level<dim>(shape, axes.up_vector());
  const Real in_the_air = std::max(bed, lowest) + of_width * width_of<dim>(shape);
  for (int k = 0; k <= points; ++k) {
    const Vec<dim> x = point_at(model, shape, std::numbers::pi * k / points);
    if ((x.array() < model.mesh.lower.array()).any() || (x.array() > model.mesh.upper.array()).any() || axes.height(x) > in_the_air)
      continue;
    const mesh::Location found = locate(model.mesh, x, start);
    if (!found.inside) continue;
    start = found.cell;
    const Real size = model.mesh.size(found.cell);
    if (!(size <= largest)) largest = size;
  }
  return largest;
}

template <int dim>
std::string region_below(const Model<dim>& model, const bodies::RigidShape<dim>& shape, Real depth)
{
  if (!bodies::is_bounded<dim>(shape)) return "";
  const Axes<dim>& axes = model.axes;
  constexpr Real below = 0.02;  // of its size
  Vec<dim> x = point_at(model, shape, std::numbers::pi / 2);
  x[axes.up] = model.surface_at(center_of<dim>(shape)) - axes.sign * (depth + below * reach_of<dim>(shape));
  return region_at(model, x);
}

template <int dim>
std::string region_at(const Model<dim>& model, const Vec<dim>& x)
{
  if ((x.array() < model.mesh.lower.array()).any() || (x.array() > model.mesh.upper.array()).any()) return "";
  const mesh::Location found = locate(model.mesh, x, 0);
  return found.inside ? model.mesh.region_names[static_cast<std::size_t>(model.mesh.region[found.cell])] : "";
}

template std::string region_at(const Model<2>&, const Vec<2>&);
template std::string region_at(const Model<3>&, const Vec<3>&);
template std::string region_below(const Model<2>&, const bodies::RigidShape<2>&, Real);
template std::string region_below(const Model<3>&, const bodies::RigidShape<3>&, Real);
template Real cell_size_at(const Model<2>&, const bodies::RigidShape<2>&, Index&);
template Real cell_size_at(const Model<3>&, const bodies::RigidShape<3>&, Index&);

}  // namespace berm::problem
