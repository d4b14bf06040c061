// SPDX-License-Identifier: BSD-3-Clause
#include "beam/band_matrix.hpp"

#include <algorithm>
#include <cmath>

namespace berm::beam {

BandMatrix::BandMatrix(Index size, Index width) : size_(size), width_(width), entries_(static_cast<std::size_t>(size) * (width + 1)) {}

void BandMatrix::set_zero()
{
  std::fill(entries_.begin(), entries_.end(), 0.0);
}

void BandMatrix::set_unit(Index i)
{
  for (Index j = std::max(0, i - width_); j < i; ++j) entries_[position(i, j)] = 0;
  for (Index k = i + 1; k <= std::min(size_ - 1, i + width_); ++k) entries_[position(k, i)] = 0;
  entries_[position(i, i)] = 1;
}

Index BandMatrix::factorize()
{
  Index negative = 0;
  for (Index i = 0; i < size_; ++i) {
    const Index first = std::max(0, i - width_);
    Real* const row = &entries_[position(i, 0)];  // L of the rows above; this one holds L D until its diagonal is known
    for (Index j = first; j < i; ++j) {
      const Real* const above = &entries_[position(j, 0)];
      Real sum = row[j];
      for (Index k = std::max(first, j - width_); k < j; ++k) sum -= row[k] * above[k];
      row[j] = sum;
    }
    Real pivot = row[i];
    for (Index j = first; j < i; ++j) {
      const Real l = row[j] / diagonal(j);
      pivot -= l * row[j];
      row[j] = l;
    }
    row[i] = pivot;
    if (pivot == 0 || !std::isfinite(pivot)) return none;
    negative += pivot < 0 ? 1 : 0;
  }
  return negative;
}

void BandMatrix::solve(std::vector<Real>& values) const
{
  for (Index i = 0; i < size_; ++i) {
    const Real* const row = &entries_[position(i, 0)];
    Real sum = values[i];
    for (Index j = std::max(0, i - width_); j < i; ++j) sum -= row[j] * values[j];
    values[i] = sum;
  }
  for (Index i = 0; i < size_; ++i) values[i] /= diagonal(i);
  for (Index i = size_ - 1; i >= 0; --i) {
    const Real* const row = &entries_[position(i, 0)];
    for (Index j = std::max(0, i - width_); j < i; ++j) values[j] -= row[j] * values[i];
  }
}

}  // namespace berm::beam
