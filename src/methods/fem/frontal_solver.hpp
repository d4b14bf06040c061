// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fem/element.hpp"
#include "fem/quadratic_mesh.hpp"

#include <span>

namespace berm::fem {

/// Solves K x = b, K the sum of the stiffness of the elements of a mesh with quadratic triangles, some unknowns kept to the end as in DirectSolver. Multifrontal
/// (Duff and Reid, ACM Trans. Math. Softw. 9, 1983): the mesh is halved again and again; a half's front is the sum of those of its own halves, without the
/// unknowns that no other element has,
///
///   F = [A B^T; B C],  A = L D L^T,  what is left to the next: C - B inv(A) B^T.
///
/// No pivots are sought. Fronts are found anew only where the stiffness of an element in them has changed in any bit, so that soil that stays elastic costs
/// nothing, and the answer has the same bits as if all had been. The first halves are the elements near the kept unknowns, which change, and the others.
class FrontalSolver {
public:
  /// Unknowns 2 i and 2 i + 1 are those of node i, the others have no stiffness and are all kept.
  FrontalSolver(const QuadraticMesh& mesh, Index unknowns, const std::vector<Index>& kept);

  /// Bytes that it takes.
  Real memory() const;

  /// Factorizes the sum of these elements; rows and columns of prescribed unknowns are those of the identity. False where it is singular.
  bool factorize(const CellField<CellStiffness>& stiffness, const std::vector<char>& prescribed);

  /// How many fronts the last factorization found anew.
  int fronts_found() const { return found_; }
  int fronts() const { return static_cast<int>(fronts_.size()); }

  /// Solves with the last factorization; b becomes x. Not where unknowns are kept.
  void solve(std::span<Real> b)
  {
    condense(b);
    expand(b);
  }

  /// S of the last factorization, row by row, both triangles.
  std::span<const Real> kept_matrix() const { return {kept_matrix_.data(), static_cast<std::size_t>(kept_matrix_.size())}; }
  /// c, in which the caller then puts y; b becomes what expand() goes on from.
  std::span<Real> condense(std::span<Real> b);
  /// After condense(b), and y in its place: b becomes x.
  void expand(std::span<Real> b);

private:
  using Dense = Eigen::MatrixXd;
  struct Front {
    std::vector<Index> unknowns;  ///< those that end here, then the others
    Index ending = 0;             ///< how many end here
    std::array<Index, 2> halves = {none, none};
    std::array<std::vector<Index>, 2> at;        ///< place here of each unknown that a half leaves
    std::vector<Index> cells;                    ///< where it has no halves
    std::vector<std::array<Index, 12>> at_cell;  ///< place of each unknown of these
    Dense columns;                               ///< of those that end: L below the diagonal, D on it
    Dense left;                                  ///< lower triangle
    bool changed = true;
  };
  struct Dissection;

  bool find(Front& front, const CellField<CellStiffness>& stiffness, const std::vector<char>& prescribed);
  bool eliminate(Front& front);

  std::vector<Index> kept_;
  std::vector<Front> fronts_;  ///< halves before the whole
  CellField<CellStiffness> stiffness_;
  std::vector<char> prescribed_;
  Dense kept_matrix_;
  Eigen::VectorXd kept_part_, part_, rest_,
      scaled_;  ///< the last three as large as any front needs them: Eigen loses what it has where a larger one finds no memory
  int found_ = 0;
};

}  // namespace berm::fem
