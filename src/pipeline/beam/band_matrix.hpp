// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

#include <vector>

namespace berm::beam {

/// A symmetric matrix whose entries are zero beyond `width` from the diagonal, and its decomposition L D L^T in place, without pivoting. Columns of the lower half
/// lie one after the other, each begins with its diagonal.
class BandMatrix {
public:
  BandMatrix(Index size, Index width);

  Index size() const { return size_; }
  void set_zero();
  /// Adds to the entry in row i and column j <= i of the lower half.
  void add(Index i, Index j, Real value) { entries_[position(i, j)] += value; }
  Real diagonal(Index i) const { return entries_[position(i, i)]; }
  /// Makes row and column i those of the unit matrix.
  void set_unit(Index i);

  /// Decomposes it. The number of negative pivots, which is that of negative eigenvalues (Sylvester's law of inertia); none where a pivot is zero or not finite, so that there
  /// is no decomposition.
  Index factorize();
  /// From the right-hand side to the solution, after a decomposition.
  void solve(std::vector<Real>& values) const;

private:
  std::size_t position(Index i, Index j) const { return static_cast<std::size_t>(j) * (width_ + 1) + static_cast<std::size_t>(i - j); }

  Index size_, width_;
  std::vector<Real> entries_;
};

}  // namespace berm::beam
