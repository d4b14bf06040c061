// SPDX-License-Identifier: BSD-3-Clause
#include "run_folder/rigid_surface.hpp"

namespace berm::run_folder {

template <int dim>
RigidSurface<dim> surface_of(const bodies::RigidShape<dim>& shape, const Vec<dim>& lower, const Vec<dim>& upper)
{
  using Kind = typename bodies::SurfaceMesh<dim>::Kind;
  bodies::SurfaceMesh<dim> mesh = std::visit([&](const auto& s) { return surface_mesh<dim>(s, lower, upper); }, shape);
  RigidSurface<dim> surface{std::move(mesh.points), {}};
  for (auto& cell : mesh.cells) {
    const io::VtkCell type = cell.kind == Kind::line      ? io::VtkCell::line
                             : cell.kind == Kind::polygon ? io::VtkCell::polygon
                             : cell.kind == Kind::quad    ? io::VtkCell::quad
                                                          : io::VtkCell::hexahedron;
    surface.cells.push_back({type, std::move(cell.points)});
  }
  return surface;
}

template RigidSurface<2> surface_of<2>(const bodies::RigidShape<2>&, const Vec<2>&, const Vec<2>&);
template RigidSurface<3> surface_of<3>(const bodies::RigidShape<3>&, const Vec<3>&, const Vec<3>&);

}  // namespace berm::run_folder
