// SPDX-License-Identifier: BSD-3-Clause
#include "problem/symmetry.hpp"

#include "os/error.hpp"
#include "problem/supports.hpp"
#include "settings/symmetry.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::problem {
namespace {

constexpr Real round_off = 1e-9;
/// Difference of distances at points that mirror each other, over the reach of the body, that a surface of triangles may have: a tilt of half a degree makes one.
constexpr Real of_triangles = 0.01;

/// The largest difference of a shape's distances from points around it and their mirror images across an axis through its centre, over its reach.
template <int dim>
Real asymmetry(const bodies::RigidShape<dim>& shape, int axis)
{
  constexpr int a_side = 6;
  const Vec<dim> center = center_of<dim>(shape);
  const Real reach = reach_of<dim>(shape);
  Real largest = 0;
  for (int n = 0; n < a_side * a_side * a_side; ++n) {
    Vec<dim> from;
    for (int d = 0, digits = n; d < dim; ++d, digits /= a_side)
      from[d] = reach * (2.4 * ((digits % a_side) + 0.5 + 0.1 * d) / a_side - 1.2);  // in no plane of symmetry
    Vec<dim> mirrored = from;
    mirrored[axis] *= -1;
    largest =
        std::max(largest, std::abs(surface_at<dim>(shape, center + from).distance - surface_at<dim>(shape, center + mirrored).distance));
  }
  return largest / reach;
}

}  // namespace

template <int dim>
void hold_symmetry_planes(const settings::Case& c, Model<dim>& model)
{
  const mesh::Mesh<dim>& mesh = model.mesh;
  for (int d = 0; d < dim; ++d) {
    model.mirrored[d] = mirrors(c, d);
    if (!model.mirrored[d]) continue;
    const Real plane = mesh.lower[d] + round_off * (mesh.upper[d] - mesh.lower[d]);
    add_condition<dim>(
        held_across(d, model), [&](Index node) { return mesh.position[node][d] <= plane; }, model);
  }
}

template <int dim>
void refuse_off_symmetry_planes(const Model<dim>& model)
{
  for (int d = 0; d < dim; ++d) {
    if (!model.mirrored[d]) continue;
    for (const bodies::RigidBody<dim>& rigid : model.rigid_bodies) {
      if (!bodies::is_bounded<dim>(rigid.shape)) {
        const auto* half = std::get_if<bodies::HalfPlane<dim>>(&rigid.shape);
        if (half != nullptr && half->normal[d] != 0)
          throw KeyError(
              fmt::format("rigid.{}.normal: is inclined to the plane of symmetry: its {} must be 0", rigid.name, settings::axis_names[d]));
        continue;
      }
      const Real center = center_of<dim>(rigid.shape)[d], plane = model.mesh.lower[d];
      if (std::abs(center - plane) > round_off * (model.mesh.upper[d] - plane))
        throw KeyError(fmt::format("rigid.{0}.center: lies at {1} = {2:.6g} m, and the plane of symmetry is where the mesh begins, {1} = "
                                   "{3:.6g} m: move the centre onto it, or the mesh",
                                   rigid.name, settings::axis_names[d], center, plane));
      const bool of_file = std::holds_alternative<bodies::Triangulated<dim>>(rigid.shape);
      const Real rounding = round_off + 4 * std::numeric_limits<Real>::epsilon() * center_of<dim>(rigid.shape).cwiseAbs().maxCoeff() /
                                            reach_of<dim>(rigid.shape);
      if (asymmetry<dim>(rigid.shape, d) > (of_file ? of_triangles : rounding))
        throw KeyError(
            fmt::format("rigid.{0}: is not its own mirror image across the plane of symmetry {1} = {2:.6g} m: rotate it, or leave "
                        "\"{1}\" out of symmetry",
                        rigid.name, settings::axis_names[d], plane));
    }
  }
}

template <int dim>
void measure_around_axis(const settings::Case& c, mesh::Mesh<dim>& mesh)
{
  if (c.geometry != settings::Geometry::axisymmetric) return;
  mesh.metric = mesh::Metric::axisymmetric;
  const Real width = mesh.upper[0] - mesh.lower[0];
  if (mesh.lower[0] < -round_off * width)
    throw KeyError(fmt::format("mesh: reaches to x = {:.6g} m; around an axis x is the radius, which is not less than 0", mesh.lower[0]));
  for (Vec<dim>& x : mesh.position)
    if (std::abs(x[0]) <= round_off * width) x[0] = 0;
  mesh.lower[0] = std::max(mesh.lower[0], Real(0));
}

template <int dim>
void hold_axis(Model<dim>& model)
{
  if (model.mesh.metric != mesh::Metric::axisymmetric) return;
  add_condition<dim>(
      held_across(0, model), [&](Index node) { return model.mesh.position[node][0] == 0; }, model);
}

#define BERM_INSTANTIATE(dim)                                                                                                              \
  template void hold_symmetry_planes(const settings::Case&, Model<dim>&);                                                                  \
  template void refuse_off_symmetry_planes(const Model<dim>&);                                                                             \
  template void measure_around_axis(const settings::Case&, mesh::Mesh<dim>&);                                                              \
  template void hold_axis(Model<dim>&);
BERM_INSTANTIATE(2)
BERM_INSTANTIATE(3)
#undef BERM_INSTANTIATE

}  // namespace berm::problem
