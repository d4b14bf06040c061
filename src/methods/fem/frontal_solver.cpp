// SPDX-License-Identifier: BSD-3-Clause
#include "fem/frontal_solver.hpp"

#include "core/timer.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <numeric>

namespace berm::fem {
namespace {

constexpr std::ptrdiff_t few_cells = 10;  // are not halved
constexpr Index block = 8;                // columns that are eliminated at once

/// A matrix by columns.
template <class T>
struct Columns {
  T* first;
  std::ptrdiff_t step;
};

struct Sizes {
  Index rows, columns, inner;
};

using Four = Real __attribute__((vector_size(4 * sizeof(Real)), aligned(alignof(Real)), may_alias));

/// c -= a b^T for 4 * fours rows and some columns.
template <int fours, int columns>
[[gnu::always_inline]] inline void subtract_tile(Columns<const Real> a, Columns<const Real> b, Columns<Real> c, Index inner)
{
  Four sum[columns][fours] = {};
  for (Index k = 0; k < inner; ++k) {
    Four of_a[fours];
    for (int i = 0; i < fours; ++i) of_a[i] = *reinterpret_cast<const Four*>(a.first + k * a.step + 4 * i);
    for (int j = 0; j < columns; ++j) {
      const Real of_b = b.first[k * b.step + j];
      for (int i = 0; i < fours; ++i) sum[j][i] += of_a[i] * of_b;
    }
  }
  for (int j = 0; j < columns; ++j)
    for (int i = 0; i < fours; ++i) *reinterpret_cast<Four*>(c.first + j * c.step + 4 * i) -= sum[j][i];
}

template <int columns>
[[gnu::always_inline]] inline void subtract_columns(Columns<const Real> a, Columns<const Real> b, Columns<Real> c, Index first, Sizes size)
{
  Index i = first;
  const auto from = [&](auto of) { return decltype(of){of.first + i, of.step}; };
  for (; i + 12 <= size.rows; i += 12) subtract_tile<3, columns>(from(a), b, from(c), size.inner);
  for (; i + 4 <= size.rows; i += 4) subtract_tile<1, columns>(from(a), b, from(c), size.inner);
  for (; i < size.rows; ++i)
    for (int j = 0; j < columns; ++j) {
      Real sum = 0;
      for (Index k = 0; k < size.inner; ++k) sum += a.first[k * a.step + i] * b.first[k * b.step + j];
      c.first[j * c.step + i] -= sum;
    }
}

/// c -= a b^T where the row is not less than the column, and somewhat beyond. In two versions, of which the processor takes one, as MUMPS' BLAS has them.
[[gnu::target_clones("default", "arch=x86-64-v3")]] void subtract_product(Columns<const Real> a, Columns<const Real> b, Columns<Real> c,
                                                                          Sizes size)
{
  Index j = 0;
  const auto of_b = [&] { return Columns<const Real>{b.first + j, b.step}; };
  const auto of_c = [&] { return Columns<Real>{c.first + j * c.step, c.step}; };
  for (; j + 4 <= size.columns; j += 4) subtract_columns<4>(a, of_b(), of_c(), j, size);
  for (; j < size.columns; ++j) subtract_columns<1>(a, of_b(), of_c(), j, size);
}

/// Makes of the lower triangle of the first m columns a those of L, with D on the diagonal, and puts L D below into b; false where D has a zero.
[[gnu::target_clones("default", "arch=x86-64-v3")]] bool eliminate_columns(Columns<Real> a, Columns<Real> b, Index rows, Index m)
{
  const auto column = [](Columns<Real> of, Index j) { return of.first + j * of.step; };
  for (Index first = 0; first < m; first += block) {
    const Index next = std::min(first + block, m);
    for (Index j = first; j < next; ++j) {
      Real* here = column(a, j);
      const Real d = here[j];
      if (!(std::abs(d) > 0) || !std::isfinite(d)) return false;
      std::copy(here + j, here + rows, column(b, j) + j);
      for (Index i = j + 1; i < rows; ++i) here[i] /= d;
      for (Index k = j + 1; k < next; ++k) {
        Real* other = column(a, k);
        const Real part = column(b, j)[k];
        for (Index i = k; i < rows; ++i) other[i] -= here[i] * part;
      }
    }
    if (next < m)
      subtract_product({column(a, first) + next, a.step}, {column(b, first) + next, b.step}, {column(a, next) + next, a.step},
                       {rows - next, m - next, next - first});
  }
  return true;
}

}  // namespace

/// Halves the mesh, and finds where each unknown ends.
struct FrontalSolver::Dissection {
  const QuadraticMesh& mesh;
  std::vector<Front>& fronts;
  std::vector<Index> cells_of;  ///< by unknown: how many elements have it
  std::vector<Index> met;       ///< by unknown: how many of these are in the front in hand
  std::vector<Index> rank;      ///< by unknown: its place in the order of elimination; kept ones come last
  std::vector<Vec<2>> center;   ///< of each cell
  std::vector<char> kept;
  std::vector<std::vector<Index>> left_met = {};  ///< by front: met, of the unknowns that it leaves
  Index ended = 0;

