// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/internal_forces.hpp"

#include "mpm/filter.hpp"
#include "mpm/hoop.hpp"
#include "mpm/linear_field.hpp"
#include "mpm/patch_cells.hpp"

namespace berm::mpm {
namespace {

/// The divergence of a nodal field in a cell.
template <mesh::Metric metric, int dim>
[[gnu::always_inline]] inline Real divergence_in(const mesh::Shape<dim>& shape, const std::array<Index, dim + 1>& nodes,
                                                 const BodyGrid<dim>& grid, Index cell, const NodeField<Vec<dim>>& field)
{
  const AtCorners<dim> values = at_corners(nodes, field);
  Components<dim> sum{};
  for (int k = 1; k <= dim; ++k) sum += components<dim>(shape.gradients[k - 1].data()) * (values[k] - values[0]);
  Real divergence = sum_of_components<dim>(sum);
  if constexpr (metric == mesh::Metric::axisymmetric) divergence += hoop_rate(shape, nodes, grid, cell, field);
  return divergence;
}

/// The sum of V times the mean stress of a cell's particles, N m.
template <mesh::Metric metric, int dim>
[[gnu::always_inline]] inline Real volume_times_mean_stress(const BodyGrid<dim>& grid, Index cell)
{
  const Moments<dim>& t = grid.moments[cell];
  Real trace = 0;
  for (int d = 0; d < dim; ++d) trace += t.stress[Moments<dim>::pair(d, d)];
  if constexpr (metric == mesh::Metric::axisymmetric) trace += grid.hoop[cell].stress;
  return trace / strained_directions<dim, metric>;
}

/// Sums over the cells of a patch for their viscous stress.
template <mesh::Metric metric, int dim>
struct PatchDivergence {
  Real height = 0, divergence = 0;  // times the volume of their cell

