// SPDX-License-Identifier: BSD-3-Clause
#include "contact/detect.hpp"

#include "core/for_each.hpp"

namespace berm::contact {
namespace {

/// The cells that the surface, or the body behind it, can reach before it has moved by `reach` from the listed pose. They
/// follow from the state alone, so that a resumed run lists the same ones.
template <int dim>
void find_near_cells(const mesh::Mesh<dim>& mesh, const bodies::RigidBody<dim>& rigid, bodies::RigidState<dim>& state,
                     ContactPoints<dim>& found)
{
  if (found.reach == 0) {
    Real min = infinity;
    for (Index cell = 0; cell < mesh.cell_count(); ++cell) min = std::min(min, mesh.height(cell));
    found.reach = min;
  }
  const Real moved = (state.displacement - state.near_cells_displacement).norm() +
                     angle_between(state.orientation, state.near_cells_orientation) * reach_of<dim>(rigid.shape);
  if (!(moved < found.reach)) {
    state.near_cells_displacement = state.displacement;
    state.near_cells_orientation = state.orientation;
  }
  if (found.near_displacement == state.near_cells_displacement && found.near_orientation == state.near_cells_orientation) return;
  found.near_displacement = state.near_cells_displacement;
  found.near_orientation = state.near_cells_orientation;
  found.near_cells.clear();
  bodies::RigidState<dim> then;
  then.displacement = state.near_cells_displacement;
  then.orientation = state.near_cells_orientation;
  const bodies::RigidShape<dim> shape = placed<dim>(rigid, then);
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
    const Vec<dim> center = mesh.centroid(cell);
    Real radius = 0;
    for (Index node : mesh.nodes[cell]) radius = std::max(radius, (mesh.position[node] - center).norm());
    if (surface_at(shape, center).distance < 2 * radius + found.reach) found.near_cells.push_back(cell);
  }
  found.cells.resize(found.near_cells.size());
  found.list.reserve(static_cast<std::size_t>(lanes) * found.near_cells.size());
}

/// Whether the body intersects a cell, tested at its corners and at the quarter points of its edges.
template <int dim>
bool reaches_into(const bodies::RigidShape<dim>& shape, const mesh::Mesh<dim>& mesh, Index cell)
{
  const auto& nodes = mesh.nodes[cell];
  for (int a = 0; a <= dim; ++a)
    for (int b = a; b <= dim; ++b)
      for (const Real t : {0., 0.25, 0.5, 0.75})
        if (surface_at<dim>(shape, mesh.position[nodes[a]] * (1 - t) + mesh.position[nodes[b]] * t).distance < 0) return true;
  return false;
}

/// The nodes of the cells in contact, each once, with the smallest gap of their cells.
template <int dim>
void list_nodes(const mesh::Mesh<dim>& mesh, const bodies::RigidShape<dim>& shape, Detection detection, const NodeField<Real>& mass,
                ContactPoints<dim>& found)
{
  if (found.point_of_node.size() == 0) found.point_of_node.assign(mesh.node_count(), none);
  const bool overlap = detection == Detection::overlap;
  const bool corners = bodies::has_corners<dim>(shape);
  for (std::size_t k = 0; k < found.near_cells.size(); ++k) {
    const auto& cell = found.cells[k];
    if (overlap ? !cell.cut : !(cell.gap < infinity)) continue;
    for (Index node : mesh.nodes[found.near_cells[k]]) {
      if (mass[node] <= 0) continue;
      const Real gap = overlap ? 0 : cell.gap;
      Index& index = found.point_of_node[node];
      const bool first = index == none;
      if (first) {
        index = static_cast<Index>(found.list.size());
        ContactPoint<dim> point;
        point.nodes[0] = node;
        point.weights[0] = 1;
        const bodies::SurfacePoint<dim> surface = surface_at(shape, mesh.position[node]);
        point.normal = surface.normal;
        point.position = mesh.position[node] - surface.distance * surface.normal;
        point.gap = gap;
        point.distance = infinity;
        found.list.push_back(point);
      }
      ContactPoint<dim>& point = found.list[index];
      // Inside a shape with corners, the side nearest to a node may not be the one that the soil touches.
      if (corners && cell.gap < infinity && (first || gap < point.gap)) point.normal = cell.normal;
      point.gap = std::min(point.gap, gap);
      point.distance = std::min(point.distance, cell.distance);
      point.touching = point.touching || overlap || cell.gap < cell.half_width;
    }
  }
  for (const ContactPoint<dim>& point : found.list) found.point_of_node[point.nodes[0]] = none;
  if (detection == Detection::distance) std::erase_if(found.list, [](const ContactPoint<dim>& point) { return point.gap > 0; });
}

/// The particles whose gap is less than their width; cells without any are skipped by their smallest gap.
template <int dim>
void list_particles(const mesh::Mesh<dim>& mesh, const bodies::Particles<dim>& particles, const bodies::RigidShape<dim>& shape,
                    ContactPoints<dim>& found)
{
  for (std::size_t k = 0; k < found.near_cells.size(); ++k) {
    const Index cell = found.near_cells[k];
    if (!(found.cells[k].gap < 2 * found.cells[k].half_width)) continue;
    const mesh::Shape<dim> functions = mesh.shape(cell);
    Index left = particles.count_in(cell);
    for (Index b = particles.first_block(cell); left > 0; b = particles.block(b).next, left -= lanes)
      for (int l = 0; l < lanes && l < left; ++l) {
        const bodies::Block<dim>& p = particles.block(b);
        ContactPoint<dim> point;
        Vec<dim> x;
        for (int d = 0; d < dim; ++d) x[d] = p.x[d][l];
        const bodies::SurfacePoint<dim> surface = surface_at(shape, x);
        const Real half = half_width<dim>(p.volume[l]);
        point.gap = surface.distance - half;
        if (!(point.gap < 2 * half)) continue;
        point.nodes = mesh.nodes[cell];
        for (int n = 0; n <= dim; ++n) point.weights[n] = functions.value(n, x);
        point.node_count = dim + 1;
        point.normal = surface.normal;
        point.position = x - surface.distance * surface.normal;
        point.distance = surface.distance;
        point.touching = point.gap < half;
        point.block = b;
        point.lane = l;
        found.list.push_back(point);
      }
  }
}

}  // namespace

