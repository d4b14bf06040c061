// SPDX-License-Identifier: BSD-3-Clause
#include "fem/direct_solver.hpp"

#include <gtest/gtest.h>

namespace berm {
namespace {

// 0 2 0     1     x = (2, 0.5, 3)
// 1 0 0     2
// 0 1 4    12.5
const SparsePattern pattern{{0, 2, 4, 6}, {0, 1, 0, 1, 1, 2}};

void expect_solution(DirectSolver& solver, std::vector<Real> b, const std::vector<Real>& x)
{
  solver.solve(b);
  for (std::size_t k = 0; k < x.size(); ++k) EXPECT_NEAR(b[k], x[k], 1e-14) << k;
}

TEST(DirectSolver, solves_an_unsymmetric_system_that_needs_pivots)
{
  DirectSolver solver(pattern);
  ASSERT_TRUE(solver.decompose(std::vector<Real>{0, 2, 1, 0, 1, 4}));
  expect_solution(solver, {1, 2, 12.5}, {2, 0.5, 3});
}

TEST(DirectSolver, takes_other_entries_of_the_same_pattern)
{
  DirectSolver solver(pattern);
  ASSERT_TRUE(solver.decompose(std::vector<Real>{0, 2, 1, 0, 1, 4}));
  ASSERT_TRUE(solver.decompose(std::vector<Real>{1, 0, 0, 1, 0, 1}));
  expect_solution(solver, {1, 2, 3}, {1, 2, 3});
}

TEST(DirectSolver, says_that_a_matrix_is_singular)
{
  DirectSolver solver(pattern);
  EXPECT_FALSE(solver.decompose(std::vector<Real>{1, 2, 1, 2, 1, 4}));
}

TEST(SparsePattern, finds_the_place_of_an_entry)
{
  EXPECT_EQ(pattern.place(0, 1), 1);
  EXPECT_EQ(pattern.place(2, 2), 5);
}

}  // namespace
}  // namespace berm
