// SPDX-License-Identifier: BSD-3-Clause
#include "contact/detect.hpp"

#include "core/for_each.hpp"

namespace berm {
namespace {

/// The cells that the surface, or the body behind it, can reach before it has moved by `reach`.
template <int dim>
void find_near_cells(const Mesh<dim>& mesh, const RigidShape<dim>& shape, const Vec<dim>& displacement, ContactNodes<dim>& found)
{
  if (found.place.size() == 0) {
    found.place.assign(mesh.node_count(), none);
    Real least = infinity;
    for (Real height : mesh.height) least = std::min(least, height);
    found.reach = least;
  }
  if ((displacement - found.near_at).norm() < found.reach) return;
  found.near_at = displacement;
  found.near_cells.clear();
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
    const Vec<dim> center = mesh.centroid(cell);
    Real radius = 0;
    for (Index node : mesh.nodes[cell]) radius = std::max(radius, (mesh.position[node] - center).norm());
    if (surface_at(shape, center).distance < 2 * radius + found.reach) found.near_cells.push_back(cell);
  }
  found.cells.resize(found.near_cells.size());
  found.list.reserve(static_cast<std::size_t>(dim + 1) * found.near_cells.size());
}

/// Whether the body reaches into a cell, tried at its corners and at the quarter points of its edges.
template <int dim>
bool reaches_into(const RigidShape<dim>& shape, const Mesh<dim>& mesh, Index cell)
{
  const auto& nodes = mesh.nodes[cell];
  for (int a = 0; a <= dim; ++a)
    for (int b = a; b <= dim; ++b)
      for (const Real t : {0., 0.25, 0.5, 0.75})
        if (surface_at<dim>(shape, mesh.position[nodes[a]] * (1 - t) + mesh.position[nodes[b]] * t).distance < 0) return true;
  return false;
}

template <int dim>
Real half_width(Real volume)
{
  return 0.5 * (dim == 2 ? std::sqrt(volume) : std::cbrt(volume));
}

}  // namespace

template <int dim>
void detect(const Mesh<dim>& mesh, const Particles<dim>& particles, const Rigid<dim>& rigid, const RigidState<dim>& state,
            Detection detection, const NodeField<Real>& mass, ContactNodes<dim>& found)
{
  const RigidShape<dim> shape = placed<dim>(rigid, state);
  find_near_cells(mesh, shape, state.displacement, found);

  for_each("contact: distances", static_cast<Index>(found.near_cells.size()), [&](Index k) {
    const Index cell = found.near_cells[k];
    auto& result = found.cells[k];
    result = {};
    Index left = particles.count_in(cell);
    for (Index b = particles.first_block(cell); left > 0; b = particles.block(b).next, left -= lanes) {
      const Block<dim>& p = particles.block(b);
      for (int l = 0; l < lanes && l < left; ++l) {
        Vec<dim> x;
        for (int d = 0; d < dim; ++d) x[d] = p.x[d][l];
        const SurfacePoint<dim> surface = surface_at(shape, x);
        const Real half = half_width<dim>(p.volume[l]), gap = surface.distance - half;
        result.distance = std::min(result.distance, surface.distance);
        if (gap < result.gap) result.gap = gap, result.normal = surface.normal, result.half_width = half;
      }
    }
    if (detection == Detection::overlap) result.cut = reaches_into(shape, mesh, cell);
  });

  for (const ContactNode<dim>& contact : found.list) found.place[contact.node] = none;
  found.list.clear();
  found.nearest_particle = infinity;
  const bool has_corners = std::holds_alternative<Box<dim>>(shape) || std::holds_alternative<Polygon<dim>>(shape);
  for (std::size_t k = 0; k < found.near_cells.size(); ++k) {
    const auto& cell = found.cells[k];
    found.nearest_particle = std::min(found.nearest_particle, cell.distance);
    const bool touches = detection == Detection::overlap ? cell.cut : cell.gap < infinity;
    if (!touches) continue;
    for (Index node : mesh.nodes[found.near_cells[k]]) {
      if (mass[node] <= 0) continue;
      const Real gap = detection == Detection::overlap ? 0 : cell.gap;
      Index& place = found.place[node];
      const bool first = place == none;
      if (first) {
        place = static_cast<Index>(found.list.size());
        found.list.push_back({node, surface_at(shape, mesh.position[node]).normal, gap, infinity, false});
      }
      ContactNode<dim>& contact = found.list[place];
      // Inside a shape with corners the side that is nearest to a node says nothing of the side that the soil touches.
      if (has_corners && cell.gap < infinity && (first || gap < contact.gap)) contact.normal = cell.normal;
      contact.gap = std::min(contact.gap, gap);
      contact.distance = std::min(contact.distance, cell.distance);
      contact.touching = contact.touching || detection == Detection::overlap || cell.gap < cell.half_width;
    }
  }
}

#define BERM_INSTANTIATE(dim)                                                                                                              \
  template void detect(const Mesh<dim>&, const Particles<dim>&, const Rigid<dim>&, const RigidState<dim>&, Detection,                      \
                       const NodeField<Real>&, ContactNodes<dim>&);
BERM_INSTANTIATE(2)
BERM_INSTANTIATE(3)
#undef BERM_INSTANTIATE

}  // namespace berm