template <int dim>
void detect(const mesh::Mesh<dim>& mesh, const bodies::Particles<dim>& particles, const bodies::RigidBody<dim>& rigid,
            bodies::RigidState<dim>& state, Detection detection, const NodeField<Real>& mass, ContactPoints<dim>& found)
{
  const bodies::RigidShape<dim> shape = placed<dim>(rigid, state);
  find_near_cells(mesh, rigid, state, found);

  for_each("contact: distances", static_cast<Index>(found.near_cells.size()), [&](Index k) {
    const Index cell = found.near_cells[k];
    auto& result = found.cells[k];
    result = {};
    Index left = particles.count_in(cell);
    for (Index b = particles.first_block(cell); left > 0; b = particles.block(b).next, left -= lanes) {
      const bodies::Block<dim>& p = particles.block(b);
      for (int l = 0; l < lanes && l < left; ++l) {
        Vec<dim> x;
        for (int d = 0; d < dim; ++d) x[d] = p.x[d][l];
        const bodies::SurfacePoint<dim> surface = surface_at(shape, x);
        const Real half = half_width<dim>(p.volume[l]), gap = surface.distance - half;
        result.distance = std::min(result.distance, surface.distance);
        if (gap < result.gap) result.gap = gap, result.normal = surface.normal, result.half_width = half;
      }
    }
    if (detection == Detection::overlap) result.cut = reaches_into(shape, mesh, cell);
  });

  found.list.clear();
  found.nearest_particle = infinity;
  for (const auto& cell : found.cells) found.nearest_particle = std::min(found.nearest_particle, cell.distance);
  if (detection == Detection::particle)
    list_particles(mesh, particles, shape, found);
  else
    list_nodes(mesh, shape, detection, mass, found);
}

#define BERM_INSTANTIATE(dim)                                                                                                              \
  template void detect(const mesh::Mesh<dim>&, const bodies::Particles<dim>&, const bodies::RigidBody<dim>&, bodies::RigidState<dim>&,     \
                       Detection, const NodeField<Real>&, ContactPoints<dim>&);
BERM_INSTANTIATE(2)
BERM_INSTANTIATE(3)
#undef BERM_INSTANTIATE

}  // namespace berm::contact
