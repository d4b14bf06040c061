// SPDX-License-Identifier: BSD-3-Clause
#include "fem/direct_solver.hpp"

#include <Eigen/LU>
#include <dlfcn.h>
#include <gtest/gtest.h>
#include <malloc.h>

namespace berm::fem::this_file {
namespace {

//  4 -1  0     2     x = (1, 2, 3)
// -1  4 -2     1
//  0 -2  5    11
const SparsePattern pattern{{0, 1, 3, 5}, {0, 0, 1, 1, 2}};
const std::vector<Real> entries{4, -1, 4, -2, 5};

void expect_solution(DirectSolver& solver, std::vector<Real> b, const std::vector<Real>& x)
{
  solver.solve(b);
  for (std::size_t k = 0; k < x.size(); ++k) EXPECT_NEAR(b[k], x[k], 1e-14) << k;
}

TEST(DirectSolver, solves_a_symmetric_system_by_its_lower_triangle)
{
  DirectSolver solver(pattern);
  ASSERT_TRUE(solver.factorize(entries));
  expect_solution(solver, {2, 1, 11}, {1, 2, 3});
}

TEST(DirectSolver, takes_other_entries_of_the_same_pattern)
{
  DirectSolver solver(pattern);
  ASSERT_TRUE(solver.factorize(entries));
  ASSERT_TRUE(solver.factorize(std::vector<Real>{1, 0, 1, 0, 1}));
  expect_solution(solver, {1, 2, 3}, {1, 2, 3});
}

TEST(DirectSolver, says_that_a_matrix_is_singular)
{
  DirectSolver solver(pattern);
  EXPECT_FALSE(solver.factorize(std::vector<Real>{1, -1, 1, 0, 5}));
}

/// Springs between n x n points of a square, and their stiffness.
std::pair<SparsePattern, std::vector<Real>> springs_of(Index n)
{
  SparsePattern springs{{0}, {}};
  std::vector<Real> stiffness;
  const auto add = [&](Index column, Real entry) { springs.column.push_back(column), stiffness.push_back(entry); };
  for (Index k = 0; k < n * n; ++k) {
    if (k >= n) add(k - n, -1);
    if (k % n > 0) add(k - 1, -1);
    add(k, 4 + 1. / (k + 3));
    springs.first.push_back(static_cast<Index>(springs.column.size()));
  }
  return {springs, stiffness};
}

/// The solution of 200 x 200 equations where OpenBLAS was told to take so many threads.
std::vector<Real> solution_with(int threads)
{
  const auto set = reinterpret_cast<void (*)(int)>(::dlsym(RTLD_DEFAULT, "openblas_set_num_threads"));
  if (set != nullptr) set(threads);
  const auto [springs, stiffness] = springs_of(200);
  DirectSolver solver(springs);
  EXPECT_TRUE(solver.factorize(stiffness));
  std::vector<Real> b(200 * 200);
  for (std::size_t k = 0; k < b.size(); ++k) b[k] = 1. / (static_cast<Real>(k) + 7);
  solver.solve(b);
  if (set != nullptr) set(1);
  return b;
}

TEST(DirectSolver, has_the_same_digits_however_many_threads_the_blas_would_take)
{
  const std::vector<Real> one = solution_with(1);
  for (const int threads : {2, 4}) EXPECT_TRUE(one == solution_with(threads)) << threads;
}

Real allocated()
{
  const struct mallinfo2 now = ::mallinfo2();
  return static_cast<Real>(now.uordblks + now.hblkhd);
}

TEST(DirectSolver, foretells_the_memory_of_a_decomposition)
{
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer's memory is not counted by mallinfo2";
#endif
  constexpr int n = 200;
  const auto [springs, stiffness] = springs_of(n);
  DirectSolver solver(springs);
  const Real before = allocated();
  ASSERT_TRUE(solver.factorize(stiffness));
  const Real taken = allocated() - before;
  EXPECT_GT(taken, 8 * 10 * n * n);  // ten numbers a row are less than any order of elimination leaves
  EXPECT_LE(taken, solver.memory());
  EXPECT_GT(2 * taken, solver.memory());
}

TEST(DirectSolver, leaves_kept_unknowns_to_the_caller)
{
  // Dense, the kept ones in another order than they are counted; without stiffness of their own, so that the whole is not positive definite.
  constexpr int n = 7;
  const std::vector<Index> kept{5, 1};
  const int others[] = {0, 2, 3, 4, 6};
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(n, n);
  SparsePattern dense{{0}, {}};
  std::vector<Real> lower;
  for (int row = 0; row < n; ++row) {
    for (int column = 0; column <= row; ++column) {
      const Real entry = row == column ? (row == 5 || row == 1 ? 0 : 10 + row) : 1. / (1 + row + 2 * column);
      a(row, column) = a(column, row) = entry;
      dense.column.push_back(column);
      lower.push_back(entry);
    }
    dense.first.push_back(static_cast<Index>(dense.column.size()));
  }
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(n, 1, 3), x = a.partialPivLu().solve(b);
  const Eigen::MatrixXd aok = a(others, kept), inverse = a(others, others).inverse();
  const Eigen::Matrix2d schur = a(kept, kept) - aok.transpose() * inverse * aok;
  const Eigen::Vector2d load = b(kept) - aok.transpose() * inverse * b(others);

  DirectSolver solver(dense, kept);
  ASSERT_TRUE(solver.factorize(lower));
  const std::span<const Real> s = solver.kept_matrix();
  for (const auto& [row, column] : {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1)})
    EXPECT_NEAR(s[2 * row + column], schur(row, column), 1e-14) << row << ", " << column;
  std::vector<Real> solution(b.begin(), b.end());
  const std::span<Real> y = solver.condense(solution);
  for (int k = 0; k < 2; ++k) EXPECT_NEAR(y[k], load[k], 1e-14);
  for (int k = 0; k < 2; ++k) y[k] = x[kept[k]];
  solver.expand(solution);
  for (int k = 0; k < n; ++k) EXPECT_NEAR(solution[k], x[k], 1e-13 * x.norm()) << k;
}

TEST(DirectSolver, leaves_kept_unknowns_of_an_unsymmetric_matrix_to_the_caller)
{
  constexpr int n = 7;
  const std::vector<Index> kept{5, 1};
  const int others[] = {0, 2, 3, 4, 6};
  Eigen::MatrixXd a(n, n);
  SparsePattern dense{{0}, {}};
  std::vector<Real> entries, mirrored;
  for (int row = 0; row < n; ++row) {
    for (int column = 0; column < n; ++column) a(row, column) = row == column ? 5 - row : 1. / (1 + row + 2 * column);
    for (int column = 0; column <= row; ++column) dense.column.push_back(column), entries.push_back(a(row, column));
    dense.first.push_back(static_cast<Index>(dense.column.size()));
  }
  for (int row = 0; row < n; ++row)
    for (int column = 0; column <= row; ++column) mirrored.push_back(row == column ? 0 : a(column, row));
  entries.insert(entries.end(), mirrored.begin(), mirrored.end());
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(n, 1, 3), x = a.partialPivLu().solve(b);
  const Eigen::MatrixXd inverse = a(others, others).inverse();
  const Eigen::Matrix2d schur = a(kept, kept) - a(kept, others) * inverse * a(others, kept);
  const Eigen::Vector2d load = b(kept) - a(kept, others) * inverse * b(others);

  DirectSolver solver(dense, kept, MatrixKind::unsymmetric);
  ASSERT_TRUE(solver.factorize(entries));
  const std::span<const Real> s = solver.kept_matrix();
  for (int row = 0; row < 2; ++row)
    for (int column = 0; column < 2; ++column) EXPECT_NEAR(s[2 * row + column], schur(row, column), 1e-13) << row << ", " << column;
  std::vector<Real> solution(b.begin(), b.end());
  const std::span<Real> y = solver.condense(solution);
  for (int k = 0; k < 2; ++k) EXPECT_NEAR(y[k], load[k], 1e-13);
  for (int k = 0; k < 2; ++k) y[k] = x[kept[k]];
  solver.expand(solution);
  for (int k = 0; k < n; ++k) EXPECT_NEAR(solution[k], x[k], 1e-12 * x.norm()) << k;
}

TEST(SparsePattern, finds_the_place_of_an_entry)
{
  EXPECT_EQ(pattern.index_of(1, 0), 1);
  EXPECT_EQ(pattern.index_of(2, 2), 4);
}

}  // namespace
}  // namespace berm::fem::this_file
