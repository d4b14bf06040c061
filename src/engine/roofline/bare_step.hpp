// SPDX-License-Identifier: BSD-3-Clause
// What the roofline kernel times.
#pragma once

#include "core/for_each.hpp"
#include "core/lanes.hpp"
#include "core/rotate.hpp"
#include "core/tensor.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cstring>
#include <vector>

namespace berm::roofline {

/// Eight particles of one cell.
constexpr int bare_lanes = 8;
using BareLanes = Real __attribute__((vector_size(bare_lanes * sizeof(Real))));
template <int dim>
struct alignas(64) BareBlock {
  BareLanes x[dim], v[dim], stress[tensor_size<dim>], volume, mass, plastic;
};

/// N_k = a[k] + g[k] . x.
template <int dim>
struct BareCell {
  Real a[dim + 1], g[dim + 1][dim];
  std::array<Index, dim + 1> node;
};

template <int dim>
struct Given {
  Real mass, momentum[dim], force[dim];
};

constexpr Real dt = 1e-6, tiny_motion = 1e-9;  // particles move by a fraction, so that none leaves its cell
constexpr Real young_modulus = 7e6, poisson_ratio = 0.25, density = 1800, gravity = 9.81, cohesion = 100, friction_angle = 35 * degree;
constexpr Real bulk = young_modulus / 3 / (1 - 2 * poisson_ratio), shear = young_modulus / 2 / (1 + poisson_ratio),
               lame = bulk - 2 * shear / 3;

/// Numbers that are summed over lanes, as many at a time as a register has.
template <int count>
struct LaneSums {
  static constexpr int size = (count + bare_lanes - 1) / bare_lanes * bare_lanes;
  BareLanes of[size];

