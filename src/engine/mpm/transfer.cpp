// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/transfer.hpp"

#include "mpm/hoop.hpp"
#include "mpm/linear_field.hpp"
#include "mpm/share.hpp"

namespace berm::mpm {
namespace {

/// Shares of the corners of a cell in a quantity: calls give(k, sum) with the sums over particles of N_k times it. Its own
/// sum is q and that of it times x is qx.
template <int dim, class Give>
[[gnu::always_inline]] inline void share_among_corners(const mesh::Shape<dim>& shape, Real q, const Real* qx, const Give& give)
{
  Real from_origin[dim], of_corner_0 = q;
  for (int d = 0; d < dim; ++d) from_origin[d] = qx[d] - q * shape.origin[d];
  for (int k = 1; k <= dim; ++k) {
    Real sum = shape.gradients[k - 1][0] * from_origin[0];
    for (int d = 1; d < dim; ++d) sum += shape.gradients[k - 1][d] * from_origin[d];
    give(k, sum);
    of_corner_0 -= sum;
  }
  give(0, of_corner_0);
}

/// The divergence of a nodal field in a cell.
template <mesh::Metric metric, int dim>
[[gnu::always_inline]] inline Real divergence_in(const mesh::Shape<dim>& shape, const std::array<Index, dim + 1>& nodes,
                                                 const BodyGrid<dim>& grid, Index cell, const NodeField<Vec<dim>>& field)
{
  Real divergence = 0;
  for (int k = 1; k <= dim; ++k)
    for (int d = 0; d < dim; ++d) divergence += shape.gradients[k - 1][d] * (field[nodes[k]][d] - field[nodes[0]][d]);
  if constexpr (metric == mesh::Metric::axisymmetric) divergence += hoop_rate(shape, nodes, grid, cell, field);
  return divergence;
}

/// The moments in lanes while they are summed, part by part, in the order in which Moments has them.
template <int dim>
struct LaneMoments {
  static constexpr int pairs = Moments<dim>::pairs;
  static constexpr int mx = 1, mxx = mx + dim, mv = mxx + pairs, mvx = mv + dim, volume = mvx + dim * dim, stress = volume + 1,
                       count = stress + pairs;
  static_assert(sizeof(Moments<dim>) == count * sizeof(Real));

  static constexpr int width = lanes_of<WidePart>;

  WidePart of[(count + width - 1) / width * width];

  [[gnu::always_inline]] void clear()
  {
#pragma GCC unroll 64
    for (WidePart& moment : of) moment = WidePart{};
  }

  /// A narrow part fills the lower lanes.
  template <class V>
  [[gnu::always_inline]] static WidePart widened(const V& numbers)
  {
    if constexpr (lanes_of<V> < width)
      return __builtin_shufflevector(numbers, V{}, 0, 1, 2, 3, 4, 5, 6, 7);
    else
      return numbers;
  }

  template <class V>
  [[gnu::always_inline]] void add(const Part<V>& part, const bodies::Block<dim>& p, const bodies::Block<dim>& q)
  {
    const WidePart p_mass = widened(part.get(p.mass, q.mass)), p_volume = widened(part.get(p.volume, q.volume));
    WidePart x[dim], v[dim], at[dim];
    of[0] += p_mass;
    of[volume] += p_volume;
    for (int a = 0; a < dim; ++a) {
      x[a] = widened(part.get(p.x[a], q.x[a]));
      v[a] = widened(part.get(p.v[a], q.v[a]));
      at[a] = p_mass * x[a];
      of[mx + a] += at[a];
      of[mv + a] += p_mass * v[a];
    }
    for (int a = 0; a < dim; ++a)
      for (int b = a; b < dim; ++b) {
        of[mxx + Moments<dim>::pair(a, b)] += at[a] * x[b];
        const int index = tensor_index(a, b);
        of[stress + Moments<dim>::pair(a, b)] += p_volume * widened(part.get(p.stress[index], q.stress[index]));
      }
    for (int d = 0; d < dim; ++d)
      for (int a = 0; a < dim; ++a) of[mvx + d * dim + a] += at[a] * v[d];
  }

