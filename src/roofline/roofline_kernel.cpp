// SPDX-License-Identifier: BSD-3-Clause
#include "roofline/roofline_kernel.hpp"

#include "core/for_each.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <tuple>
#include <vector>

namespace berm::roofline {
namespace {

using Clock = std::chrono::steady_clock;

/// Eight particles of one cell.
constexpr int bare_lanes = 8;
using BareLanes = Real __attribute__((vector_size(bare_lanes * sizeof(Real))));
struct alignas(64) BareBlock {
  BareLanes x[2], v[2], stress[4], volume, mass, plastic;  // stress: xx, yy, zz, xy
};

/// N_k = a[k] + b[k] x + c[k] y.
struct BareCell {
  Real a[3], b[3], c[3];
  Index node[3];
};

struct Given {
  Real mass, momentum[2], force[2];
};

constexpr Real dt = 1e-6, tiny_motion = 1e-9;  // particles move by a fraction, so that none leaves its cell
constexpr Real young_modulus = 7e6, poisson_ratio = 0.25, density = 1800, gravity = 9.81, cohesion = 100;
constexpr Real bulk = young_modulus / 3 / (1 - 2 * poisson_ratio), shear = young_modulus / 2 / (1 + poisson_ratio),
               lame = bulk - 2 * shear / 3;

/// A square of side x side squares of size 1, each cut into two triangles, with all that the passes need.
class Bare {
public:
  Bare(Index side, int per_cell) : per_cell_(per_cell), blocks_a_cell_((per_cell + bare_lanes - 1) / bare_lanes), side_(side)
  {
    for (Index j = 0; j < side; ++j)
      for (Index i = 0; i < side; ++i) {
        add_cell({node(i, j), node(i + 1, j), node(i + 1, j + 1)});
        add_cell({node(i, j), node(i + 1, j + 1), node(i, j + 1)});
      }
    list_entries();
    blocks_.resize(cells_.size() * blocks_a_cell_);
    for (std::size_t e = 0; e < cells_.size(); ++e) fill(static_cast<Index>(e));
    given_.resize(3 * cells_.size());
    momentum_.resize(3 * cells_.size());
    acceleration_.resize(node_count());
    velocity_.resize(node_count());
    mass_.resize(node_count());
  }

  BigIndex cell_count() const { return static_cast<BigIndex>(cells_.size()); }

  void step()
  {
    sum_cells();
    gather_forces();
    accelerate();
    gather_velocities();
    move();
  }

  Real checksum() const
  {
    Real total = 0;
    for (const BareBlock& p : blocks_) total += sum(p.stress[0]);
    return total;
  }

private:
  using Pair = std::array<Real, 2>;

  Index node(Index i, Index j) const { return j * (side_ + 1) + i; }
  std::size_t node_count() const { return static_cast<std::size_t>(side_ + 1) * (side_ + 1); }
  Real coordinate(Index n, int d) const { return d == 0 ? n % (side_ + 1) : n / (side_ + 1); }

  void add_cell(const std::array<Index, 3>& corners)
  {
    BareCell cell;
    Real x[3], y[3];
    for (int k = 0; k < 3; ++k) cell.node[k] = corners[k], x[k] = coordinate(corners[k], 0), y[k] = coordinate(corners[k], 1);
    for (int k = 0; k < 3; ++k) {  // twice the area of each triangle is 1
      const int u = (k + 1) % 3, w = (k + 2) % 3;
      cell.a[k] = x[u] * y[w] - x[w] * y[u];
      cell.b[k] = y[u] - y[w];
      cell.c[k] = x[w] - x[u];
    }
    cells_.push_back(cell);
  }

  void list_entries()
  {
    first_.assign(node_count() + 1, 0);
    for (const BareCell& cell : cells_)
      for (const Index n : cell.node) ++first_[n + 1];
    for (std::size_t n = 0; n < node_count(); ++n) first_[n + 1] += first_[n];
    entries_.resize(3 * cells_.size());
    std::vector<Index> next(first_);
    for (std::size_t e = 0; e < cells_.size(); ++e)
      for (int k = 0; k < 3; ++k) entries_[next[cells_[e].node[k]]++] = static_cast<Index>(3 * e) + k;
  }

