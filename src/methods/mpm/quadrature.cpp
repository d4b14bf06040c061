// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/quadrature.hpp"

#include "mpm/exchange.hpp"
#include "mpm/linear_field.hpp"
#include "mpm/small_mass_nodes.hpp"

namespace berm::mpm {
namespace {

/// Bounds of the filled fraction of the cells around a node: at a free surface at most, within a body at least. A level
/// surface of full cells has 0.5, one that cuts them at half their height 0.75.
constexpr Real surface_fill = 0.75, full_fill = 0.9;

/// Of the volume of its particles: a cell of which a rigid body leaves less is integrated over them.
constexpr Real min_fraction = 0.25;

/// The smallest filled fraction around the nodes of a cell.
template <int dim>
Real least_fill(const mesh::Mesh<dim>& mesh, const BodyGrid<dim>& grid, Index cell)
{
  Real min = 1;
  for (Index node : mesh.nodes[cell]) min = std::min(min, grid.fill[node]);
  return min;
}

/// Degree to which a cell with this fill counts as full, 0 to 1.
Real fullness(Real least_fill)
{
  const Real s = std::clamp((least_fill - surface_fill) / (full_fill - surface_fill), Real(0), Real(1));
  return s * s * (3 - 2 * s);
}

/// The same for the direction around the axis: what a full cell is integrated over has the shares a_k of the cell itself, so that a uniform stress leaves no
/// force within the body.
template <int dim>
void fill_hoop(const mesh::Mesh<dim>& mesh, Index cell, const mesh::CellPart<dim>& part, Real zeta, Real weight, HoopMoments& hoop)
{
  const Real section = part.cut ? part.section : mesh.section(cell);
  const Vec<dim> center = part.cut ? part.center : mesh.centroid(cell);
  hoop.area = (1 - zeta) * hoop.area + zeta * section;
  hoop.area_y = (1 - zeta) * hoop.area_y + zeta * section * (center[1] - mesh.position[mesh.nodes[cell][0]][1]);
  hoop.stress *= weight;
}

template <int dim>
void integrate_full_cell(const mesh::Mesh<dim>& mesh, Index cell, Real fill, BodyGrid<dim>& grid)
{
  Moments<dim>& t = grid.moments[cell];
  const mesh::CellPart<dim> part = grid.cut.used() ? grid.cut.parts[cell] : mesh::CellPart<dim>{};
  const Real zeta = part.cut && part.volume < min_fraction * t.volume ? 0 : fullness(fill);
  const Real weight = 1 - zeta + zeta * (part.cut ? part.volume : grid.volume[cell]) / t.volume;
  t.volume *= weight;
  for (Real& stress : t.stress) stress *= weight;
  if (!grid.hoop.empty()) fill_hoop(mesh, cell, part, zeta, weight, grid.hoop[cell]);
}

/// The momentum that the corners would have if the particles had the velocity of the nodes.
template <int dim>
void spread_nodal_momentum(const mesh::Mesh<dim>& mesh, Index cell, BodyGrid<dim>& grid)
{
  const AtCorners<dim> momentum = momentum_with(grid.moments[cell], at_corners(mesh.nodes[cell], grid.velocity));
  auto& corners = grid.corners[cell];
  for (int k = 0; k <= dim; ++k) store<dim>(momentum[k], corners[k].sum);
}

}  // namespace

template <int dim>
void prepare_cells(const problem::Model<dim>& model, const bodies::Particles<dim>& particles, Real dt, BodyGrid<dim>& grid)
{
  const auto& active = particles.active();
  const bool filters = grid.filters(), bounds = !grid.stiffness_limit.empty();
  if (!grid.full_cells && !filters) return;
  for_each("quadrature, nodal momentum", particles.active_chunks(), [&](Index c) {
    const Index cell = active[c];
    const Real fill = grid.full_cells ? least_fill(model.mesh, grid, cell) : 0;
    if (grid.full_cells) integrate_full_cell(model.mesh, cell, fill, grid);
    if (filters) spread_nodal_momentum(model.mesh, cell, grid);
    if (!bounds) return;
    const bool at_surface = fill < surface_fill || (grid.cut.used() && grid.cut.parts[cell].cut);
    if (at_surface)
      grid.stiffness_limit[cell] = max_stable_stiffness(model.mesh, grid, cell, dt);
    else if (grid.stiffness_limit[cell] != 0)
      grid.stiffness_limit[cell] = 0;
  });
  exchange_moments(model.mesh, particles, grid);
}

template void prepare_cells(const problem::Model<2>&, const bodies::Particles<2>&, Real, BodyGrid<2>&);
template void prepare_cells(const problem::Model<3>&, const bodies::Particles<3>&, Real, BodyGrid<3>&);

}  // namespace berm::mpm