  /// As many sums as fit a register are made at a time, and stored at once.
  [[gnu::always_inline]] void total(Moments<dim>& moments) const
  {
#pragma GCC unroll 64
    for (int first = 0; first < count; first += width) {
      WidePart some[width];
      for (int k = 0; k < width; ++k) some[k] = of[first + k];
      const WidePart summed = sums(some);
      std::memcpy(&moments.m + first, &summed, std::min(width, count - first) * sizeof(Real));
    }
  }
};

/// The hoop moments in lanes while they are summed.
struct LaneHoopMoments {
  WidePart area{}, area_y{}, stress{};

  template <class V, int dim>
  [[gnu::always_inline]] void add(const Part<V>& part, const bodies::Block<dim>& p, const bodies::Block<dim>& q)
  {
    const V volume = part.get(p.volume, q.volume), radius = part.get(p.x[0], q.x[0]);
    const V section = radius > V{} ? volume / radius : V{};  // empty lanes may be at the axis
    area += LaneMoments<dim>::widened(section);
    area_y += LaneMoments<dim>::widened(V(section * part.get(p.x[1], q.x[1])));
    stress += LaneMoments<dim>::widened(V(volume * part.get(p.stress[2], q.stress[2])));
  }
};

template <mesh::Metric metric, int dim>
[[gnu::always_inline]] inline void sum_moments_in(const mesh::Mesh<dim>& mesh, const bodies::Particles<dim>& particles, Index cell,
                                                  BodyGrid<dim>& grid)
{
  LaneMoments<dim> sums;
  sums.clear();
  [[maybe_unused]] LaneHoopMoments hoop_sums;
  particles.parts(cell, [&](const auto& part) {
    sums.add(part, particles.block(part.block), particles.block(part.other));
    if constexpr (metric == mesh::Metric::axisymmetric) hoop_sums.add(part, particles.block(part.block), particles.block(part.other));
  });
  Moments<dim>& t = grid.moments[cell];
  sums.total(t);
  if constexpr (metric == mesh::Metric::axisymmetric) grid.hoop[cell] = {sum(hoop_sums.area), sum(hoop_sums.area_y), sum(hoop_sums.stress)};

  const mesh::Shape<dim> shape = grid.shape(mesh, cell);
  auto& corners = grid.corners[cell];
  for (int d = 0; d < dim; ++d) share_among_corners<dim>(shape, t.mv[d], t.mvx[d], [&](int k, Real sum) { corners[k].sum[d] = sum; });
  share_among_corners<dim>(shape, t.m, t.mx, [&](int k, Real sum) { corners[k].mass = sum; });
  for (CornerSums<dim>& corner : corners) corner.volume = t.volume;
}

/// By itself, so that the plane has the registers of its own loop.
[[gnu::noinline]] void sum_moments_around_axis(const mesh::Mesh<2>& mesh, const bodies::Particles<2>& particles, Index cell,
                                               BodyGrid<2>& grid)
{
  sum_moments_in<mesh::Metric::axisymmetric>(mesh, particles, cell, grid);
}

}  // namespace

template <int dim>
void sum_moments_of(const mesh::Mesh<dim>& mesh, const bodies::Particles<dim>& particles, Index cell, BodyGrid<dim>& grid)
{
  if constexpr (dim == 2)
    if (mesh.metric == mesh::Metric::axisymmetric) return sum_moments_around_axis(mesh, particles, cell, grid);
  sum_moments_in<mesh::Metric::cartesian>(mesh, particles, cell, grid);
}

template <int dim>
void sum_moments(const mesh::Mesh<dim>& mesh, const bodies::Particles<dim>& particles, BodyGrid<dim>& grid)
{
  for_each("sum moments of cells", particles.chunks(), [&](Index c) {
    const Index cell = particles.occupied()[c];
    sum_moments_of(mesh, particles, cell, grid);
    if (particles.rests(cell)) grid.rest(cell);
  });
}

/// A node with less than this fraction of the mass in its cells has none: the rest is round-off, which must not be divided
/// by.
constexpr Real min_mass_part = 1e-9;

/// Mean velocity of all particles in a node's cells: for a node without mass, which then strains nothing in rigid motion.
/// momentum_of(cell) gives the momentum of a cell.
template <int dim, class MomentumOf>
Vec<dim> velocity_of_cells(const mesh::Mesh<dim>& mesh, const BodyGrid<dim>& grid, Index node, const MomentumOf& momentum_of)
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
Real mass_of_cells(const mesh::Mesh<dim>& mesh, const BodyGrid<dim>& grid, Index node)
{
  Real mass = 0;
  for (Index e = mesh.first_entry[node]; e < mesh.first_entry[node + 1]; ++e) mass += grid.moments[mesh.entries[e] / (dim + 1)].m;
  return mass;
}

template <int dim>
void gather_mass_and_momentum(const mesh::Mesh<dim>& mesh, BodyGrid<dim>& grid)
{
  for_each("gather mass and momentum", grid.chunks, [&](Index n) {
    const Index i = grid.nodes[n];
    CornerSums<dim> total{};
    Real min_volume = infinity;
    for (Index e = mesh.first_entry[i]; e < mesh.first_entry[i + 1]; ++e) {
      const CornerSums<dim>& corner = grid.at(mesh.entries[e]);
      for (int d = 0; d < dim; ++d) total.sum[d] += corner.sum[d];
      total.mass += corner.mass;
      total.volume += corner.volume;
      min_volume = std::min(min_volume, corner.volume);
    }
    if (grid.full_cells) grid.fill[i] = min_volume > 0 ? total.volume / grid.volume_around[i] : 0;
    // Most nodes have more than that fraction of the whole body.
    if (!(total.mass > min_mass_part * grid.total_mass) && !(total.mass > min_mass_part * mass_of_cells(mesh, grid, i))) total.mass = 0;
    const Real per_mass = total.mass > 0 ? 1 / total.mass : 0;
    grid.mass[i] = total.mass;
    for (int d = 0; d < dim; ++d) grid.velocity[i][d] = total.sum[d] * per_mass;
  });
}

namespace {

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

template <mesh::Metric metric, int dim>
void find_viscous_stress_in(const problem::Model<dim>& model, const bodies::Particles<dim>& particles, BodyGrid<dim>& grid)
{
  const mesh::Mesh<dim>& mesh = model.mesh;
  const auto& active = particles.active();
  for_each("viscous stress of cells", particles.active_chunks(), [&](Index c) {
    Real volume = 0, height = 0, divergence = 0;
    mesh::for_each_in_patch(model.patches, active[c], [&](Index member) {
      const Real of_cell = grid.moments[member].volume;
      volume += of_cell;
      height += of_cell * grid.height[member];
      // An empty cell has no hoop strain, which is a mean over its volume.
      if (metric == mesh::Metric::cartesian || of_cell > 0)
        divergence += of_cell * divergence_in<metric>(grid.shape(mesh, member), mesh.nodes[member], grid, member, grid.velocity);
    });
    grid.viscous_stress[active[c]] = grid.bulk_viscosity * (height / volume) * (divergence / volume);
  });
}

template <mesh::Metric metric, int dim>
void spread_internal_forces_in(const problem::Model<dim>& model, const bodies::Particles<dim>& particles, BodyGrid<dim>& grid)
{
  const mesh::Mesh<dim>& mesh = model.mesh;
  const auto& active = particles.active();
  const bool project = model.mpm.volumetric_projection;
  for_each("internal forces of cells", particles.active_chunks(), [&](Index c) {
    const Index cell = active[c];
    const Moments<dim>& t = grid.moments[cell];
    Real change = 0;  // of volume times mean stress
    if (project) {
      Real volume = 0, volume_stress = 0;
      mesh::for_each_in_patch(model.patches, cell, [&](Index member) {
        volume += grid.moments[member].volume;
        volume_stress += volume_times_mean_stress<metric>(grid, member);
      });
      change = volume_stress / volume * t.volume - volume_times_mean_stress<metric>(grid, cell);
    }
    change += t.volume * grid.viscous_stress[cell];
    Matrix<dim> stress;
    for (int a = 0; a < dim; ++a)
      for (int b = 0; b < dim; ++b) stress(a, b) = t.stress[Moments<dim>::pair(std::min(a, b), std::max(a, b))] + (a == b ? change : 0);
    const mesh::Shape<dim> shape = grid.shape(mesh, cell);
    auto& corners = grid.corners[cell];
    Vec<dim> of_others = Vec<dim>::Zero();
    for (int k = 1; k <= dim; ++k) {
      const Vec<dim> force = stress * shape.gradient(k);
      Eigen::Map<Vec<dim>>(corners[k].sum) = -force;
      of_others += force;
    }
    Eigen::Map<Vec<dim>>(corners[0].sum) = of_others;
    if constexpr (metric == mesh::Metric::axisymmetric) {
      const Real hoop_stress = (grid.hoop[cell].stress + change) / t.volume;
      for_each_hoop_share<dim>(shape, t, grid.hoop[cell], [&](int k, Real share) { corners[k].sum[0] -= share * hoop_stress; });
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
    if (grid.moments[cell].m > 0) sum(cell);
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
void spread_internal_forces(const problem::Model<dim>& model, const bodies::Particles<dim>& particles, BodyGrid<dim>& grid)
{
  with_metric(model.mesh, [&](auto metric) { spread_internal_forces_in<metric()>(model, particles, grid); });
}

template <int dim>
void smooth_velocities(const mesh::Mesh<dim>& mesh, const bodies::Particles<dim>& particles, BodyGrid<dim>& grid)
{
  if (!(grid.filter_rate > 0)) return;
  const auto& active = particles.active();
  for_each("momentum of nodal velocities", particles.active_chunks(), [&](Index c) {
    const Index cell = active[c];
    const mesh::Shape<dim> shape = grid.shape(mesh, cell);
    const LinearField<dim> velocity(shape, mesh.nodes[cell], grid.velocity);
    auto& corners = grid.corners[cell];
    for (int d = 0; d < dim; ++d) {
      Real times_x[dim];
      const Real momentum = velocity.momentum(d, grid.moments[cell], times_x);
      share_among_corners<dim>(shape, momentum, times_x, [&](int k, Real sum) { corners[k].sum[d] = sum; });
    }
  });
  share_corner_sums(grid);
  for_each("smooth velocities", grid.chunks, [&](Index n) {
    const Index i = grid.nodes[n];
    Vec<dim> momentum = Vec<dim>::Zero();
    for (Index e = mesh.first_entry[i]; e < mesh.first_entry[i + 1]; ++e)
      momentum += Eigen::Map<const Vec<dim>>(grid.at(mesh.entries[e]).sum);
    grid.smooth_velocity[i] = grid.mass[i] > 0 ? Vec<dim>(2 * grid.velocity[i] - momentum / grid.mass[i]) : Vec<dim>(Vec<dim>::Zero());
  });
}

template <int dim>
void spread_new_momentum(const mesh::Mesh<dim>& mesh, const bodies::Particles<dim>& particles, Real dt, BodyGrid<dim>& grid)
{
  const auto& active = particles.active();
  const Real part = grid.filtered_part(dt);
  for_each("momentum after the forces", particles.active_chunks(), [&](Index c) {
    const Index cell = active[c];
    const Moments<dim>& t = grid.moments[cell];
    const mesh::Shape<dim> shape = grid.shape(mesh, cell);
    const LinearField<dim> gain(shape, mesh.nodes[cell], [&](Index i, int d) { return grid.gain(i, d, dt, part); });
    auto& corners = grid.corners[cell];
    for (int d = 0; d < dim; ++d) {
      Real times_x[dim];
      const Real momentum = (1 - part) * t.mv[d] + gain.momentum(d, t, times_x);
      for (int a = 0; a < dim; ++a) times_x[a] += (1 - part) * t.mvx[d][a];
      share_among_corners<dim>(shape, momentum, times_x, [&](int k, Real sum) { corners[k].sum[d] = sum; });
    }
  });
}

template <int dim>
void gather_new_velocities(const problem::Model<dim>& model, BodyGrid<dim>& grid)
{
  const mesh::Mesh<dim>& mesh = model.mesh;
  const NodeField<std::uint8_t>& fixed = grid.supports(model);
  for_each("gather new velocities", grid.chunks, [&](Index n) {
    const Index i = grid.nodes[n];
    Vec<dim> momentum = Vec<dim>::Zero();
    for (Index e = mesh.first_entry[i]; e < mesh.first_entry[i + 1]; ++e)
      momentum += Eigen::Map<const Vec<dim>>(grid.at(mesh.entries[e]).sum);
    const auto momentum_of = [&](Index cell) {
      Vec<dim> sum = Vec<dim>::Zero();
      for (const CornerSums<dim>& corner : grid.corners[cell]) sum += Eigen::Map<const Vec<dim>>(corner.sum);
      return sum;
    };
    grid.mapped_velocity[i] = boundary::without_fixed<dim>(
        fixed, i, grid.mass[i] > 0 ? Vec<dim>(momentum / grid.mass[i]) : velocity_of_cells(mesh, grid, i, momentum_of));
  });
}

template <int dim>
void predict_velocities(const problem::Model<dim>& model, Real ahead, BodyGrid<dim>& grid)
{
  const NodeField<std::uint8_t>& fixed = grid.supports(model);
  for_each("predict velocities", grid.chunks, [&](Index n) {
    const Index i = grid.nodes[n];
    const auto momentum_of = [&](Index cell) { return Eigen::Map<const Vec<dim>>(grid.moments[cell].mv); };
    grid.mapped_velocity[i] = boundary::without_fixed<dim>(fixed, i,
                                                           grid.mass[i] > 0 ? Vec<dim>(grid.velocity[i] + ahead * grid.acceleration[i])
                                                                            : velocity_of_cells(model.mesh, grid, i, momentum_of));
  });
}

template <int dim>
void sum_volume_changes(const mesh::Mesh<dim>& mesh, const bodies::Particles<dim>& particles, Real dt, BodyGrid<dim>& grid)
{
  with_metric(mesh, [&](auto metric) { sum_volume_changes_in<metric()>(mesh, particles, dt, grid); });
}

#define BERM_INSTANTIATE(dim)                                                                                                              \
  template void sum_moments_of(const mesh::Mesh<dim>&, const bodies::Particles<dim>&, Index, BodyGrid<dim>&);                              \
  template void sum_moments(const mesh::Mesh<dim>&, const bodies::Particles<dim>&, BodyGrid<dim>&);                                        \
  template void gather_mass_and_momentum(const mesh::Mesh<dim>&, BodyGrid<dim>&);                                                          \
  template void find_viscous_stress(const problem::Model<dim>&, const bodies::Particles<dim>&, BodyGrid<dim>&);                            \
  template void spread_internal_forces(const problem::Model<dim>&, const bodies::Particles<dim>&, BodyGrid<dim>&);                         \
  template void smooth_velocities(const mesh::Mesh<dim>&, const bodies::Particles<dim>&, BodyGrid<dim>&);                                  \
  template void spread_new_momentum(const mesh::Mesh<dim>&, const bodies::Particles<dim>&, Real, BodyGrid<dim>&);                          \
  template void gather_new_velocities(const problem::Model<dim>&, BodyGrid<dim>&);                                                         \
  template void predict_velocities(const problem::Model<dim>&, Real, BodyGrid<dim>&);                                                      \
  template Real divergence(const mesh::Mesh<dim>&, const BodyGrid<dim>&, Index, const NodeField<Vec<dim>>&);                               \
  template void sum_volume_changes(const mesh::Mesh<dim>&, const bodies::Particles<dim>&, Real, BodyGrid<dim>&);
BERM_INSTANTIATE(2)
BERM_INSTANTIATE(3)
#undef BERM_INSTANTIATE

}  // namespace berm::mpm