  [[gnu::always_inline]] void clear()
  {
#pragma GCC unroll 64
    for (BareLanes& x : of) x = BareLanes{};
  }
  [[gnu::always_inline]] void total(Real (&totals)[size]) const
  {
#pragma GCC unroll 64
    for (int first = 0; first < size; first += bare_lanes) {
      BareLanes some[bare_lanes];
      for (int k = 0; k < bare_lanes; ++k) some[k] = of[first + k];
      const BareLanes summed = sums(some);
      std::memcpy(totals + first, &summed, sizeof summed);
    }
  }
};

/// Mohr-Coulomb in the plane, on its face; the cone through its compressive edges in space: the least that soil with friction needs. Gives the plastic strain.
[[gnu::always_inline]] inline BareLanes return_to_strength(SymTensor<2, BareLanes>& s, Real sin_phi, Real strength)
{
  const BareLanes mean = 0.5 * (s[0] + s[1]), half = 0.5 * (s[0] - s[1]);
  const BareLanes radius = square_root(half * half + s[3] * s[3] + 1e-30), over = 2 * radius + 2 * mean * sin_phi - strength;
  const BareLanes flow = larger(over, BareLanes{}) * (1 / (4 * shear)), left = larger(radius - 2 * shear * flow, BareLanes{}) / radius;
  s[0] = mean + half * left;
  s[1] = mean - half * left;
  s[3] *= left;
  return flow;
}
[[gnu::always_inline]] inline BareLanes return_to_strength(SymTensor<3, BareLanes>& s, Real sin_phi, Real strength)
{
  const BareLanes mean = trace(s) * (1. / 3);
  for (int k = 0; k < 3; ++k) s[k] -= mean;
  const Real slope = std::sqrt(3) * (1 - sin_phi / 3);
  const BareLanes size = square_root(0.5 * double_dot(s, s) + 1e-30), over = slope * size + 2 * mean * sin_phi - strength;
  const BareLanes flow = larger(over, BareLanes{}) * (1 / (slope * shear)), left = larger(size - shear * flow, BareLanes{}) / size;
  for (int k = 0; k < tensor_size<3>; ++k) s[k] = s[k] * left + (k < 3 ? mean : BareLanes{});
  return flow;
}

/// Corners of a square or cube of side 1, in units of it, of each triangle or tetrahedron that it is cut into.
template <int dim>
std::vector<std::array<std::array<Index, dim>, dim + 1>> simplices()
{
  std::array<int, dim> order;
  for (int d = 0; d < dim; ++d) order[d] = d;
  std::vector<std::array<std::array<Index, dim>, dim + 1>> cells;
  do {
    auto& cell = cells.emplace_back();
    for (int k = 1; k <= dim; ++k) {
      cell[k] = cell[k - 1];
      ++cell[k][order[k - 1]];
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return cells;
}

/// side squares or cubes of size 1 in each direction, each cut into triangles or tetrahedra, with all that the passes need.
template <int dim>
class Bare {
public:
  using Block = BareBlock<dim>;
  using Cell = BareCell<dim>;

  Bare(Index side, int per_cell) : per_cell_(per_cell), blocks_a_cell_((per_cell + bare_lanes - 1) / bare_lanes), side_(side)
  {
    node_count_ = 1;
    BigIndex boxes = 1;
    for (int d = 0; d < dim; ++d) node_count_ *= side + 1, boxes *= side;
    const auto kinds = simplices<dim>();
    for (BigIndex box = 0; box < boxes; ++box)
      for (const auto& kind : kinds) add_cell(box, kind);
    list_entries();
    blocks_.resize(cells_.size() * blocks_a_cell_);
    for (std::size_t e = 0; e < cells_.size(); ++e) fill(static_cast<Index>(e));
    moments_.resize(cells_.size());
    given_.resize(corners * cells_.size());
    momentum_.resize(corners * cells_.size());
    acceleration_.resize(node_count_);
    velocity_.resize(node_count_);
    mass_.resize(node_count_);
    for (std::size_t e = 0; e < cells_.size(); ++e) sum_cell(static_cast<Index>(e));
  }

  BigIndex cell_count() const { return static_cast<BigIndex>(cells_.size()); }

  void step()
  {
    gather_forces();
    accelerate();
    gather_velocities();
    move();
  }

  Real checksum() const
  {
    Real total = 0;
    for (const Block& p : blocks_) total += sum(p.stress[0]);
    return total;
  }

private:
  using Vector = std::array<Real, dim>;
  static constexpr int corners = dim + 1, second_moments = dim * (dim + 1) / 2;
  /// Sums over the particles of a cell: m, m x; of each direction p, p x; m x x; the stresses.
  static constexpr int first_second = corners * corners, first_stress = first_second + second_moments,
                       sum_count = first_stress + second_moments;
  static constexpr Real cell_volume = dim == 2 ? 1. / 2 : 1. / 6;

  /// Of a symmetric tensor's component (a, c) among its sums.
  static constexpr int second_index(int a, int c) { return a == c ? a : dim + tensor_index(a, c) - 3; }

  Vector position(Index n) const
  {
    Vector x;
    for (int d = 0; d < dim; ++d, n /= side_ + 1) x[d] = n % (side_ + 1);
    return x;
  }

  void add_cell(BigIndex box, const std::array<std::array<Index, dim>, corners>& kind)
  {
    Cell cell;
    Eigen::Matrix<Real, dim + 1, dim + 1> of_corners;
    Index first[dim];
    for (int d = 0; d < dim; ++d, box /= side_) first[d] = static_cast<Index>(box % side_);
    for (int k = 0; k < corners; ++k) {
      cell.node[k] = 0;
      for (int d = dim; d-- > 0;) cell.node[k] = cell.node[k] * (side_ + 1) + first[d] + kind[k][d];
      of_corners(k, 0) = 1;
      for (int d = 0; d < dim; ++d) of_corners(k, d + 1) = first[d] + kind[k][d];
    }
    const Eigen::Matrix<Real, dim + 1, dim + 1> inverse = of_corners.inverse();
    for (int k = 0; k < corners; ++k) {
      cell.a[k] = inverse(0, k);
      for (int d = 0; d < dim; ++d) cell.g[k][d] = inverse(d + 1, k);
    }
    cells_.push_back(cell);
  }

  void list_entries()
  {
    first_.assign(node_count_ + 1, 0);
    for (const Cell& cell : cells_)
      for (const Index n : cell.node) ++first_[n + 1];
    for (BigIndex n = 0; n < node_count_; ++n) first_[n + 1] += first_[n];
    entries_.resize(corners * cells_.size());
    std::vector<Index> next(first_);
    for (std::size_t e = 0; e < cells_.size(); ++e)
      for (int k = 0; k < corners; ++k) entries_[next[cells_[e].node[k]]++] = static_cast<Index>(corners * e) + k;
  }

  /// Particles at positions of a fixed pseudo-random sequence, nearly at rest, stressed within the strength.
  void fill(Index e)
  {
    for (int k = 0; k < blocks_a_cell_ * bare_lanes; ++k) {
      Block& p = blocks_[e * blocks_a_cell_ + k / bare_lanes];
      const int l = k % bare_lanes;
      Real part[corners], total = 0;
      for (Real& one : part) total += one = -std::log(1 - next_random());  // uniform over the cell
      for (int d = 0; d < dim; ++d) {
        p.x[d][l] = 0;
        for (int c = 0; c < corners; ++c) p.x[d][l] += part[c] / total * position(cells_[e].node[c])[d];
        p.v[d][l] = 1e-3 * next_random();
      }
      p.volume[l] = k < per_cell_ ? cell_volume / per_cell_ : 0;
      p.mass[l] = density * p.volume[l];
      const Real vertical = -1e3 - 1e3 * next_random();
      for (int c = 0; c < 3; ++c) p.stress[c][l] = c == 1 ? vertical : 0.4 * vertical;
      for (int c = 3; c < tensor_size<dim>; ++c) p.stress[c][l] = 300 * (next_random() - 0.5);
      p.plastic[l] = 0;
    }
  }

  Real next_random()
  {
    random_ = random_ * 6364136223846793005u + 1442695040888963407u;
    return static_cast<Real>(random_ >> 11) * 0x1p-53;
  }

  /// A nodal field within a cell: value = f[0] + f[1] x + f[2] y ...
  [[gnu::always_inline]] static void linear(const Cell& cell, const std::vector<Vector>& field, Real (&f)[dim + 1][dim])
  {
    for (int d = 0; d < dim; ++d) {
      for (int a = 0; a <= dim; ++a) f[a][d] = 0;
      for (int k = 0; k < corners; ++k) {
        const Real value = field[cell.node[k]][d];
        f[0][d] += cell.a[k] * value;
        for (int a = 0; a < dim; ++a) f[a + 1][d] += cell.g[k][a] * value;
      }
    }
  }
  [[gnu::always_inline]] static BareLanes value_at(const Real (&f)[dim + 1][dim], int d, const BareLanes (&x)[dim])
  {
    BareLanes value = f[0][d] + f[1][d] * x[0];
    for (int a = 1; a < dim; ++a) value += f[a + 1][d] * x[a];
    return value;
  }
  /// A corner's share of a quantity of which the sum and the sums times x are given.
  [[gnu::always_inline]] static Real share(const Cell& cell, int k, const Real* sums)
  {
    Real total = cell.a[k] * sums[0];
    for (int a = 0; a < dim; ++a) total += cell.g[k][a] * sums[a + 1];
    return total;
  }

  void sum_cell(Index e)
  {
    using Sums = LaneSums<sum_count>;
    Sums lanes;
    lanes.clear();
    for (int b = 0; b < blocks_a_cell_; ++b) {
      const Block& p = blocks_[e * blocks_a_cell_ + b];
      BareLanes mx[dim];
      lanes.of[0] += p.mass;
      for (int a = 0; a < dim; ++a) lanes.of[1 + a] += mx[a] = p.mass * p.x[a];
      for (int d = 0; d < dim; ++d) {
        BareLanes* of = lanes.of + (d + 1) * corners;
        of[0] += p.mass * p.v[d];
        for (int a = 0; a < dim; ++a) of[1 + a] += mx[a] * p.v[d];
      }
      for (int a = 0; a < dim; ++a)
        for (int c = a; c < dim; ++c) lanes.of[first_second + second_index(a, c)] += mx[a] * p.x[c];
      for (int a = 0; a < dim; ++a) lanes.of[first_stress + a] += p.volume * p.stress[a];
      for (int c = 3; c < tensor_size<dim>; ++c) lanes.of[first_stress + dim + c - 3] += p.volume * p.stress[c];
    }
    Real s[Sums::size];
    lanes.total(s);
    std::copy_n(s, first_stress, moments_[e].data());
    const Real* stress = s + first_stress;
    const Cell& cell = cells_[e];
    for (int k = 0; k < corners; ++k) {
      Given<dim>& given = given_[corners * e + k];
      given.mass = share(cell, k, s);
      for (int d = 0; d < dim; ++d) {
        given.momentum[d] = share(cell, k, s + (d + 1) * corners);
        Real force = 0;
        for (int a = 0; a < dim; ++a) force += cell.g[k][a] * stress[second_index(a, d)];
        given.force[d] = -force - (d == 1 ? gravity * given.mass : 0);
      }
    }
  }

  void gather_forces()
  {
    for_each("ceiling: nodes", static_cast<Index>(node_count_), [&](Index n) {
      Given<dim> total{};
      for (Index j = first_[n]; j < first_[n + 1]; ++j) {
        const Given<dim>& part = given_[entries_[j]];
        total.mass += part.mass;
        for (int d = 0; d < dim; ++d) total.momentum[d] += part.momentum[d], total.force[d] += part.force[d];
      }
      mass_[n] = total.mass;
      for (int d = 0; d < dim; ++d) acceleration_[n][d] = total.mass > 0 ? tiny_motion * total.force[d] / total.mass : 0;
    });
  }

  /// What the particles' momentum will be at the corners, from the moments: with the acceleration f(x), p + dt f(x) m.
  void accelerate()
  {
    for_each("ceiling: accelerations", static_cast<Index>(cells_.size()), [&](Index e) {
      Real f[dim + 1][dim];
      linear(cells_[e], acceleration_, f);
      const Real* s = moments_[e].data();
      for (int d = 0; d < dim; ++d) {
        Real sums[corners];
        for (int b = 0; b < corners; ++b) {
          sums[b] = s[(d + 1) * corners + b] + dt * f[0][d] * s[b];
          for (int a = 0; a < dim; ++a) sums[b] += dt * f[a + 1][d] * (b == 0 ? s[1 + a] : s[first_second + second_index(a, b - 1)]);
        }
        for (int k = 0; k < corners; ++k) momentum_[corners * e + k][d] = share(cells_[e], k, sums);
      }
    });
  }

  void gather_velocities()
  {
    for_each("ceiling: nodes", static_cast<Index>(node_count_), [&](Index n) {
      Vector total{};
      for (Index j = first_[n]; j < first_[n + 1]; ++j)
        for (int d = 0; d < dim; ++d) total[d] += momentum_[entries_[j]][d];
      for (int d = 0; d < dim; ++d) velocity_[n][d] = mass_[n] > 0 ? total[d] / mass_[n] : 0;
    });
  }

  /// Groups of cells, whose particles are summed for the next step while they are in the cache.
  void move()
  {
    constexpr Index group = 16;
    const auto cells = static_cast<Index>(cells_.size());
    for_each("ceiling: velocities, positions, strain, stress, sums", (cells + group - 1) / group, [&](Index g) {
      const Index end = std::min(cells, (g + 1) * group);
      for (Index e = g * group; e < end; ++e) move_cell(e);
      for (Index e = g * group; e < end; ++e) sum_cell(e);
    });
  }

  [[gnu::always_inline]] void move_cell(Index e)
  {
    const Real sin_phi = std::sin(friction_angle), strength = 2 * cohesion * std::cos(friction_angle);
    const Cell& cell = cells_[e];
    Real acceleration[dim + 1][dim], f[dim + 1][dim], volume = 0, strain[dim][dim], rotation[dim][dim];
    linear(cell, acceleration_, acceleration);
    linear(cell, velocity_, f);
    for (int a = 0; a < dim; ++a) {
      volume += f[a + 1][a] * dt;
      for (int b = 0; b < dim; ++b) {
        strain[a][b] = 0.5 * dt * (f[b + 1][a] + f[a + 1][b]);
        rotation[a][b] = 0.5 * dt * (f[b + 1][a] - f[a + 1][b]);
      }
    }
    for (int b = 0; b < blocks_a_cell_; ++b) {
      Block& p = blocks_[e * blocks_a_cell_ + b];
      BareLanes motion[dim];
      for (int d = 0; d < dim; ++d) p.v[d] += dt * value_at(acceleration, d, p.x), motion[d] = value_at(f, d, p.x);
      for (int d = 0; d < dim; ++d) p.x[d] += tiny_motion * dt * motion[d];
      BareLanes min = 1 - BareLanes{};
      for (int k = 0; k < corners; ++k) {
        BareLanes n = cell.a[k] - BareLanes{};
        for (int d = 0; d < dim; ++d) n += cell.g[k][d] * p.x[d];
        min = smaller(min, n);
      }
      if (any(min < -1e-6 - BareLanes{})) [[unlikely]]
        p.plastic = BareLanes{};
      SymTensor<dim, BareLanes> s;
      for (int c = 0; c < tensor_size<dim>; ++c) s[c] = p.stress[c];
      rotate(s, rotation);
      for (int c = 0; c < 3; ++c) s[c] += lame * volume;
      for (int a = 0; a < dim; ++a)
        for (int c = a; c < dim; ++c) s[tensor_index(a, c)] += 2 * shear * strain[a][c];
      p.volume *= 1 + volume;
      p.plastic += return_to_strength(s, sin_phi, strength);
      for (int c = 0; c < tensor_size<dim>; ++c) p.stress[c] = s[c];
    }
  }

  int per_cell_, blocks_a_cell_;
  Index side_;
  BigIndex node_count_;
  std::uint64_t random_ = 1;
  std::vector<Cell> cells_;
  std::vector<Index> first_, entries_;
  std::vector<Block> blocks_;
  std::vector<std::array<Real, first_stress>> moments_;
  std::vector<Given<dim>> given_;
  std::vector<Vector> momentum_, acceleration_, velocity_;
  std::vector<Real> mass_;
};

}  // namespace berm::roofline
