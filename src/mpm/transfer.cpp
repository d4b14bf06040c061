// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/transfer.hpp"

#include "core/for_each.hpp"
#include "core/lane_parts.hpp"

namespace berm {
namespace {

/// Corner k of a cell gets a_k q + b_k . qx, the sum over particles of N_k times a quantity with sums q and (times x) qx.
template <int dim>
[[gnu::always_inline]] inline Real at_corner(const Shape<dim>& shape, int k, Real q, const Real* qx)
{
  Real sum = shape.a[k] * q;
  for (int d = 0; d < dim; ++d) sum += shape.b[d][k] * qx[d];
  return sum;
}

/// The moments in parts of Lanes while they are summed, part by part, in the order in which Moments has them.
template <int dim>
struct LaneMoments {
  static constexpr int pairs = Moments<dim>::pairs;
  static constexpr int mx = 1, mxx = mx + dim, mv = mxx + pairs, mvx = mv + dim, volume = mvx + dim * dim, stress = volume + 1,
                       count = stress + pairs;
  static_assert(sizeof(Moments<dim>) == count * sizeof(Real));

  LanePart of[(count + part_lanes - 1) / part_lanes * part_lanes];

  [[gnu::always_inline]] void clear()
  {
#pragma GCC unroll 64
    for (LanePart& moment : of) moment = LanePart{};
  }

  [[gnu::always_inline]] void add(const Block<dim>& p, int first)
  {
    const LanePart p_mass = part_of(p.mass, first), p_volume = part_of(p.volume, first);
    LanePart x[dim], v[dim], at[dim];
    of[0] += p_mass;
    of[volume] += p_volume;
    for (int a = 0; a < dim; ++a) {
      x[a] = part_of(p.x[a], first);
      v[a] = part_of(p.v[a], first);
      at[a] = p_mass * x[a];
      of[mx + a] += at[a];
      of[mv + a] += p_mass * v[a];
    }
    for (int a = 0; a < dim; ++a)
      for (int b = a; b < dim; ++b) {
        of[mxx + Moments<dim>::pair(a, b)] += at[a] * x[b];
        of[stress + Moments<dim>::pair(a, b)] += p_volume * part_of(p.stress[tensor_place(a, b)], first);
      }
    for (int d = 0; d < dim; ++d)
      for (int a = 0; a < dim; ++a) of[mvx + d * dim + a] += at[a] * v[d];
  }

