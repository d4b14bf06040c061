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
  for (Index j = 0; j < size_; ++j) {
    Real* const column = &entries_[position(j, j)];
    const Real pivot = column[0];
    if (pivot == 0 || !std::isfinite(pivot)) return none;
    negative += pivot < 0 ? 1 : 0;
    const Index last = std::min(width_, size_ - 1 - j);
    for (Index i = 1; i <= last; ++i) {  // L D of this column from the columns after it
      const Real l = column[i] / pivot;
      Real* const after = &entries_[position(j + i, j + i)];
      for (Index k = i; k <= last; ++k) after[k - i] -= l * column[k];
    }
    for (Index i = 1; i <= last; ++i) column[i] /= pivot;
  }
  return negative;
}

void BandMatrix::solve(std::vector<Real>& values) const
{
  for (Index j = 0; j < size_; ++j) {
    const Real* const column = &entries_[position(j, j)];
    const Index last = std::min(width_, size_ - 1 - j);
    for (Index i = 1; i <= last; ++i) values[j + i] -= column[i] * values[j];
  }
  for (Index j = size_ - 1; j >= 0; --j) {
    const Real* const column = &entries_[position(j, j)];
    const Index last = std::min(width_, size_ - 1 - j);
    Real sum = values[j] / column[0];
    for (Index i = 1; i <= last; ++i) sum -= column[i] * values[j + i];
    values[j] = sum;
  }
}

}  // namespace berm::beam
