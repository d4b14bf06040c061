// SPDX-License-Identifier: BSD-3-Clause
// What the roofline kernel times.
#pragma once

#include "bodies/particles.hpp"
#include "core/rotate.hpp"
#include "core/widened.hpp"

#include <cstring>

namespace berm::roofline {

constexpr Real dt = 1e-15;  // s: so short that nothing leaves its cell and stresses stay as they are
constexpr Real young_modulus = 7e6, poisson_ratio = 0.25, gravity = 9.81, cohesion = 100, friction_angle = 35 * degree;
constexpr Real bulk = young_modulus / 3 / (1 - 2 * poisson_ratio), shear = young_modulus / 2 / (1 + poisson_ratio),
               lame = bulk - 2 * shear / 3;

/// What a cell gives to a node at a corner.
template <int dim>
struct Given {
  Real mass, force[dim];
};

/// Numbers that are summed over lanes, as many at a time as a register has.
template <int count>
struct LaneSums {
  static constexpr int width = lanes_of<WidePart>, size = (count + width - 1) / width * width;
  WidePart of[size];

  [[gnu::always_inline]] void clear()
  {
#pragma GCC unroll 64
    for (WidePart& x : of) x = WidePart{};
  }
  [[gnu::always_inline]] void total(Real (&totals)[size]) const
  {
#pragma GCC unroll 64
    for (int first = 0; first < size; first += width) {
      WidePart some[width];
      for (int k = 0; k < width; ++k) some[k] = of[first + k];
      const WidePart summed = sums(some);
      std::memcpy(totals + first, &summed, sizeof summed);
    }
  }
};

/// Mohr-Coulomb in the plane, on its face; the cone through its compressive edges in space: the least that soil with friction needs. Gives the plastic strain.
template <class V>
[[gnu::always_inline]] inline V return_to_strength(SymTensor<2, V>& s, Real sin_phi, Real strength)
{
  const V mean = 0.5 * (s[0] + s[1]), half = 0.5 * (s[0] - s[1]);
  const V radius = square_root(half * half + s[3] * s[3] + 1e-30), over = 2 * radius + 2 * mean * sin_phi - strength;
  const V flow = larger(over, V{}) * (1 / (4 * shear)), left = larger(radius - 2 * shear * flow, V{}) / radius;
  s[0] = mean + half * left;
  s[1] = mean - half * left;
  s[3] *= left;
  return flow;
}
template <class V>
[[gnu::always_inline]] inline V return_to_strength(SymTensor<3, V>& s, Real sin_phi, Real strength)
{
  const V mean = trace(s) * (1. / 3);
  for (int k = 0; k < 3; ++k) s[k] -= mean;
  const Real slope = std::sqrt(3) * (1 - sin_phi / 3);
  const V size = square_root(0.5 * double_dot(s, s) + 1e-30), over = slope * size + 2 * mean * sin_phi - strength;
  const V flow = larger(over, V{}) * (1 / (slope * shear)), left = larger(size - shear * flow, V{}) / size;
  for (int k = 0; k < tensor_size<3>; ++k) s[k] = s[k] * left + (k < 3 ? mean : V{});
  return flow;
}

/// A copy of the particles of a body as they lie in their cells, and what the passes need of these. Loops have the labels of those of berm's step that do the same
/// and more.
template <int dim>
class Bare {
public:
  Bare(const mesh::Mesh<dim>& mesh, const bodies::Particles<dim>& particles) : particles_(particles)
  {
    for (const Index cell : particles_.occupied()) cells_.push_back({cell, mesh.shape(cell), mesh.nodes[cell]});
    number_nodes();
    moments_.resize(cells_.size());
    given_.resize(corners * cells_.size());
    momentum_.resize(corners * cells_.size());
    acceleration_.resize(node_count());
    velocity_.resize(node_count());
    mass_.resize(node_count());
    for (Index c = 0; c < cell_count(); ++c) sum_cell(c);
  }

