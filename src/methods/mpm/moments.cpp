// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/moments.hpp"

#include "core/widened.hpp"

namespace berm::mpm {
namespace {

/// The sums of a cell in lanes while they are added up, part by part; n are the shape functions of the corners but the first.
template <int dim>
struct LaneMoments {
  static constexpr int pairs = Moments<dim>::pairs;
  static constexpr int mn = 1, mnn = mn + dim, mv = mnn + pairs, mvn = mv + dim, volume = mvn + dim * dim, stress = volume + 1,
                       kinetic = stress + pairs, count = kinetic + 1;

  static constexpr int width = lanes_of<WidePart>, rows = (count + width - 1) / width;

  WidePart of[rows * width];

  [[gnu::always_inline]] void clear()
  {
#pragma GCC unroll 64
    for (WidePart& moment : of) moment = WidePart{};
  }

  template <class V>
  [[gnu::always_inline]] void add(const Part<V>& part, const bodies::Block<dim>& p, const bodies::Block<dim>& q,
                                  const mesh::Shape<dim>& shape)
  {
    const WidePart p_mass = widened(part.get(p.mass, q.mass)), p_volume = widened(part.get(p.volume, q.volume));
    V x[dim];
    WidePart v[dim], n[dim], at[dim], square{};
    of[0] += p_mass;
    of[volume] += p_volume;
    for (int a = 0; a < dim; ++a) x[a] = part.get(p.x[a], q.x[a]) - shape.origin[a];
    for (int a = 0; a < dim; ++a) {
      V n_a = shape.gradients[a][0] * x[0];
      for (int d = 1; d < dim; ++d) n_a += shape.gradients[a][d] * x[d];
      n[a] = widened(n_a);
      v[a] = widened(part.get(p.v[a], q.v[a]));
      at[a] = p_mass * n[a];
      square += v[a] * v[a];
      of[mn + a] += at[a];
      of[mv + a] += p_mass * v[a];
    }
    of[kinetic] += p_mass * square;
    for (int a = 0; a < dim; ++a)
      for (int b = a; b < dim; ++b) {
        of[mnn + Moments<dim>::pair(a, b)] += at[a] * n[b];
        const int index = tensor_index(a, b);
        of[stress + Moments<dim>::pair(a, b)] += p_volume * widened(part.get(p.stress[index], q.stress[index]));
      }
    for (int a = 0; a < dim; ++a)
      for (int d = 0; d < dim; ++d) of[mvn + a * dim + d] += at[a] * v[d];
  }

  /// The moments of the cell, what it gives its corners of mass, momentum and volume, and sum m v.v. As many sums as fit a register are made at a time.
  [[gnu::always_inline]] Real total(Moments<dim>& t, std::array<CornerSums<dim>, dim + 1>& corners) const
  {
    using M = Moments<dim>;
    alignas(WidePart) Real sum[rows * width];
#pragma GCC unroll 64
    for (int first = 0; first < count; first += width) {
      WidePart some[width];
      for (int k = 0; k < width; ++k) some[k] = of[first + k];
      *reinterpret_cast<WidePart*>(sum + first) = sums(some);
    }
    Real mass_of_0 = sum[0], with_others = 0;
    Components<dim> momentum_of_0 = components<dim>(sum + mv);
#pragma GCC unroll 4
    for (int k = 1; k <= dim; ++k) {
      const Components<dim> momentum = components<dim>(sum + mvn + (k - 1) * dim);
      Real with_0 = sum[mn + k - 1];
#pragma GCC unroll 4
      for (int l = 1; l <= dim; ++l) {
        const Real with_l = sum[mnn + M::pair(std::min(k, l) - 1, std::max(k, l) - 1)];
        with_0 -= with_l;
        if (l >= k) t.mass[M::corner_pair(k, l)] = with_l;
      }
      t.mass[M::corner_pair(0, k)] = with_0;
      with_others += with_0;
      mass_of_0 -= sum[mn + k - 1];
      momentum_of_0 -= momentum;
      corners[k].mass = sum[mn + k - 1];
      store<dim>(momentum, t.momentum[k]);
      store<dim>(momentum, corners[k].sum);
    }
    t.mass[M::corner_pair(0, 0)] = mass_of_0 - with_others;
    store<dim>(momentum_of_0, t.momentum[0]);
    store<dim>(momentum_of_0, corners[0].sum);
    corners[0].mass = mass_of_0;
    t.volume = sum[volume];
    for (int k = 0; k < pairs; ++k) t.stress[k] = sum[stress + k];
    for (CornerSums<dim>& corner : corners) corner.volume = sum[volume];
    return sum[kinetic];
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
  const mesh::Shape<dim> shape = grid.shape(mesh, cell);
  particles.parts(cell, [&](const auto& part) {
    sums.add(part, particles.block(part.block), particles.block(part.other), shape);
    if constexpr (metric == mesh::Metric::axisymmetric)
      hoop_sums.add(part, particles.block(part.block), particles.block(part.other), shape.origin);
  });
  const Real kinetic = sums.total(grid.moments[cell], grid.corners[cell]);
  if (!grid.kinetic.empty()) grid.kinetic[cell] = kinetic;
  if constexpr (metric == mesh::Metric::axisymmetric) grid.hoop[cell] = {sum(hoop_sums.area), sum(hoop_sums.area_y), sum(hoop_sums.stress)};
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
constexpr Real min_mass_fraction = 1e-9;

template <int dim>
Real mass_of_cells(const mesh::Mesh<dim>& mesh, const BodyGrid<dim>& grid, Index node)
{
  Real mass = 0;
  for (Index e = mesh.first_entry[node]; e < mesh.first_entry[node + 1]; ++e)
    mass += grid.moments[mesh.entries[e] / (dim + 1)].total_mass();
  return mass;
}

template <int dim>
void gather_mass_and_momentum(const mesh::Mesh<dim>& mesh, BodyGrid<dim>& grid)
{
  for_each("gather mass and momentum", grid.chunks, [&](Index n) {
    const Index i = grid.nodes[n];
    Components<dim> momentum{};
    Real mass = 0, volume = 0, min_volume = infinity;
    for (Index e = mesh.first_entry[i]; e < mesh.first_entry[i + 1]; ++e) {
      const CornerSums<dim>& corner = grid.at(mesh.entries[e]);
      momentum += components<dim>(corner.sum);
      mass += corner.mass;
      volume += corner.volume;
      min_volume = std::min(min_volume, corner.volume);
    }
    if (grid.full_cells) grid.fill[i] = min_volume > 0 ? volume / grid.volume_around[i] : 0;
    // Most nodes have more than that fraction of the whole body.
    if (!(mass > min_mass_fraction * grid.total_mass) && !(mass > min_mass_fraction * mass_of_cells(mesh, grid, i))) mass = 0;
    grid.mass[i] = mass;
    store<dim>(momentum * (mass > 0 ? 1 / mass : 0), grid.velocity[i]);
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
