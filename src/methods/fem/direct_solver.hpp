// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

#include <memory>
#include <span>
#include <vector>

namespace berm::fem {

/// Pattern of the lower triangle of a symmetric sparse matrix: row r has the columns column[first[r]] ... column[first[r +
/// 1] - 1], ascending, none beyond r.
struct SparsePattern {
  std::vector<Index> first, column;

  Index size() const { return static_cast<Index>(first.size()) - 1; }
  Index entry_count() const { return static_cast<Index>(column.size()); }
  /// Index of an entry of the pattern, row >= col.
  Index index_of(Index row, Index col) const;
};

/// A symmetric matrix with positive and negative eigenvalues is indefinite.
enum class MatrixKind { positive_definite, indefinite, unsymmetric };

/// Nested dissections: by PORD, which the plane has; by SCOTCH, which takes less memory and time in space.
enum class Ordering { pord, scotch };

/// Solves A x = b for matrices of one symmetric pattern with MUMPS (Amestoy, Duff, L'Excellent and
/// Koster, SIAM J. Matrix Anal. Appl. 23, 2001), sequential. The order of elimination is computed once. Some unknowns may be
/// kept to the end, for which the caller solves
///
///   S y = c,  S = A_kk - A_ko inv(A_oo) A_ok,  c = b_k - A_ko inv(A_oo) b_o
///
/// (k: kept, o: the others). Of a positive definite kind only A_oo has to be that then.
class DirectSolver {
public:
  explicit DirectSolver(const SparsePattern& pattern, const std::vector<Index>& kept = {}, MatrixKind kind = MatrixKind::positive_definite,
                        Ordering ordering = Ordering::pord);
  ~DirectSolver();
  DirectSolver(const DirectSolver&) = delete;
  DirectSolver& operator=(const DirectSolver&) = delete;

  /// Memory of a factorization, bytes, as estimated by the analysis phase.
  Real memory() const;

  /// Factorizes the matrix with these entries, in the pattern's order; of an unsymmetric one those of the transposed matrix follow, with zeros for the
  /// diagonal. False where it is singular. Throws RunError where memory does not suffice.
  bool factorize(std::span<const Real> entries);

  /// Solves with the last factorization; b becomes x. Not where unknowns are kept.
  void solve(std::span<Real> b);

  /// S of the last factorization, row by row: the lower triangle, the rest is set where the matrix is unsymmetric alone.
  std::span<const Real> kept_matrix() const;
  /// c, in which the caller then puts y.
  std::span<Real> condense(std::span<Real> b);
  /// After condense(b), and y in its place: b becomes x.
  void expand(std::span<Real> b);

private:
  void solve(std::span<Real> b, int part);
  struct Mumps;
  std::unique_ptr<Mumps> mumps_;
};

}  // namespace berm::fem