  Index cell_count() const { return static_cast<Index>(cells_.size()); }

  void step()
  {
    gather_forces();
    accelerate();
    gather_velocities();
    move();
  }

  /// Calls visit(part) for the parts in which the passes take the particles.
  template <class Visit>
  void for_each_part(const Visit& visit) const
  {
    for (const Cell& cell : cells_) particles_.parts(cell.cell, visit);
  }

  /// The sum of the volume times the stress along x of all particles, Pa m2 (per metre run) or Pa m3.
  Real checksum() const
  {
    Real total = 0;
    for (const Cell& cell : cells_)
      for (const auto& [p, b, count] : particles_.blocks_in(cell.cell)) total += sum(Lanes(p.volume * p.stress[0]));
    return total;
  }

private:
  using Vector = std::array<Real, dim>;
  static constexpr int corners = dim + 1, pairs = dim * (dim + 1) / 2;
  /// Sums over the particles of a cell: m, m x; of each direction p, p x; m x x; the stresses. x counts from corner 0.
  static constexpr int first_second = corners * corners, first_stress = first_second + pairs, sum_count = first_stress + pairs;

  struct Cell {
    Index cell;  ///< of the mesh
    mesh::Shape<dim> shape;
    std::array<Index, corners> node;
  };
  /// A nodal field within a cell: value[d] = first[d] + slope[d] . x.
  struct Linear {
    Real first[dim], slope[dim][dim] = {};

    [[gnu::always_inline]] Linear(const Cell& cell, const std::vector<Vector>& field)
    {
      for (int d = 0; d < dim; ++d) {
        first[d] = field[cell.node[0]][d];
        for (int k = 0; k < dim; ++k)
          for (int a = 0; a < dim; ++a) slope[d][a] += cell.shape.gradients[k][a] * (field[cell.node[k + 1]][d] - first[d]);
      }
    }
    template <class V>
    [[gnu::always_inline]] V at(int d, const V (&x)[dim]) const
    {
      V value = first[d] + slope[d][0] * x[0];
      for (int a = 1; a < dim; ++a) value += slope[d][a] * x[a];
      return value;
    }
  };

  Index node_count() const { return static_cast<Index>(first_.size()) - 1; }

  /// Of a symmetric tensor's component (a, c) among its sums.
  static constexpr int second_index(int a, int c) { return a == c ? a : dim + tensor_index(a, c) - 3; }

  /// Calls give(k, share) with what the corners get of a quantity of which the sum and the sums times x are given.
  template <class Give>
  [[gnu::always_inline]] static void share(const Cell& cell, const Real* sums, const Give& give)
  {
    Real left = sums[0];
    for (int k = 0; k < dim; ++k) {
      Real part = 0;
      for (int a = 0; a < dim; ++a) part += cell.shape.gradients[k][a] * sums[a + 1];
      left -= part;
      give(k + 1, part);
    }
    give(0, left);
  }

  /// Numbers the nodes of the cells anew, in the order of the mesh, and lists what each gets.
  void number_nodes()
  {
    std::vector<Index> used;
    for (const Cell& cell : cells_) used.insert(used.end(), cell.node.begin(), cell.node.end());
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    first_.assign(used.size() + 1, 0);
    for (Cell& cell : cells_)
      for (Index& node : cell.node) {
        node = static_cast<Index>(std::lower_bound(used.begin(), used.end(), node) - used.begin());
        ++first_[node + 1];
      }
    for (Index n = 0; n < node_count(); ++n) first_[n + 1] += first_[n];
    entries_.resize(corners * cells_.size());
    std::vector<Index> next(first_);
    for (Index c = 0; c < cell_count(); ++c)
      for (int k = 0; k < corners; ++k) entries_[next[cells_[c].node[k]]++] = corners * c + k;
  }