  Index unknown(Index cell, int k) const { return 2 * mesh.nodes[cell][k / 2] + k % 2; }

  /// Splits cells in two halves by a key.
  template <class Key>
  static std::span<Index> smaller_half(std::span<Index> cells, const Key& key)
  {
    const auto middle = cells.begin() + static_cast<std::ptrdiff_t>(cells.size() / 2);
    std::nth_element(cells.begin(), middle, cells.end(), [&](Index a, Index b) { return std::pair(key(a), a) < std::pair(key(b), b); });
    return cells.first(cells.size() / 2);
  }

  std::span<Index> half(std::span<Index> cells) const
  {
    Vec<2> lower = center[cells[0]], upper = lower;
    for (const Index cell : cells) lower = lower.cwiseMin(center[cell]), upper = upper.cwiseMax(center[cell]);
    const int along = upper[0] - lower[0] > upper[1] - lower[1] ? 0 : 1;
    return smaller_half(cells, [&](Index cell) { return center[cell][along]; });
  }

  Index dissect(std::span<Index> cells)
  {
    if (static_cast<std::ptrdiff_t>(cells.size()) <= few_cells) return add({cells.begin(), cells.end()}, {none, none});
    const std::span<Index> first = half(cells);
    const Index one = dissect(first), other = dissect(cells.subspan(first.size()));
    return add({}, {one, other});
  }