  /// Particles at positions of a fixed pseudo-random sequence, nearly at rest, stressed within the strength.
  void fill(Index e)
  {
    for (int k = 0; k < blocks_a_cell_ * bare_lanes; ++k) {
      BareBlock& p = blocks_[e * blocks_a_cell_ + k / bare_lanes];
      const int l = k % bare_lanes;
      Real r = next_random(), s = next_random();
      if (r + s > 1) r = 1 - r, s = 1 - s;
      for (int d = 0; d < 2; ++d) {
        const Real corner[3] = {coordinate(cells_[e].node[0], d), coordinate(cells_[e].node[1], d), coordinate(cells_[e].node[2], d)};
        p.x[d][l] = corner[0] + r * (corner[1] - corner[0]) + s * (corner[2] - corner[0]);
        p.v[d][l] = 1e-3 * next_random();
      }
      p.volume[l] = k < per_cell_ ? 0.5 / per_cell_ : 0;
      p.mass[l] = density * p.volume[l];
      const Real vertical = -1e3 - 1e3 * next_random();
      const Real stress[4] = {0.4 * vertical, vertical, 0.4 * vertical, 300 * (next_random() - 0.5)};
      for (int c = 0; c < 4; ++c) p.stress[c][l] = stress[c];
      p.plastic[l] = 0;
    }
  }

  Real next_random()
  {
    random_ = random_ * 6364136223846793005u + 1442695040888963407u;
    return static_cast<Real>(random_ >> 11) * 0x1p-53;
  }

  /// A nodal field within a cell: value = f[0] + f[1] x + f[2] y.
  [[gnu::always_inline]] static void linear(const BareCell& cell, const std::vector<Pair>& field, Real (&f)[3][2])
  {
    for (int d = 0; d < 2; ++d) {
      f[0][d] = f[1][d] = f[2][d] = 0;
      for (int k = 0; k < 3; ++k) {
        const Real value = field[cell.node[k]][d];
        f[0][d] += cell.a[k] * value, f[1][d] += cell.b[k] * value, f[2][d] += cell.c[k] * value;
      }
    }
  }

  void sum_cells()
  {
    for_each("ceiling: cells", static_cast<Index>(cells_.size()), [&](Index e) {
      BareLanes low[bare_lanes]{}, high[bare_lanes]{};  // m, mx, my, p, px, py, q, qx; qy and the stresses
      for (int b = 0; b < blocks_a_cell_; ++b) {
        const BareBlock& p = blocks_[e * blocks_a_cell_ + b];
        const BareLanes mx = p.mass * p.x[0], my = p.mass * p.x[1];
        low[0] += p.mass, low[1] += mx, low[2] += my;
        low[3] += p.mass * p.v[0], low[4] += mx * p.v[0], low[5] += my * p.v[0];
        low[6] += p.mass * p.v[1], low[7] += mx * p.v[1], high[0] += my * p.v[1];
        high[1] += p.volume * p.stress[0], high[2] += p.volume * p.stress[1], high[3] += p.volume * p.stress[3];
      }
      const BareLanes s = sums(low), t = sums(high);
      const BareCell& cell = cells_[e];
      for (int k = 0; k < 3; ++k) {
        const Real a = cell.a[k], b = cell.b[k], c = cell.c[k], m = a * s[0] + b * s[1] + c * s[2];
        given_[3 * e + k] = {m,
                             {a * s[3] + b * s[4] + c * s[5], a * s[6] + b * s[7] + c * t[0]},
                             {-(b * t[1] + c * t[3]), -(b * t[3] + c * t[2]) - gravity * m}};
      }
    });
  }

  void gather_forces()
  {
    for_each("ceiling: nodes", static_cast<Index>(node_count()), [&](Index n) {
      Given total{};
      for (Index j = first_[n]; j < first_[n + 1]; ++j) {
        const Given& part = given_[entries_[j]];
        total.mass += part.mass;
        for (int d = 0; d < 2; ++d) total.momentum[d] += part.momentum[d], total.force[d] += part.force[d];
      }
      mass_[n] = total.mass;
      for (int d = 0; d < 2; ++d) acceleration_[n][d] = total.mass > 0 ? tiny_motion * total.force[d] / total.mass : 0;
    });
  }

  void accelerate()
  {
    for_each("ceiling: accelerations", static_cast<Index>(cells_.size()), [&](Index e) {
      Real f[3][2];
      linear(cells_[e], acceleration_, f);
      BareLanes total[bare_lanes]{};
      for (int b = 0; b < blocks_a_cell_; ++b) {
        BareBlock& p = blocks_[e * blocks_a_cell_ + b];
        for (int d = 0; d < 2; ++d) {
          p.v[d] += dt * (f[0][d] + f[1][d] * p.x[0] + f[2][d] * p.x[1]);
          const BareLanes q = p.mass * p.v[d];
          total[3 * d] += q, total[3 * d + 1] += q * p.x[0], total[3 * d + 2] += q * p.x[1];
        }
      }
      const BareLanes s = sums(total);
      const BareCell& cell = cells_[e];
      for (int k = 0; k < 3; ++k)
        for (int d = 0; d < 2; ++d) momentum_[3 * e + k][d] = cell.a[k] * s[3 * d] + cell.b[k] * s[3 * d + 1] + cell.c[k] * s[3 * d + 2];
    });
  }