  void sum_cell(Index c)
  {
    using Sums = LaneSums<sum_count>;
    Sums lanes;
    lanes.clear();
    const Cell& cell = cells_[c];
    particles_.parts(cell.cell, [&](const auto& part) {
      const bodies::Block<dim>&p = particles_.block(part.block), &q = particles_.block(part.other);
      const WidePart mass = widened(part.get(p.mass, q.mass)), volume = widened(part.get(p.volume, q.volume));
      WidePart x[dim], mx[dim];
      lanes.of[0] += mass;
      for (int a = 0; a < dim; ++a) {
        x[a] = widened(part.get(p.x[a], q.x[a])) - cell.shape.origin[a];
        lanes.of[1 + a] += mx[a] = mass * x[a];
      }
      for (int d = 0; d < dim; ++d) {
        const WidePart v = widened(part.get(p.v[d], q.v[d]));
        WidePart* of = lanes.of + (d + 1) * corners;
        of[0] += mass * v;
        for (int a = 0; a < dim; ++a) of[1 + a] += mx[a] * v;
      }
      for (int a = 0; a < dim; ++a)
        for (int b = a; b < dim; ++b) lanes.of[first_second + second_index(a, b)] += mx[a] * x[b];
      const auto add_stress = [&](int sum, int component) {
        lanes.of[first_stress + sum] += volume * widened(part.get(p.stress[component], q.stress[component]));
      };
      for (int a = 0; a < dim; ++a) add_stress(a, a);
      for (int k = 3; k < tensor_size<dim>; ++k) add_stress(dim + k - 3, k);
    });
    Real s[Sums::size];
    lanes.total(s);
    std::copy_n(s, first_stress, moments_[c].data());
    Given<dim>* given = &given_[corners * c];
    share(cell, s, [&](int k, Real mass) { given[k].mass = mass; });
    for (int d = 0; d < dim; ++d) {
      Real of_stress[corners] = {};
      for (int a = 0; a < dim; ++a) of_stress[a + 1] = -s[first_stress + second_index(std::min(a, d), std::max(a, d))];
      share(cell, of_stress, [&](int k, Real force) { given[k].force[d] = force; });
    }
  }

  void gather_forces()
  {
    for_each("momentum balance of nodes", node_count(), [&](Index n) {
      Given<dim> total{};
      for (Index j = first_[n]; j < first_[n + 1]; ++j) {
        const Given<dim>& part = given_[entries_[j]];
        total.mass += part.mass;
        for (int d = 0; d < dim; ++d) total.force[d] += part.force[d];
      }
      mass_[n] = total.mass;
      const Real per_mass = total.mass > 0 ? 1 / total.mass : 0;
      for (int d = 0; d < dim; ++d) acceleration_[n][d] = total.force[d] * per_mass - (d == 1 ? gravity : 0);
    });
  }

  /// What the particles' momentum will be at the corners, from the moments: with the acceleration f(x), p + dt f(x) m.
  void accelerate()
  {
    for_each("momentum after the forces", cell_count(), [&](Index c) {
      const Linear f(cells_[c], acceleration_);
      const Real* s = moments_[c].data();
      for (int d = 0; d < dim; ++d) {
        const Real* of_d = s + (d + 1) * corners;
        Real sums[corners], gain = f.first[d] * s[0];
        for (int a = 0; a < dim; ++a) gain += f.slope[d][a] * s[1 + a];
        sums[0] = of_d[0] + dt * gain;
        for (int b = 0; b < dim; ++b) {
          gain = f.first[d] * s[1 + b];
          for (int a = 0; a < dim; ++a) gain += f.slope[d][a] * s[first_second + second_index(std::min(a, b), std::max(a, b))];
          sums[1 + b] = of_d[1 + b] + dt * gain;
        }
        share(cells_[c], sums, [&](int k, Real momentum) { momentum_[corners * c + k][d] = momentum; });
      }
    });
  }

