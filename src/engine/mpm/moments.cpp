// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/moments.hpp"

#include "core/widened.hpp"

namespace berm::mpm {
namespace {

/// The moments in lanes while they are summed, part by part, in the order in which Moments has them.
template <int dim>
struct LaneMoments {
  static constexpr int pairs = Moments<dim>::pairs;
  static constexpr int mx = 1, mxx = mx + dim, mv = mxx + pairs, mvx = mv + dim, volume = mvx + dim * dim, stress = volume + 1,
                       count = stress + pairs;
  static_assert(sizeof(Moments<dim>) == count * sizeof(Real));

  static constexpr int width = lanes_of<WidePart>;

  WidePart of[(count + width - 1) / width * width], kinetic{};

  [[gnu::always_inline]] void clear()
  {
#pragma GCC unroll 64
    for (WidePart& moment : of) moment = WidePart{};
  }

  /// Positions count from the cell's corner 0.
  template <class V>
  [[gnu::always_inline]] void add(const Part<V>& part, const bodies::Block<dim>& p, const bodies::Block<dim>& q, const Vec<dim>& corner_0)
  {
    const WidePart p_mass = widened(part.get(p.mass, q.mass)), p_volume = widened(part.get(p.volume, q.volume));
    WidePart x[dim], v[dim], at[dim], square{};
    of[0] += p_mass;
    of[volume] += p_volume;
    for (int a = 0; a < dim; ++a) {
      x[a] = widened(V(part.get(p.x[a], q.x[a]) - corner_0[a]));
      v[a] = widened(part.get(p.v[a], q.v[a]));
      at[a] = p_mass * x[a];
      square += v[a] * v[a];
      of[mx + a] += at[a];
      of[mv + a] += p_mass * v[a];
    }
    kinetic += p_mass * square;
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
  [[gnu::always_inline]] void add(const Part<V>& part, const bodies::Block<dim>& p, const bodies::Block<dim>& q, const Vec<dim>& corner_0)
  {
    const V volume = part.get(p.volume, q.volume), radius = part.get(p.x[0], q.x[0]);
    const V section = radius > V{} ? volume / radius : V{};  // empty lanes may be at the axis
    area += widened(section);
    area_y += widened(V(section * (part.get(p.x[1], q.x[1]) - corner_0[1])));
    stress += widened(V(volume * part.get(p.stress[2], q.stress[2])));
  }
};

template <mesh::Metric metric, int dim>
[[gnu::always_inline]] inline void sum_moments_in(const mesh::Mesh<dim>& mesh, const bodies::Particles<dim>& particles, Index cell,
                                                  BodyGrid<dim>& grid)
{
  LaneMoments<dim> sums;
  sums.clear();
  [[maybe_unused]] LaneHoopMoments hoop_sums;
  const Vec<dim>& corner_0 = mesh.position[mesh.nodes[cell][0]];
  particles.parts(cell, [&](const auto& part) {
    sums.add(part, particles.block(part.block), particles.block(part.other), corner_0);
    if constexpr (metric == mesh::Metric::axisymmetric)
      hoop_sums.add(part, particles.block(part.block), particles.block(part.other), corner_0);
  });
  Moments<dim>& t = grid.moments[cell];
  sums.total(t);
  if (grid.kinetic.size() > 0) grid.kinetic[cell] = sum(sums.kinetic);
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
    if (particles.is_inactive(cell)) grid.deactivate(cell);
  });
}

/// A node with less than this fraction of the mass in its cells has none: the rest is round-off, which must not be divided
/// by.
constexpr Real min_mass_part = 1e-9;

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

#define BERM_INSTANTIATE(dim)                                                                                                              \
  template void sum_moments_of(const mesh::Mesh<dim>&, const bodies::Particles<dim>&, Index, BodyGrid<dim>&);                              \
  template void sum_moments(const mesh::Mesh<dim>&, const bodies::Particles<dim>&, BodyGrid<dim>&);                                        \
  template void gather_mass_and_momentum(const mesh::Mesh<dim>&, BodyGrid<dim>&);
BERM_INSTANTIATE(2)
BERM_INSTANTIATE(3)
#undef BERM_INSTANTIATE

}  // namespace berm::mpm
