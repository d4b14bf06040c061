// SPDX-License-Identifier: BSD-3-Clause
#include "fem/frontal_solver.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>
#include <random>

namespace berm::fem::this_file {
namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

/// A square of n x n pairs of triangles.
QuadraticMesh square(int n)
{
  QuadraticMesh mesh;
  const int along = 2 * n + 1;
  for (int j = 0; j < along; ++j)
    for (int i = 0; i < along; ++i) mesh.position.push_back({i / 2., j / 2.});
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const auto at = [&](int x, int y) { return static_cast<Index>((2 * j + y) * along + 2 * i + x); };
      mesh.nodes.push_back({at(0, 0), at(2, 0), at(2, 2), at(1, 0), at(2, 1), at(1, 1)});
      mesh.nodes.push_back({at(0, 0), at(2, 2), at(0, 2), at(1, 1), at(1, 2), at(0, 1)});
    }
  return mesh;
}

/// A positive definite stiffness.
CellStiffness any_stiffness(unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<Real> number(-1, 1);
  Eigen::Matrix<Real, 12, 12> root;
  for (Real& entry : root.reshaped()) entry = number(random);
  const Eigen::Matrix<Real, 12, 12> whole = root * root.transpose() + Eigen::Matrix<Real, 12, 12>::Identity();
  CellStiffness lower;
  int k = 0;
  for (int i = 0; i < 12; ++i)
    for (int j = 0; j <= i; ++j) lower[k++] = whole(i, j);
  return lower;
}

struct Problem {
  QuadraticMesh mesh = square(7);
  Index unknowns = 2 * mesh.position.size();
  CellField<CellStiffness> stiffness;
  std::vector<char> prescribed;
  std::vector<Index> kept;

  /// With some unknowns of a node in the middle of the square kept, and one that has no stiffness.
  explicit Problem(bool keeps) : stiffness(mesh.nodes.size())
  {
    for (Index cell = 0; cell < stiffness.size(); ++cell) stiffness[cell] = any_stiffness(static_cast<unsigned>(cell));
    if (keeps) kept = {140, 141, 92, unknowns, 93}, ++unknowns;
    prescribed.assign(static_cast<std::size_t>(unknowns), 0);
    for (const Index unknown : {0, 1, 5, 92, 201}) prescribed[unknown] = 1;
    if (keeps) prescribed[unknowns - 1] = 1;
  }

  Matrix matrix() const
  {
    Matrix sum = Matrix::Zero(unknowns, unknowns);
    for (Index cell = 0; cell < stiffness.size(); ++cell) {
      int k = 0;
      for (int i = 0; i < 12; ++i)
        for (int j = 0; j <= i; ++j, ++k) {
          const Index row = 2 * mesh.nodes[cell][i / 2] + i % 2, col = 2 * mesh.nodes[cell][j / 2] + j % 2;
          sum(row, col) += stiffness[cell][k];
          if (i != j) sum(col, row) += stiffness[cell][k];
        }
    }
    for (Index k = 0; k < unknowns; ++k)
      if (prescribed[k] != 0) sum.row(k).setZero(), sum.col(k).setZero(), sum(k, k) = 1;
    return sum;
  }
};

std::vector<Real> some_load(Index unknowns)
{
  std::vector<Real> b;
  for (Index k = 0; k < unknowns; ++k) b.push_back(std::sin(k));
  return b;
}

Vector as_vector(const std::vector<Real>& x)
{
  return Eigen::Map<const Vector>(x.data(), static_cast<Eigen::Index>(x.size()));
}

TEST(FrontalSolver, solves_the_sum_of_the_elements)
{
  const Problem problem(false);
  FrontalSolver solver(problem.mesh, problem.unknowns, {});
  ASSERT_TRUE(solver.factorize(problem.stiffness, problem.prescribed));
  EXPECT_GT(solver.fronts(), 10);
  std::vector<Real> x = some_load(problem.unknowns);
  const Vector expected = problem.matrix().ldlt().solve(as_vector(x));
  solver.solve(x);
  EXPECT_NEAR((as_vector(x) - expected).norm(), 0, 1e-12 * expected.norm());  // rounding
}