  void gather_velocities()
  {
    for_each("gather new velocities", node_count(), [&](Index n) {
      Vector total{};
      for (Index j = first_[n]; j < first_[n + 1]; ++j)
        for (int d = 0; d < dim; ++d) total[d] += momentum_[entries_[j]][d];
      const Real per_mass = mass_[n] > 0 ? 1 / mass_[n] : 0;
      for (int d = 0; d < dim; ++d) velocity_[n][d] = total[d] * per_mass;
    });
  }

  /// Groups of cells, whose particles are summed for the next step while they are in the cache.
  void move()
  {
    constexpr Index group = 16;
    const Index cells = cell_count();
    for_each("move and strain particles", (cells + group - 1) / group, [&](Index g) {
      const Index end = std::min(cells, (g + 1) * group);
      for (Index c = g * group; c < end; ++c) move_cell(c);
      for (Index c = g * group; c < end; ++c) sum_cell(c);
    });
  }

  [[gnu::always_inline]] void move_cell(Index c)
  {
    const Real sin_phi = std::sin(friction_angle), strength = 2 * cohesion * std::cos(friction_angle);
    const Cell& cell = cells_[c];
    particles_.prefetch_after(c);
    const Linear acceleration(cell, acceleration_), velocity(cell, velocity_);
    Real volume = 0, strain[dim][dim], rotation[dim][dim];
    for (int a = 0; a < dim; ++a) {
      volume += velocity.slope[a][a] * dt;
      for (int b = 0; b < dim; ++b) {
        strain[a][b] = 0.5 * dt * (velocity.slope[a][b] + velocity.slope[b][a]);
        rotation[a][b] = 0.5 * dt * (velocity.slope[a][b] - velocity.slope[b][a]);
      }
    }
    particles_.parts(cell.cell, [&](const auto& part) {
      using V = typename std::decay_t<decltype(part)>::Vector;
      bodies::Block<dim>&p = particles_.block(part.block), &q = particles_.block(part.other);
      V x[dim], min = 1 - V{}, of_corner_0 = 1 - V{};
      for (int d = 0; d < dim; ++d) x[d] = part.get(p.x[d], q.x[d]) - cell.shape.origin[d];
      for (int d = 0; d < dim; ++d) {
        part.set(p.v[d], q.v[d], part.get(p.v[d], q.v[d]) + dt * acceleration.at(d, x));
        part.set(p.x[d], q.x[d], part.get(p.x[d], q.x[d]) + dt * velocity.at(d, x));
      }
      for (int k = 0; k < dim; ++k) {
        V n = cell.shape.gradients[k][0] * x[0];
        for (int d = 1; d < dim; ++d) n += cell.shape.gradients[k][d] * x[d];
        min = smaller(min, n);
        of_corner_0 -= n;
      }
      SymTensor<dim, V> s;
      for (int k = 0; k < tensor_size<dim>; ++k) s[k] = part.get(p.stress[k], q.stress[k]);
      rotate(s, rotation);
      for (int k = 0; k < 3; ++k) s[k] += lame * volume;
      for (int a = 0; a < dim; ++a)
        for (int b = a; b < dim; ++b) s[tensor_index(a, b)] += 2 * shear * strain[a][b];
      V plastic = part.get(p.deviatoric_strain, q.deviatoric_strain) + return_to_strength(s, sin_phi, strength);
      if (any(part.alive() & (smaller(min, of_corner_0) < -1e-6 - V{}))) [[unlikely]]
        plastic = V{};
      part.set(p.deviatoric_strain, q.deviatoric_strain, plastic);
      part.set(p.volume, q.volume, part.get(p.volume, q.volume) * (1 + volume));
      for (int k = 0; k < tensor_size<dim>; ++k) part.set(p.stress[k], q.stress[k], s[k]);
    });
  }

  bodies::Particles<dim> particles_;
  std::vector<Cell> cells_;
  std::vector<Index> first_, entries_;
  std::vector<std::array<Real, first_stress>> moments_;
  std::vector<Given<dim>> given_;
  std::vector<Vector> momentum_, acceleration_, velocity_;
  std::vector<Real> mass_;
};

}  // namespace berm::roofline
