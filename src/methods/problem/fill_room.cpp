// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/problem/fill_room_test.cpp
#include "problem/fill_room.hpp"

#include "bodies/fill.hpp"

#include <algorithm>
#include <cmath>

namespace berm::problem {
namespace {

/// Points a side by which a cell, and the square of a particle, are divided at the bounds of a region.
template <int dim>
constexpr int cell_divisions = dim == 2 ? 40 : 12;
template <int dim>
constexpr int square_divisions = dim == 2 ? 10 : 6;

constexpr int power(int base, int exponent)
{
  return exponent == 0 ? 1 : base * power(base, exponent - 1);
}

}  // namespace

template <int dim>
bool comes_near(const Model<dim>& model, const Earthwork<dim>& work, const Slab& slab, Index cell)
{
  Real left = infinity, right = -infinity;
  for (const Vec<2>& corner : work.corners) left = std::min(left, corner[0]), right = std::max(right, corner[0]);
  Vec<dim> lower = Vec<dim>::Constant(infinity), upper = -lower;
  for (const Index node : model.mesh.nodes[cell]) {
    lower = lower.cwiseMin(model.mesh.position[node]);
    upper = upper.cwiseMax(model.mesh.position[node]);
  }
  return lower[0] <= right && upper[0] >= left && lower[1] <= slab.top && upper[1] >= slab.bottom;
}

template <int dim>
Real WorkRegion<dim>::distance(const Vec<dim>& x) const
{
  Real most = std::max({surface_at(work.area, x).distance, slab.bottom - x[1], x[1] - slab.top});
  if (dim == 3) most = std::max({most, work.z_range[0] - x[dim - 1], x[dim - 1] - work.z_range[1]});
  for (const bodies::RigidShape<dim>& hole : holes) most = std::max(most, -surface_at(hole, x).distance);
  return most;
}

template <int dim>
Real WorkRegion<dim>::volume() const
{
  const mesh::Mesh<dim>& mesh = model.mesh;
  const bodies::CellPoints<dim> points(power(cell_divisions<dim>, dim));
  Real sum = 0;
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
    if (!comes_near(model, work, slab, cell)) continue;
    Vec<dim> center = Vec<dim>::Zero();
    for (const Index node : mesh.nodes[cell]) center += mesh.position[node] / (dim + 1);
    Real reach = 0;
    for (const Index node : mesh.nodes[cell]) reach = std::max(reach, (mesh.position[node] - center).norm());
    const Real away = distance(center), section = mesh.section(cell);
    if (away <= -reach)
      sum += section * weight_at(mesh.metric, center);
    else if (away < reach)
      for (int k = 0; k < points.count(); ++k)
        if (const Vec<dim> x = points.at(mesh, cell, k); holds(x)) sum += section / points.count() * weight_at(mesh.metric, x);
  }
  return sum;
}

template <int dim>
Real WorkRegion<dim>::fraction_within(const Vec<dim>& x, Real section) const
{
  constexpr int n = square_divisions<dim>, count = power(n, dim);
  const Real width = std::pow(section, 1. / dim), reach = width / 2 * std::sqrt(Real(dim)), away = distance(x);
  if (away <= -reach) return 1;
  if (away >= reach) return 0;
  int inside = 0;
  for (int k = 0; k < count; ++k) {
    Vec<dim> at = x;
    for (int d = 0, rest = k; d < dim; ++d, rest /= n) at[d] += width * ((rest % n + 0.5) / n - 0.5);
    inside += holds(at);
  }
  return Real(inside) / count;
}

template <int dim>
SoilAround<dim>::SoilAround(const State<dim>& state, const WorkRegion<dim>& region, std::int32_t first)
    : region_(region),
      mesh_(region.model.mesh)
{
  auto near = NodeField<std::uint8_t>::zeros(mesh_.node_count());
  for (Index cell = 0; cell < mesh_.cell_count(); ++cell)
    if (comes_near(region.model, region.work, region.slab, cell))
      for (const Index node : mesh_.nodes[cell]) near[node] = 1;
  std::vector<Neighbour> own;
  for (std::size_t body = 0; body < state.particles.size(); ++body) {
    const bodies::Particles<dim>& particles = state.particles[body];
    const bool of_fill = static_cast<Index>(body) == region.work.body;
    for (const Index cell : particles.occupied()) {
      const auto& nodes = mesh_.nodes[cell];
      if (std::none_of(nodes.begin(), nodes.end(), [&](Index node) { return near[node] != 0; })) continue;
      for (Index index = 0; index < particles.count_in(cell); ++index) {
        const bodies::Particle<dim> p = particles.read_at(cell, index);
        own.push_back({cell, p.x, p.volume, of_fill && p.id >= first});
      }
    }
  }
  Ranks::of_run().gather(own, all_);
  std::stable_sort(all_.begin(), all_.end(), [](const auto& a, const auto& b) { return a.cell < b.cell; });
}

template <int dim>
bool SoilAround<dim>::has_room(Index cell, const Vec<dim>& x, Real section) const
{
  constexpr Real apart = 0.75, apart_of_fill = 0.5, full = 0.9;
  const mesh::Shape<dim> shape = mesh_.shape(cell);
  Real filled = 0;
  for (int k = 0; k <= dim; ++k) {
    Real taken = 0, whole = 0;
    const Index node = mesh_.nodes[cell][k];
    for (Index e = mesh_.first_entry[node]; e < mesh_.first_entry[node + 1]; ++e) {
      const Index around = mesh_.entries[e] / (dim + 1);
      whole += mesh_.section(around);
      for (auto p = first_in(around); p != all_.end() && p->cell == around; ++p) {
        const Real width = std::pow(std::max(section, section_of(*p)), 1. / dim);
        if ((p->x - x).norm() < (p->came_since ? apart_of_fill : apart) * width) return false;
        taken += section_of(*p);
      }
    }
    filled += shape.value(k, x) * taken / whole;
  }
  return filled < full;
}

template <int dim>
Real SoilAround<dim>::volume_in_region() const
{
  Real sum = 0;
  for (const Neighbour& p : all_) sum += p.volume * region_.fraction_within(p.x, section_of(p));
  return sum;
}

template <int dim>
Real SoilAround<dim>::section_of(const Neighbour& p) const
{
  return mesh::section_of(mesh_.metric, p.volume, p.x);
}

template <int dim>
auto SoilAround<dim>::first_in(Index cell) const
{
  return std::lower_bound(all_.begin(), all_.end(), cell, [](const Neighbour& p, Index wanted) { return p.cell < wanted; });
}

#define BERM_INSTANTIATE(dim)                                                                                                              \
  template bool comes_near(const Model<dim>&, const Earthwork<dim>&, const Slab&, Index);                                                  \
  template struct WorkRegion<dim>;                                                                                                         \
  template class SoilAround<dim>;
BERM_INSTANTIATE(2)
BERM_INSTANTIATE(3)
#undef BERM_INSTANTIATE

}  // namespace berm::problem
