// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/numbers.hpp"

#include <memory>
#include <span>
#include <vector>

namespace berm {

/// Where a square sparse matrix has entries: row r has the columns column[first[r]] ... column[first[r + 1] - 1], ascending.
struct SparsePattern {
  std::vector<Index> first, column;

  Index size() const { return static_cast<Index>(first.size()) - 1; }
  Index entry_count() const { return static_cast<Index>(column.size()); }
  /// The place of an entry that is there.
  Index place(Index row, Index col) const;
};

/// Solves A x = b for unsymmetric matrices of one pattern by LU decomposition with MUMPS (Amestoy, Duff, L'Excellent and Koster, SIAM J. Matrix Anal.
/// Appl. 23, 2001), sequential. The order of elimination is found once.
class DirectSolver {
public:
  explicit DirectSolver(const SparsePattern& pattern);
  ~DirectSolver();
  DirectSolver(const DirectSolver&) = delete;
  DirectSolver& operator=(const DirectSolver&) = delete;

  /// Decomposes the matrix with these entries, in the pattern's order. False where it is singular. Throws RunError where memory is wanting.
  bool decompose(std::span<const Real> entries);

  /// Solves with the last decomposition; b becomes x.
  void solve(std::span<Real> b);

private:
  struct Mumps;
  std::unique_ptr<Mumps> mumps_;
};

}  // namespace berm