  /// As many sums as fit a register are made at a time, and stored at once.
  [[gnu::always_inline]] void total(Moments<dim>& moments) const
  {
#pragma GCC unroll 64
    for (int first = 0; first < count; first += part_lanes) {
      LanePart some[part_lanes];
      for (int k = 0; k < part_lanes; ++k) some[k] = of[first + k];
      const LanePart summed = sums(some);
      std::memcpy(&moments.m + first, &summed, std::min(part_lanes, count - first) * sizeof(Real));
    }
  }
};

}  // namespace

template <int dim>
void sum_moments(const Mesh<dim>& mesh, const Particles<dim>& particles, BodyGrid<dim>& grid)
{
  const auto& occupied = particles.occupied();
  for_each("sum moments of cells", static_cast<Index>(occupied.size()), [&](Index c) {
    const Index cell = occupied[c];
    particles.prefetch_after(c);
    LaneMoments<dim> sums;
    sums.clear();
    Index left = particles.count_in(cell);
    for (Index b = particles.first_block(cell); left > 0; b = particles.block(b).next, left -= lanes)
      for (int first = 0; first < lanes && first < left; first += part_lanes) sums.add(particles.block(b), first);
    Moments<dim>& t = grid.moments[cell];
    sums.total(t);

    const Shape<dim>& shape = mesh.shape[cell];
    Real trace_of_stress = 0;
    for (int d = 0; d < dim; ++d) trace_of_stress += t.stress[Moments<dim>::pair(d, d)];
    for (int k = 0; k <= dim; ++k) {
      CornerSums<dim>& corner = grid.corner_sums[(dim + 1) * cell + k];
      corner.mass = at_corner(shape, k, t.m, t.mx);
      for (int d = 0; d < dim; ++d) corner.momentum[d] = at_corner(shape, k, t.mv[d], t.mvx[d]);
      corner.volume = t.volume;
      corner.volume_pressure = trace_of_stress / dim;
    }
  });
}

/// A node with less than this part of the mass that fills its cells has none: the rest is round-off, which must not be divided by.
constexpr Real least_mass_part = 1e-9;

/// The mean velocity of all particles in a node's cells: for a node without mass, which then strains nothing that moves as one. The momentum of a
/// cell is told by momentum_of(cell).
template <int dim, class MomentumOf>
Vec<dim> velocity_of_cells(const Mesh<dim>& mesh, const BodyGrid<dim>& grid, Index node, const MomentumOf& momentum_of)
{
  Vec<dim> momentum = Vec<dim>::Zero();
  Real mass = 0;
  for (Index e = mesh.first_entry[node]; e < mesh.first_entry[node + 1]; ++e) {
    const Index cell = mesh.entries[e] / (dim + 1);
    mass += grid.moments[cell].m;
    momentum += momentum_of(cell);
  }
  return mass > 0 ? Vec<dim>(momentum / mass) : Vec<dim>(Vec<dim>::Zero());
}

template <int dim>
void gather_mass_and_momentum(const Mesh<dim>& mesh, Real density, BodyGrid<dim>& grid)
{
  for_each("gather mass and momentum", static_cast<Index>(grid.nodes.size()), [&](Index n) {
    const Index i = grid.nodes[n];
    CornerSums<dim> total{};
    for (Index e = mesh.first_entry[i]; e < mesh.first_entry[i + 1]; ++e) {
      const CornerSums<dim>& corner = grid.corner_sums[mesh.entries[e]];
      total.mass += corner.mass;
      total.volume += corner.volume;
      for (int d = 0; d < dim; ++d) total.momentum[d] += corner.momentum[d];
    }
    if (!(total.mass > least_mass_part * density * total.volume)) total.mass = 0;
    const Real per_mass = total.mass > 0 ? 1 / total.mass : 0;
    grid.mass[i] = total.mass;
    for (int d = 0; d < dim; ++d) grid.velocity[i][d] = total.momentum[d] * per_mass;
  });
}

namespace {

/// The viscous mean stress of a cell, eta h div(v) with the means of h and div(v) over the cells of its patch, `none` after the last. Pa.
template <int dim>
Real viscous_stress(const Mesh<dim>& mesh, const BodyGrid<dim>& grid, const Patch& patch)
{
  Real volume = 0, height = 0, divergence = 0;
  for (Index cell : patch) {
    if (cell == none) break;
    const Real of_cell = grid.moments[cell].volume;
    volume += of_cell;
    height += of_cell * mesh.height[cell];
    for (int k = 0; k <= dim; ++k) divergence += of_cell * mesh.shape[cell].gradient(k).dot(grid.velocity[mesh.nodes[cell][k]]);
  }
  return grid.bulk_viscosity * (height / volume) * (divergence / volume);
}

/// A patch of one cell.
Patch alone(Index cell)
{
  Patch patch;
  patch.fill(none);
  patch[0] = cell;
  return patch;
}

}  // namespace

template <int dim>
void spread_internal_forces(const Model<dim>& model, const Particles<dim>& particles, BodyGrid<dim>& grid)
{
  const Mesh<dim>& mesh = model.mesh;
  const auto& occupied = particles.occupied();
  const bool project = model.mpm.volumetric_projection;
  for_each("internal forces of cells", static_cast<Index>(occupied.size()), [&](Index c) {
    const Index cell = occupied[c];
    const Moments<dim>& t = grid.moments[cell];
    Real change = 0;  // of volume times mean stress
    if (project) {
      Real volume = 0, volume_pressure = 0;
      for (Index member : model.patches[cell]) {
        if (member == none) break;
        const CornerSums<dim>& sums = grid.corner_sums[(dim + 1) * member];
        volume += sums.volume;
        volume_pressure += sums.volume_pressure;
      }
      change = volume_pressure / volume * t.volume - grid.corner_sums[(dim + 1) * cell].volume_pressure;
    }
    if (grid.bulk_viscosity > 0) {
      grid.viscous_stress[cell] = viscous_stress(mesh, grid, project ? model.patches[cell] : alone(cell));
      change += t.volume * grid.viscous_stress[cell];
    }
    Matrix<dim> stress;
    for (int a = 0; a < dim; ++a)
      for (int b = 0; b < dim; ++b) stress(a, b) = t.stress[Moments<dim>::pair(std::min(a, b), std::max(a, b))] + (a == b ? change : 0);
    for (int k = 0; k <= dim; ++k) grid.corner_force[(dim + 1) * cell + k] = -stress * mesh.shape[cell].gradient(k);
  });
}

template <int dim>
void spread_new_momentum(const Mesh<dim>& mesh, const Particles<dim>& particles, Real dt, BodyGrid<dim>& grid)
{
  const auto& occupied = particles.occupied();
  for_each("momentum after the forces", static_cast<Index>(occupied.size()), [&](Index c) {
    const Index cell = occupied[c];
    const Moments<dim>& t = grid.moments[cell];
    const Shape<dim>& shape = mesh.shape[cell];
    Vec<dim>* corners = &grid.corner_momentum[(dim + 1) * cell];
    for (int d = 0; d < dim; ++d) {
      Real a0 = 0, slope[dim] = {};  // a(x) = a0 + slope . x
      for (int k = 0; k <= dim; ++k) {
        const Real a = grid.acceleration[mesh.nodes[cell][k]][d];
        a0 += shape.a[k] * a;
        for (int e = 0; e < dim; ++e) slope[e] += shape.b[e][k] * a;
      }
      Real momentum = a0 * t.m, times_x[dim];
      for (int e = 0; e < dim; ++e) momentum += slope[e] * t.mx[e];
      for (int f = 0; f < dim; ++f) {
        times_x[f] = a0 * t.mx[f];
        for (int e = 0; e < dim; ++e) times_x[f] += slope[e] * t.mxx[Moments<dim>::pair(std::min(e, f), std::max(e, f))];
        times_x[f] = t.mvx[d][f] + dt * times_x[f];
      }
      momentum = t.mv[d] + dt * momentum;
      for (int k = 0; k <= dim; ++k) corners[k][d] = at_corner(shape, k, momentum, times_x);
    }
  });
}

template <int dim>
void gather_new_velocities(const Model<dim>& model, BodyGrid<dim>& grid)
{
  const Mesh<dim>& mesh = model.mesh;
  for_each("gather new velocities", static_cast<Index>(grid.nodes.size()), [&](Index n) {
    const Index i = grid.nodes[n];
    Vec<dim> momentum = Vec<dim>::Zero();
    for (Index e = mesh.first_entry[i]; e < mesh.first_entry[i + 1]; ++e) momentum += grid.corner_momentum[mesh.entries[e]];
    const auto momentum_of = [&](Index cell) {
      Vec<dim> sum = Vec<dim>::Zero();
      for (int k = 0; k <= dim; ++k) sum += grid.corner_momentum[(dim + 1) * cell + k];
      return sum;
    };
    grid.moved_velocity[i] =
        without_held<dim>(model, i, grid.mass[i] > 0 ? Vec<dim>(momentum / grid.mass[i]) : velocity_of_cells(mesh, grid, i, momentum_of));
  });
}

template <int dim>
void predict_velocities(const Model<dim>& model, Real ahead, BodyGrid<dim>& grid)
{
  for_each("predict velocities", static_cast<Index>(grid.nodes.size()), [&](Index n) {
    const Index i = grid.nodes[n];
    const auto momentum_of = [&](Index cell) { return Eigen::Map<const Vec<dim>>(grid.moments[cell].mv); };
    grid.moved_velocity[i] = without_held<dim>(model, i,
                                               grid.mass[i] > 0 ? Vec<dim>(grid.velocity[i] + ahead * grid.acceleration[i])
                                                                : velocity_of_cells(model.mesh, grid, i, momentum_of));
  });
}

template <int dim>
void sum_volume_changes(const Mesh<dim>& mesh, const Particles<dim>& particles, Real dt, BodyGrid<dim>& grid)
{
  const auto& occupied = particles.occupied();
  for_each("volume change of cells", static_cast<Index>(occupied.size()), [&](Index c) {
    const Index cell = occupied[c];
    Real divergence = 0;
    for (int k = 0; k <= dim; ++k) divergence += mesh.shape[cell].gradient(k).dot(grid.moved_velocity[mesh.nodes[cell][k]]);
    grid.volume_change[cell] = grid.moments[cell].volume * divergence * dt;
  });
}

#define BERM_INSTANTIATE(dim)                                                                                                              \
  template void sum_moments(const Mesh<dim>&, const Particles<dim>&, BodyGrid<dim>&);                                                      \
  template void gather_mass_and_momentum(const Mesh<dim>&, Real, BodyGrid<dim>&);                                                          \
  template void spread_internal_forces(const Model<dim>&, const Particles<dim>&, BodyGrid<dim>&);                                          \
  template void spread_new_momentum(const Mesh<dim>&, const Particles<dim>&, Real, BodyGrid<dim>&);                                        \
  template void gather_new_velocities(const Model<dim>&, BodyGrid<dim>&);                                                                  \
  template void predict_velocities(const Model<dim>&, Real, BodyGrid<dim>&);                                                               \
  template void sum_volume_changes(const Mesh<dim>&, const Particles<dim>&, Real, BodyGrid<dim>&);
BERM_INSTANTIATE(2)
BERM_INSTANTIATE(3)
#undef BERM_INSTANTIATE

}  // namespace berm