TEST(FrontalSolver, leaves_kept_unknowns_to_the_caller)
{
  const Problem problem(true);
  FrontalSolver solver(problem.mesh, problem.unknowns, problem.kept);
  ASSERT_TRUE(solver.factorize(problem.stiffness, problem.prescribed));
  const Matrix whole = problem.matrix();
  const auto n = static_cast<Eigen::Index>(problem.kept.size());
  std::vector<Index> others;
  for (Index k = 0; k < problem.unknowns; ++k)
    if (std::find(problem.kept.begin(), problem.kept.end(), k) == problem.kept.end()) others.push_back(k);
  const Matrix schur = whole(problem.kept, problem.kept) -
                       whole(problem.kept, others) * whole(others, others).ldlt().solve(Matrix(whole(others, problem.kept)));
  const Matrix found = Eigen::Map<const Matrix>(solver.kept_matrix().data(), n, n);
  EXPECT_NEAR((found - schur).norm(), 0, 1e-12 * schur.norm());

  std::vector<Real> x = some_load(problem.unknowns);
  const Vector load = as_vector(x), expected = whole.ldlt().solve(load);
  Eigen::Map<Vector> part(solver.condense(x).data(), n);
  part = schur.ldlt().solve(Vector(part));
  solver.expand(x);
  EXPECT_NEAR((as_vector(x) - expected).norm(), 0, 1e-12 * expected.norm());
}

TEST(FrontalSolver, finds_anew_only_fronts_with_an_element_that_changed_and_gives_the_same_bits)
{
  Problem problem(true);
  FrontalSolver solver(problem.mesh, problem.unknowns, problem.kept);
  ASSERT_TRUE(solver.factorize(problem.stiffness, problem.prescribed));
  EXPECT_EQ(solver.fronts_found(), solver.fronts());
  ASSERT_TRUE(solver.factorize(problem.stiffness, problem.prescribed));
  EXPECT_EQ(solver.fronts_found(), 0);
  problem.stiffness[40] = any_stiffness(1000);
  ASSERT_TRUE(solver.factorize(problem.stiffness, problem.prescribed));
  EXPECT_GT(solver.fronts_found(), 1);
  EXPECT_LT(solver.fronts_found(), solver.fronts() / 2);

  FrontalSolver other(problem.mesh, problem.unknowns, problem.kept);
  ASSERT_TRUE(other.factorize(problem.stiffness, problem.prescribed));
  std::vector<Real> x = some_load(problem.unknowns), y = x;
  solver.solve(x);
  other.solve(y);
  EXPECT_EQ(x, y);
}

TEST(FrontalSolver, takes_other_prescribed_unknowns)
{
  Problem problem(false);
  FrontalSolver solver(problem.mesh, problem.unknowns, {});
  ASSERT_TRUE(solver.factorize(problem.stiffness, problem.prescribed));
  problem.prescribed[0] = 0, problem.prescribed[77] = 1;
  ASSERT_TRUE(solver.factorize(problem.stiffness, problem.prescribed));
  std::vector<Real> x = some_load(problem.unknowns);
  const Vector expected = problem.matrix().ldlt().solve(as_vector(x));
  solver.solve(x);
  EXPECT_NEAR((as_vector(x) - expected).norm(), 0, 1e-12 * expected.norm());
}

TEST(FrontalSolver, says_that_a_matrix_is_singular_and_goes_on_from_there)
{
  Problem problem(false);
  const CellField<CellStiffness> regular = problem.stiffness;
  FrontalSolver solver(problem.mesh, problem.unknowns, {});
  for (CellStiffness& entries : problem.stiffness) entries.fill(0);
  EXPECT_FALSE(solver.factorize(problem.stiffness, problem.prescribed));
  ASSERT_TRUE(solver.factorize(regular, problem.prescribed));
  problem.stiffness = regular;
  std::vector<Real> x = some_load(problem.unknowns);
  const Vector expected = problem.matrix().ldlt().solve(as_vector(x));
  solver.solve(x);
  EXPECT_NEAR((as_vector(x) - expected).norm(), 0, 1e-12 * expected.norm());
}

}  // namespace
}  // namespace berm::fem::this_file