  /// Adds a front of cells or halves: all unknowns that it has, those that end first, in the order in which they were met.
  Index add(std::vector<Index> cells, std::array<Index, 2> halves)
  {
    Front front;
    std::vector<Index> all;
    const auto meet = [&](Index u, Index cells_with_it) {
      all.push_back(u);
      met[u] += cells_with_it;
    };
    for (const Index cell : cells)
      for (int k = 0; k < 12; ++k) meet(unknown(cell, k), 1);
    for (const Index h : halves)
      if (h != none)
        for (std::size_t k = 0; k < left_met[h].size(); ++k) meet(fronts[h].unknowns[fronts[h].ending + k], left_met[h][k]);
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    const auto ends = [&](Index u) { return met[u] == cells_of[u] && kept[u] == 0; };
    for (const Index u : all)
      if (ends(u)) front.unknowns.push_back(u), rank[u] = ended++;
    front.ending = static_cast<Index>(front.unknowns.size());
    std::vector<Index>& left = left_met.emplace_back();
    for (const Index u : all)
      if (!ends(u)) front.unknowns.push_back(u), left.push_back(met[u]);
    for (const Index u : all) met[u] = 0;
    front.cells = std::move(cells);
    front.halves = halves;
    fronts.push_back(std::move(front));
    return static_cast<Index>(fronts.size()) - 1;
  }
};

FrontalSolver::FrontalSolver(const QuadraticMesh& mesh, Index unknowns, const std::vector<Index>& kept)
    : kept_(kept),
      stiffness_(mesh.nodes.size())
{
  const Timer timer("order equations");
  const auto size = static_cast<std::size_t>(unknowns);
  Dissection d{mesh,
               fronts_,
               std::vector<Index>(size, 0),
               std::vector<Index>(size, 0),
               std::vector<Index>(size, none),
               {},
               std::vector<char>(size, 0)};
  for (std::size_t k = 0; k < kept.size(); ++k) d.kept[kept[k]] = 1, d.rank[kept[k]] = unknowns + static_cast<Index>(k);
  std::vector<Vec<2>> near;
  for (const Index u : kept)
    if (u < 2 * mesh.position.size()) near.push_back(mesh.position[u / 2]);
  std::vector<Index> cells(static_cast<std::size_t>(mesh.nodes.size()));
  std::iota(cells.begin(), cells.end(), 0);
  std::vector<Real> distance;
  for (const Index cell : cells) {
    d.center.push_back((mesh.position[mesh.nodes[cell][0]] + mesh.position[mesh.nodes[cell][1]] + mesh.position[mesh.nodes[cell][2]]) / 3);
    for (int k = 0; k < 12; ++k) ++d.cells_of[d.unknown(cell, k)];
    Real least = infinity;
    for (const Vec<2>& x : near) least = std::min(least, (x - d.center.back()).squaredNorm());
    distance.push_back(least);
  }
  if (near.empty()) {
    d.dissect(cells);
  } else {
    const std::span<Index> first = Dissection::smaller_half(cells, [&](Index cell) { return distance[cell]; });
    const Index one = d.dissect(first), other = d.dissect(std::span(cells).subspan(first.size()));
    d.add({}, {one, other});
  }
  fronts_.back().unknowns.resize(fronts_.back().ending);
  fronts_.back().unknowns.insert(fronts_.back().unknowns.end(), kept.begin(), kept.end());

  std::vector<Index> place(size, none);
  for (Front& front : fronts_) {
    std::sort(front.unknowns.begin() + front.ending, front.unknowns.end(), [&](Index a, Index b) { return d.rank[a] < d.rank[b]; });
    for (std::size_t k = 0; k < front.unknowns.size(); ++k) place[front.unknowns[k]] = static_cast<Index>(k);
    for (int h = 0; h < 2; ++h) {
      if (front.halves[h] == none) continue;
      const Front& half = fronts_[front.halves[h]];
      for (std::size_t k = half.ending; k < half.unknowns.size(); ++k) front.at[h].push_back(place[half.unknowns[k]]);
    }
    for (const Index cell : front.cells) {
      std::array<Index, 12>& at = front.at_cell.emplace_back();
      for (int k = 0; k < 12; ++k) at[k] = place[d.unknown(cell, k)];
    }
    const auto all = static_cast<Index>(front.unknowns.size());
    front.columns.resize(all, front.ending);
    front.left.resize(all - front.ending, all - front.ending);
  }
  const auto n = static_cast<Index>(kept.size());
  kept_matrix_.resize(n, n);
  kept_part_.resize(n);
  Index most_ending = 0, most_left = 0, most_entries = 0;
  for (const Front& front : fronts_) {
    most_ending = std::max(most_ending, front.ending);
    most_left = std::max(most_left, static_cast<Index>(front.unknowns.size()) - front.ending);
    most_entries = std::max(most_entries, static_cast<Index>(front.columns.size()));
  }
  part_.resize(most_ending);
  rest_.resize(most_left);
  scaled_.resize(most_entries);
}

Real FrontalSolver::memory() const
{
  Real numbers = 78. * static_cast<Real>(stiffness_.size());
  for (const Front& front : fronts_) numbers += static_cast<Real>(front.columns.size() + front.left.size());
  return sizeof(Real) * numbers;
}

bool FrontalSolver::factorize(const CellField<CellStiffness>& stiffness, const std::vector<char>& prescribed)
{
  const Timer timer("factorize matrix");
  const bool all = prescribed != prescribed_;
  prescribed_ = prescribed;
  found_ = 0;
  bool regular = true;
  for (Front& front : fronts_) {
    front.changed = front.changed || all;
    for (const Index half : front.halves) front.changed = front.changed || (half != none && fronts_[half].changed);
    for (const Index cell : front.cells) {
      if (stiffness[cell] == stiffness_[cell]) continue;
      stiffness_[cell] = stiffness[cell];
      front.changed = true;
    }
    if (!front.changed || !regular) continue;
    ++found_;
    regular = find(front, stiffness, prescribed);
  }
  if (!regular) {
    for (Front& front : fronts_) front.changed = true;
    return false;
  }
  for (Front& front : fronts_) front.changed = false;
  kept_matrix_ = fronts_.back().left.selfadjointView<Eigen::Lower>();
  return true;
}

/// Adds up a front, and eliminates what ends there; false where that is singular.
bool FrontalSolver::find(Front& front, const CellField<CellStiffness>& stiffness, const std::vector<char>& prescribed)
{
  const Index ending = front.ending;
  front.columns.setZero();
  front.left.setZero();
  // Rows are not less than columns.
  const auto add = [&](Index row, Index col, Real value) {
    (col < ending ? front.columns(row, col) : front.left(row - ending, col - ending)) += value;
  };
  for (int h = 0; h < 2; ++h) {
    if (front.halves[h] == none) continue;
    const Dense& left = fronts_[front.halves[h]].left;
    const std::vector<Index>& at = front.at[h];
    const auto n = static_cast<Index>(at.size());
    for (Index j = 0; j < n; ++j) {
      Real* to = at[j] < ending ? &front.columns(0, at[j]) : &front.left(0, at[j] - ending) - ending;
      const Real* from = &left(0, j);
      for (Index i = j; i < n; ++i) to[at[i]] += from[i];
    }
  }
  for (std::size_t c = 0; c < front.cells.size(); ++c) {
    const CellStiffness& entries = stiffness[front.cells[c]];
    const std::array<Index, 12>& at = front.at_cell[c];
    int k = 0;
    for (int i = 0; i < 12; ++i)
      for (int j = 0; j <= i; ++j, ++k)
        if (prescribed[front.unknowns[at[i]]] == 0 && prescribed[front.unknowns[at[j]]] == 0)
          add(std::max(at[i], at[j]), std::min(at[i], at[j]), entries[k]);
  }
  const bool last = &front == &fronts_.back();
  const auto ones = last ? static_cast<Index>(front.unknowns.size()) : ending;
  for (Index k = 0; k < ones; ++k)
    if (prescribed[front.unknowns[k]] != 0) add(k, k, 1);
  return eliminate(front);
}

bool FrontalSolver::eliminate(Front& front)
{
  Dense& a = front.columns;
  const auto rows = static_cast<Index>(a.rows()), m = front.ending, left = rows - m;
  if (m == 0) return true;
  if (!eliminate_columns({a.data(), rows}, {scaled_.data(), rows}, rows, m)) return false;
  if (left > 0) subtract_product({&a(m, 0), rows}, {scaled_.data() + m, rows}, {front.left.data(), left}, {left, left, m});
  return true;
}

std::span<Real> FrontalSolver::condense(std::span<Real> b)
{
  const Timer timer("solve equations");
  for (const Front& front : fronts_) {
    const Index m = front.ending;
    const auto all = static_cast<Index>(front.unknowns.size());
    auto part = part_.head(m), rest = rest_.head(all - m);
    for (Index k = 0; k < m; ++k) part[k] = b[front.unknowns[k]];
    front.columns.topRows(m).triangularView<Eigen::UnitLower>().solveInPlace(part);
    rest.noalias() = front.columns.bottomRows(all - m) * part;
    for (Index k = 0; k < m; ++k) b[front.unknowns[k]] = part[k];
    for (Index k = m; k < all; ++k) b[front.unknowns[k]] -= rest[k - m];
  }
  for (std::size_t k = 0; k < kept_.size(); ++k) kept_part_[static_cast<Index>(k)] = b[kept_[k]];
  return {kept_part_.data(), kept_.size()};
}

void FrontalSolver::expand(std::span<Real> b)
{
  const Timer timer("solve equations");
  for (std::size_t k = 0; k < kept_.size(); ++k) b[kept_[k]] = kept_part_[static_cast<Index>(k)];
  for (auto front = fronts_.rbegin(); front != fronts_.rend(); ++front) {
    const Index m = front->ending;
    const auto all = static_cast<Index>(front->unknowns.size());
    auto part = part_.head(m), rest = rest_.head(all - m);
    for (Index k = 0; k < m; ++k) part[k] = b[front->unknowns[k]] / front->columns(k, k);
    for (Index k = m; k < all; ++k) rest[k - m] = b[front->unknowns[k]];
    part.noalias() -= front->columns.bottomRows(all - m).transpose() * rest;
    front->columns.topRows(m).triangularView<Eigen::UnitLower>().transpose().solveInPlace(part);
    for (Index k = 0; k < m; ++k) b[front->unknowns[k]] = part[k];
  }
}

}  // namespace berm::fem