  [[gnu::always_inline]] void add(const mesh::Mesh<dim>& mesh, const BodyGrid<dim>& grid, Index cell)
  {
    const Real of_cell = grid.moments[cell].volume;
    height += of_cell * grid.height[cell];
    divergence += of_cell * divergence_in<metric>(grid.shape(mesh, cell), mesh.nodes[cell], grid, cell, grid.velocity);
  }
  /// The viscous mean stress of the cells, Pa, which have this volume together.
  Real viscous_stress(const BodyGrid<dim>& grid, Real volume) const
  {
    return grid.bulk_viscosity * (height / volume) * (divergence / volume);
  }
};

/// The internal forces of a cell, whose volume times mean stress changes by `change` (N m).
template <mesh::Metric metric, int dim>
[[gnu::always_inline]] inline void spread_forces_of(const mesh::Mesh<dim>& mesh, Index cell, Real change, BodyGrid<dim>& grid)
{
  const Moments<dim>& t = grid.moments[cell];
  Components<dim> minus_stress[dim] = {};  // its rows, times the volume
  for (int a = 0; a < dim; ++a)
    for (int b = 0; b < dim; ++b)
      minus_stress[a][b] = -t.stress[Moments<dim>::pair(std::min(a, b), std::max(a, b))] - (a == b ? change : 0);
  const mesh::Shape<dim> shape = grid.shape(mesh, cell);
  auto& corners = grid.corners[cell];
  Components<dim> of_corner_0{};
  for (int k = 1; k <= dim; ++k) {
    Components<dim> force = shape.gradients[k - 1][0] * minus_stress[0];
    for (int a = 1; a < dim; ++a) force += shape.gradients[k - 1][a] * minus_stress[a];
    store<dim>(force, corners[k].sum);
    of_corner_0 -= force;
  }
  store<dim>(of_corner_0, corners[0].sum);
  if constexpr (metric == mesh::Metric::axisymmetric) {
    const Real hoop_stress = (grid.hoop[cell].stress + change) / t.volume;
    for_each_hoop_share<dim>(shape, t, grid.hoop[cell], [&](int k, Real share) { corners[k].sum[0] -= share * hoop_stress; });
  }
}

template <mesh::Metric metric, int dim>
void find_viscous_stress_in(const problem::Model<dim>& model, const bodies::Particles<dim>& particles, BodyGrid<dim>& grid)
{
  for_each_patch("viscous stress of cells", model.patches, particles, grid, [&](const PatchCells& patch) {
    Real volume = 0;
    PatchDivergence<metric, dim> sums;
    for (const Index member : patch) {
      volume += grid.moments[member].volume;
      sums.add(model.mesh, grid, member);
    }
    const Real viscous_stress = sums.viscous_stress(grid, volume);
    for (const Index member : patch)
      if (particles.is_active(member)) grid.viscous_stress[member] = viscous_stress;
  });
}

template <mesh::Metric metric, int dim>
void spread_internal_forces_in(const problem::Model<dim>& model, const bodies::Particles<dim>& particles, Real dt, BodyGrid<dim>& grid)
{
  const mesh::Mesh<dim>& mesh = model.mesh;
  const bool project = model.mpm.volumetric_projection, filters = grid.filters(), shifts = !grid.pressure_shift.empty();
  const bool is_viscous = grid.bulk_viscosity > 0 && !model.update_stress_first;
  for_each_patch("internal forces of cells", model.patches, particles, grid, [&](const PatchCells& patch) {
    Real volume = 0, volume_stress = 0;
    Real of_member[mesh::max_patch_cells];  // volume times mean stress, N m
    PatchDivergence<metric, dim> divergence;
    FilteredMomentum<dim> filtered;
    for (int k = 0; k < patch.count; ++k) {
      const Index member = patch.cell[k];
      volume += grid.moments[member].volume;
      volume_stress += of_member[k] = volume_times_mean_stress<metric>(grid, member);
      if (is_viscous) divergence.add(mesh, grid, member);
      if (filters) filtered.add(mesh, grid, member, grid.filter_fraction(member, dt));
    }
    const Real mean_stress = volume_stress / volume, viscous_stress = is_viscous ? divergence.viscous_stress(grid, volume) : 0;
    const Components<dim> shift = filters ? filtered.momentum / filtered.mass : Components<dim>{};
    for (int k = 0; k < patch.count; ++k) {
      const Index member = patch.cell[k];
      if (!particles.is_active(member)) continue;
      const Real of_cell = grid.moments[member].volume;
      const Real change = project ? mean_stress * of_cell - of_member[k] : 0;
      if (filters) grid.keep_shift(member, shift);
      if (is_viscous) grid.viscous_stress[member] = viscous_stress;
      if (shifts) grid.pressure_shift[member] = change / of_cell;
      spread_forces_of<metric>(mesh, member, change + of_cell * grid.viscous_stress[member], grid);
    }
  });
}

template <mesh::Metric metric, int dim>
void sum_volume_changes_in(const mesh::Mesh<dim>& mesh, const bodies::Particles<dim>& particles, Real dt, BodyGrid<dim>& grid)
{
  const auto& active = particles.active();
  const auto sum = [&](Index cell) {
    const Real divergence = divergence_in<metric>(grid.shape(mesh, cell), mesh.nodes[cell], grid, cell, grid.mapped_velocity);
    const Real volume = grid.moments[cell].volume;
    grid.volume_change[cell] = {volume, volume * divergence * dt};
  };
  for_each("volume change of cells", particles.active_chunks(), [&](Index c) { sum(active[c]); });
  for (const Index cell : grid.halo.partners)
    if (grid.moments[cell].any()) sum(cell);
}

}  // namespace

template <int dim>
Real divergence(const mesh::Mesh<dim>& mesh, const BodyGrid<dim>& grid, Index cell, const NodeField<Vec<dim>>& field)
{
  return with_metric(mesh,
                     [&](auto metric) { return divergence_in<metric()>(grid.shape(mesh, cell), mesh.nodes[cell], grid, cell, field); });
}

template <int dim>
void find_viscous_stress(const problem::Model<dim>& model, const bodies::Particles<dim>& particles, BodyGrid<dim>& grid)
{
  if (!(grid.bulk_viscosity > 0)) return;
  with_metric(model.mesh, [&](auto metric) { find_viscous_stress_in<metric()>(model, particles, grid); });
}

template <int dim>
void spread_internal_forces(const problem::Model<dim>& model, const bodies::Particles<dim>& particles, Real dt, BodyGrid<dim>& grid)
{
  with_metric(model.mesh, [&](auto metric) { spread_internal_forces_in<metric()>(model, particles, dt, grid); });
}

template <int dim>
void sum_volume_changes(const mesh::Mesh<dim>& mesh, const bodies::Particles<dim>& particles, Real dt, BodyGrid<dim>& grid)
{
  with_metric(mesh, [&](auto metric) { sum_volume_changes_in<metric()>(mesh, particles, dt, grid); });
}

#define BERM_INSTANTIATE(dim)                                                                                                              \
  template void find_viscous_stress(const problem::Model<dim>&, const bodies::Particles<dim>&, BodyGrid<dim>&);                            \
  template void spread_internal_forces(const problem::Model<dim>&, const bodies::Particles<dim>&, Real, BodyGrid<dim>&);                   \
  template Real divergence(const mesh::Mesh<dim>&, const BodyGrid<dim>&, Index, const NodeField<Vec<dim>>&);                               \
  template void sum_volume_changes(const mesh::Mesh<dim>&, const bodies::Particles<dim>&, Real, BodyGrid<dim>&);
BERM_INSTANTIATE(2)
BERM_INSTANTIATE(3)
#undef BERM_INSTANTIATE

}  // namespace berm::mpm
