// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/mpm/cut_cells_test.cpp
#include "mpm/cut_cells.hpp"

namespace berm::mpm {
namespace {

constexpr Real min_remaining_fraction = 0.25;  // of the cells around a node
constexpr Real fraction_with_particles = 0.5;
constexpr Real on_surface = 1e-6;  // of the size of a cell: a node so near lies on the surface

template <int dim>
bool touches(const problem::Contact& contact, Index b)
{
  return contact.body == b && contact.rigid != none;
}

/// Whether a rigid body has moved since the cut cells were found; notes where they are.
template <int dim>
bool have_moved(const problem::Model<dim>& model, const problem::State<dim>& state, Index b, CutCells<dim>& cut)
{
  bool moved = false;
  for (std::size_t k = 0; k < model.contacts.size(); ++k) {
    if (!touches<dim>(model.contacts[k], b)) continue;
    const bodies::Pose<dim>& pose = state.rigid_bodies[model.contacts[k].rigid];
    moved = moved || !(cut.poses[k] == pose);
    cut.poses[k] = pose;
  }
  return moved;
}

template <int dim>
void find_distances(const problem::Model<dim>& model, const problem::State<dim>& state, Index b, CutCells<dim>& cut)
{
  const mesh::Mesh<dim>& mesh = model.mesh;
  bool first = true;
  for (const problem::Contact& contact : model.contacts) {
    if (!touches<dim>(contact, b)) continue;
    const bodies::RigidShape<dim> shape = placed<dim>(model.rigid_bodies[contact.rigid], state.rigid_bodies[contact.rigid]);
    for_each("cut cells", mesh.node_count(), [&](Index node) {
      const Real distance = surface_at(shape, mesh.position[node]).distance;
      cut.distance[node] = first ? distance : std::min(cut.distance[node], distance);
    });
    first = false;
  }
}

template <int dim>
void find_parts(const mesh::Mesh<dim>& mesh, CutCells<dim>& cut)
{
  for_each("cut cells", mesh.cell_count(), [&](Index cell) {
    std::array<Real, dim + 1> distance;
    for (int k = 0; k <= dim; ++k) distance[k] = cut.distance[mesh.nodes[cell][k]];
    cut.parts[cell].cut = false;
    if (std::all_of(distance.begin(), distance.end(), [](Real d) { return d >= 0; })) return;
    const Real near = on_surface * mesh.size(cell);
    for (Real& d : distance) d = std::abs(d) < near ? 0 : d;
    cut.parts[cell] = positive_part(mesh, cell, distance);
  });
  for_each("cut cells", mesh.node_count(), [&](Index node) {
    bool any = false;
    Real left = 0;
    for (Index e = mesh.first_entry[node]; e < mesh.first_entry[node + 1]; ++e) {
      const Index cell = mesh.entries[e] / (dim + 1);
      any = any || cut.parts[cell].cut;
      left += cut.parts[cell].cut ? cut.parts[cell].volume : mesh.volume(cell);
    }
    cut.volume_around[node] = any ? left : infinity;
  });
}

/// Filled fraction of what is left of the cells around a node.
template <int dim>
Real fill_of_rest(const mesh::Mesh<dim>& mesh, const BodyGrid<dim>& grid, Index node)
{
  const Real left = grid.cut.volume_around[node];
  if (!(left > min_remaining_fraction * grid.volume_around[node])) return 1;
  Real filled = 0;
  for (Index e = mesh.first_entry[node]; e < mesh.first_entry[node + 1]; ++e) {
    const Index cell = mesh.entries[e] / (dim + 1);
    const Real volume = grid.at(mesh.entries[e]).volume;
    const mesh::CellPart<dim>& part = grid.cut.parts[cell];
    if (!(volume > 0) && !(part.cut && part.volume < fraction_with_particles * grid.volume[cell])) return 0;
    filled += volume;
  }
  return filled / left;
}

}  // namespace

template <int dim>
void find_cut_cells(const problem::Model<dim>& model, const problem::State<dim>& state, Index b, BodyGrid<dim>& grid)
{
  if (!grid.cut.used()) return;
  if (have_moved(model, state, b, grid.cut)) {
    find_distances(model, state, b, grid.cut);
    find_parts(model.mesh, grid.cut);
  }
  for_each("cut cells: fill", grid.chunks, [&](Index n) {
    const Index node = grid.nodes[n];
    if (grid.cut.volume_around[node] < infinity) grid.fill[node] = fill_of_rest(model.mesh, grid, node);
  });
}

template void find_cut_cells(const problem::Model<2>&, const problem::State<2>&, Index, BodyGrid<2>&);
template void find_cut_cells(const problem::Model<3>&, const problem::State<3>&, Index, BodyGrid<3>&);

}  // namespace berm::mpm