  void gather_velocities()
  {
    for_each("ceiling: nodes", static_cast<Index>(node_count()), [&](Index n) {
      Pair total{};
      for (Index j = first_[n]; j < first_[n + 1]; ++j)
        for (int d = 0; d < 2; ++d) total[d] += momentum_[entries_[j]][d];
      for (int d = 0; d < 2; ++d) velocity_[n][d] = mass_[n] > 0 ? total[d] / mass_[n] : 0;
    });
  }

  void move()
  {
    const Real sin_phi = std::sin(35 * pi / 180), strength = 2 * cohesion * std::cos(35 * pi / 180);
    for_each("ceiling: positions, strain, stress", static_cast<Index>(cells_.size()), [&](Index e) {
      const BareCell& cell = cells_[e];
      Real f[3][2];
      linear(cell, velocity_, f);
      const Real xx = f[1][0] * dt, yy = f[2][1] * dt, xy = (f[2][0] + f[1][1]) * dt, rotation = 0.5 * (f[2][0] - f[1][1]) * dt,
                 volume = xx + yy;
      for (int b = 0; b < blocks_a_cell_; ++b) {
        BareBlock& p = blocks_[e * blocks_a_cell_ + b];
        for (int d = 0; d < 2; ++d) p.x[d] += tiny_motion * dt * (f[0][d] + f[1][d] * p.x[0] + f[2][d] * p.x[1]);
        BareLanes min = 1 - BareLanes{};
        for (int k = 0; k < 3; ++k) min = smaller(min, cell.a[k] + cell.b[k] * p.x[0] + cell.c[k] * p.x[1]);
        if (any(min < -1e-6 - BareLanes{})) [[unlikely]]
          p.plastic = BareLanes{};
        BareLanes* s = p.stress;
        const BareLanes trial_x = s[0] + (lame * volume + 2 * shear * xx) + 2 * rotation * s[3];
        const BareLanes trial_y = s[1] + (lame * volume + 2 * shear * yy) - 2 * rotation * s[3];
        const BareLanes trial_xy = s[3] + shear * xy + rotation * (s[1] - s[0]);
        s[2] += lame * volume;
        p.volume *= 1 + volume;
        const BareLanes mean = 0.5 * (trial_x + trial_y), half = 0.5 * (trial_x - trial_y);
        const BareLanes radius = square_root(half * half + trial_xy * trial_xy + 1e-30), over = 2 * radius + 2 * mean * sin_phi - strength;
        const BareLanes flow = larger(over, BareLanes{}) * (1 / (4 * shear)),
                        left = larger(radius - 2 * shear * flow, BareLanes{}) / radius;
        s[0] = mean + half * left;
        s[1] = mean - half * left;
        s[3] = trial_xy * left;
        p.plastic += flow;
      }
    });
  }

  int per_cell_, blocks_a_cell_;
  Index side_;
  std::uint64_t random_ = 1;
  std::vector<BareCell> cells_;
  std::vector<Index> first_, entries_;
  std::vector<BareBlock> blocks_;
  std::vector<Given> given_;
  std::vector<Pair> momentum_, acceleration_, velocity_;
  std::vector<Real> mass_;
};

/// Calls `round` once for warming up, then at least once and for at least `seconds`; gives the time and the number of rounds.
template <class Round>
std::pair<Real, BigIndex> time_of(Real seconds, const Round& round)
{
  round();  // warm-up
  const Clock::time_point start = Clock::now();
  Real passed = 0;
  BigIndex rounds = 0;
  do {
    round();
    ++rounds;
    passed = std::chrono::duration<Real>(Clock::now() - start).count();
  } while (passed < seconds);
  return {passed, rounds};
}

}  // namespace

RooflineRun run_roofline_kernel(BigIndex particles, int per_cell, Real seconds)
{
  const auto side = static_cast<Index>(std::lround(std::sqrt(static_cast<Real>(particles) / 2 / per_cell)));
  Bare bare(std::max(side, 1), per_cell);
  RooflineRun run;
  run.cells = bare.cell_count();
  run.particles = run.cells * per_cell;
  std::tie(run.wall_s, run.steps) = time_of(seconds, [&] { bare.step(); });
  run.checksum = bare.checksum();
  return run;
}

Real triad_bandwidth(BigIndex bytes, Real seconds)
{
  const auto count = static_cast<Index>(bytes / 3 / static_cast<BigIndex>(sizeof(Real)));
  std::vector<Real> a(count), b(count), c(count);
  for_each("triad", count, [&](Index i) { a[i] = 0, b[i] = i, c[i] = 2. * i; });
  const auto [wall, rounds] = time_of(seconds, [&] { for_each("triad", count, [&](Index i) { a[i] = b[i] + 1.5 * c[i]; }); });
  return static_cast<Real>(3 * sizeof(Real)) * count * static_cast<Real>(rounds) / wall;
}

}  // namespace berm::roofline
