// SPDX-License-Identifier: BSD-3-Clause
#include "contact/detect.hpp"

#include "bodies/particle_position.hpp"
#include "contact/strips.hpp"
#include "core/for_each.hpp"
#include "core/ranks.hpp"
#include "core/select.hpp"

namespace berm::contact {
namespace {

/// The cells that the surface, or the body behind it, can reach before it has moved by `reach` from the listed pose. They
/// follow from that pose alone, so that a resumed run lists the same ones.
template <int dim>
void find_near_cells(const mesh::Mesh<dim>& mesh, const bodies::RigidBody<dim>& rigid, const bodies::Pose<dim>& pose,
                     bodies::Pose<dim>& listed, Detection detection, ContactPoints<dim>& found)
{
  if (found.reach == 0) {
    found.reach = -largest_of("contact: near cells", mesh.cell_count(), -infinity, [&](Index cell) { return -mesh.height(cell); });
    found.near_index = CellField<Index>::zeros(mesh.cell_count());
  }
  if (!(distance_between(rigid, listed, pose) < found.reach)) listed = pose;
  if (found.listed == listed) return;
  found.listed = listed;
  for (Index cell : found.near_cells) found.near_index[cell] = 0;
  const bodies::RigidShape<dim> shape = placed(rigid, listed);
  for_each("contact: near cells", mesh.cell_count(), [&](Index cell) {
    const Vec<dim> center = mesh.centroid(cell);
    Real radius = 0;
    for (Index node : mesh.nodes[cell]) radius = std::max(radius, (mesh.position[node] - center).norm());
    if (surface_at(shape, center).distance < 2 * radius + found.reach) found.near_index[cell] = 1;
  });
  select(
      "contact: near cells", mesh.cell_count(), [&](Index cell) { return found.near_index[cell] != 0; }, found.near_cells);
  for (std::size_t k = 0; k < found.near_cells.size(); ++k) found.near_index[found.near_cells[k]] = static_cast<Index>(k) + 1;
  found.cells.resize(found.near_cells.size());
  if (detection == Detection::particle) {
    order_by_strips(mesh, found);
    reserve(found, lanes * static_cast<Index>(found.near_cells.size()));
    return;
  }
  found.near_nodes.clear();
  for (Index cell : found.near_cells) found.near_nodes.insert(found.near_nodes.end(), mesh.nodes[cell].begin(), mesh.nodes[cell].end());
  std::sort(found.near_nodes.begin(), found.near_nodes.end());
  found.near_nodes.erase(std::unique(found.near_nodes.begin(), found.near_nodes.end()), found.near_nodes.end());
  found.candidates.resize(found.near_nodes.size());
  found.kept.reserve(found.near_nodes.size());
  reserve(found, static_cast<Index>(found.near_nodes.size()));
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

/// The nodes of the cells in contact, each with the smallest gap of its cells.
template <int dim>
void list_nodes(const mesh::Mesh<dim>& mesh, const bodies::RigidShape<dim>& shape, Detection detection, const NodeField<Real>& mass,
                ContactPoints<dim>& found)
{
  const bool overlap = detection == Detection::overlap;
  const bool corners = bodies::has_corners<dim>(shape);
  for_each("contact: nodes", static_cast<Index>(found.near_nodes.size()), [&](Index k) {
    const Index node = found.near_nodes[k];
    ContactPoint<dim>& point = found.candidates[k];
    point = {};
    point.node_count = 0;
    if (mass[node] <= 0) return;
    for (Index e = mesh.first_entry[node]; e < mesh.first_entry[node + 1]; ++e) {
      const Index near = found.near_index[mesh.entries[e] / (dim + 1)];
      if (near == 0) continue;
      const auto& cell = found.cells[near - 1];
      if (overlap ? !cell.cut : !(cell.gap < infinity)) continue;
      const Real gap = overlap ? 0 : cell.gap;
      const bool first = point.node_count == 0;
      if (first) {
        point.nodes[0] = node;
        point.weights[0] = 1;
        point.node_count = 1;
        const bodies::SurfacePoint<dim> surface = surface_at(shape, mesh.position[node]);
        point.normal = surface.normal;
        point.position = mesh.position[node] - surface.distance * surface.normal;
        point.gap = gap;
        point.distance = infinity;
      }
      // Inside a shape with corners, the side nearest to a node may not be the one that the soil touches.
      if (corners && cell.gap < infinity && (first || gap < point.gap)) point.normal = cell.normal;
      point.gap = std::min(point.gap, gap);
      point.distance = std::min(point.distance, cell.distance);
      point.touching = point.touching || overlap || cell.gap < cell.half_width;
    }
  });
  keep_candidates(
      found, [&](const ContactPoint<dim>& point) { return point.node_count > 0 && (detection != Detection::distance || point.gap <= 0); });
}

/// Whether a particle's gap is less than its width: its distance from the surface less than one and a half of that, which needs no root.
template <int dim>
bool is_near(Real distance, Real section)
{
  const Real width = distance * (2. / 3);
  return width <= 0 || (dim == 2 ? width * width : width * width * width) < section;
}

/// The particles whose rims are nearer than their width.
template <int dim>
void list_particles(const mesh::Mesh<dim>& mesh, const bodies::Particles<dim>& particles, const bodies::RigidShape<dim>& shape,
                    ParticleRim rim, ContactPoints<dim>& found)
{
  found.strip_begin.clear();
  Index count = 0, begin = 0;
  for (Index end : found.first_near_cell) {
    for (Index k = begin; k < end; ++k) found.cells[k].first_point = count, count += found.cells[k].points;
    found.strip_begin.push_back(count);
    begin = end;
  }
  found.list.resize(static_cast<std::size_t>(count));
  for_each("contact: particles", static_cast<Index>(found.near_cells.size()), [&](Index k) {
    const Index cell = found.near_cells[k];
    if (found.cells[k].points == 0 || !Ranks::of_run().owns_cell(cell)) return;
    const mesh::Shape<dim> functions = mesh.shape(cell);
    Index at = found.cells[k].first_point;
    const Index end = at + found.cells[k].points;
    for (const auto& [p, b, in_block] : particles.blocks_in(cell))
      for (int l = 0; l < in_block && at < end; ++l) {
        const Vec<dim> x = position_of(p, l);
        const bodies::SurfacePoint<dim> surface = surface_at(shape, x);
        const Real section = section_of(mesh.metric, p.volume[l], x);
        if (!is_near<dim>(surface.distance, section)) continue;
        const Real half = half_width<dim>(section);
        ContactPoint<dim>& point = found.list[at++];
        point = {};
        point.gap = surface.distance - (rim == ParticleRim::whole ? half : half * rim_fraction(p.deviatoric_strain[l]));
        point.half_width = half;
        point.nodes = mesh.nodes[cell];
        for (int n = 0; n <= dim; ++n) point.weights[n] = functions.value(n, x);
        point.node_count = dim + 1;
        point.normal = surface.normal;
        point.position = x - surface.distance * surface.normal;
        point.distance = surface.distance;
        point.touching = surface.distance - half < half;
        point.block = b;
        point.lane = l;
      }
  });
}

/// Gets the points that are particles of other ranks.
template <int dim>
void share_particles(ContactPoints<dim>& found)
{
  Ranks& ranks = Ranks::of_run();
  if (!ranks.divided()) return;
  found.owner.resize(found.list.size());
  for (std::size_t k = 0; k < found.near_cells.size(); ++k)
    std::fill_n(found.owner.begin() + found.cells[k].first_point, found.cells[k].points, ranks.owner_of_cell(found.near_cells[k]));
  share_points<ContactPoint<dim>>(
      found, [](const ContactPoint<dim>& from, ContactPoint<dim>& value) { value = from; },
      [](const ContactPoint<dim>& value, ContactPoint<dim>& to) {
        to = value;
        to.block = none;
      });
}

}  // namespace

template <int dim>
void detect(const mesh::Mesh<dim>& mesh, const bodies::Particles<dim>& particles, const bodies::RigidBody<dim>& rigid,
            const bodies::Pose<dim>& pose, bodies::Pose<dim>& listed, Detection detection, ParticleRim rim, NodeField<Real>& mass,
            ContactPoints<dim>& found)
{
  const bodies::RigidShape<dim> shape = placed(rigid, pose);
  find_near_cells(mesh, rigid, pose, listed, detection, found);

  for_each("contact: distances", static_cast<Index>(found.near_cells.size()), [&](Index k) {
    const Index cell = found.near_cells[k];
    auto& result = found.cells[k];
    result = {};
    for (const auto& [p, b, count] : particles.blocks_in(cell))
      for (int l = 0; l < count; ++l) {
        const Vec<dim> x = position_of(p, l);
        const bodies::SurfacePoint<dim> surface = surface_at(shape, x);
        result.distance = std::min(result.distance, surface.distance);
        const Real section = section_of(mesh.metric, p.volume[l], x);
        const bool near = is_near<dim>(surface.distance, section);
        result.points += near ? 1 : 0;
        if (detection == Detection::particle && !near) continue;
        const Real half = half_width<dim>(section), gap = surface.distance - half;
        if (gap < result.gap) result.gap = gap, result.normal = surface.normal, result.half_width = half;
      }
    if (detection == Detection::overlap) result.cut = reaches_into(shape, mesh, cell);
  });

  Ranks& ranks = Ranks::of_run();
  ranks.share<typename ContactPoints<dim>::CellContact>(
      static_cast<Index>(found.near_cells.size()), [&](Index k) { return ranks.owner_of_cell(found.near_cells[k]); },
      [&](Index k, auto& cell) { cell = found.cells[k]; }, [&](Index k, const auto& cell) { found.cells[k] = cell; });
  found.nearest_particle = infinity;
  for (const auto& cell : found.cells) found.nearest_particle = std::min(found.nearest_particle, cell.distance);
  if (detection == Detection::particle) {
    list_particles(mesh, particles, shape, rim, found);
    share_particles(found);
    return;
  }
  ranks.share<Real>(
      static_cast<Index>(found.near_nodes.size()), [&](Index k) { return ranks.owner_of_node(found.near_nodes[k]); },
      [&](Index k, Real& m) { m = mass[found.near_nodes[k]]; }, [&](Index k, Real m) { mass[found.near_nodes[k]] = m; });
  list_nodes(mesh, shape, detection, mass, found);
}

#define BERM_INSTANTIATE(dim)                                                                                                              \
  template void detect(const mesh::Mesh<dim>&, const bodies::Particles<dim>&, const bodies::RigidBody<dim>&, const bodies::Pose<dim>&,     \
                       bodies::Pose<dim>&, Detection, ParticleRim, NodeField<Real>&, ContactPoints<dim>&);
BERM_INSTANTIATE(2)
BERM_INSTANTIATE(3)
#undef BERM_INSTANTIATE

}  // namespace berm::contact
