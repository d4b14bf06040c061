// SPDX-License-Identifier: BSD-3-Clause
#include "bodies/fill.hpp"

#include <gtest/gtest.h>

namespace berm::bodies::this_file {
namespace {

template <class Dimension>
class PointsInSimplex : public testing::Test {
};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(PointsInSimplex, Dimensions);

int power(int n, int dim)
{
  return dim == 2 ? n * n : n * n * n;
}

TYPED_TEST(PointsInSimplex, are_n_to_the_dimension_and_lie_inside)
{
  constexpr int dim = TypeParam::value;
  for (int n = 1; n <= 6; ++n) {
    const auto points = points_in_simplex<dim>(n);
    EXPECT_EQ(static_cast<int>(points.size()), power(n, dim)) << n;
    for (const auto& p : points) {
      Real total = 0;
      for (const Real value : p) {
        EXPECT_GT(value, 0.1 / n) << n;  // a part's centroid is a (dim + 1)th of its height away from each face
        total += value;
      }
      EXPECT_NEAR(total, 1, 1e-15 * 8);
    }
  }
}

TYPED_TEST(PointsInSimplex, are_all_different)
{
  constexpr int dim = TypeParam::value;
  for (int n = 1; n <= 5; ++n) {
    const auto points = points_in_simplex<dim>(n);
    for (std::size_t a = 0; a < points.size(); ++a)
      for (std::size_t b = 0; b < a; ++b) {
        Real apart = 0;
        for (int k = 0; k <= dim; ++k) apart = std::max(apart, std::abs(points[a][k] - points[b][k]));
        EXPECT_GT(apart, 0.1 / n) << n;
      }
  }
}

TYPED_TEST(PointsInSimplex, with_equal_weights_give_each_corner_its_equal_share)
{
  // The sum of N_k is a (dim + 1)th of their number: linear fields are integrated exactly.
  constexpr int dim = TypeParam::value;
  for (int n = 1; n <= 6; ++n) {
    const auto points = points_in_simplex<dim>(n);
    for (int k = 0; k <= dim; ++k) {
      Real total = 0;
      for (const auto& p : points) total += p[k];
      EXPECT_NEAR(total / power(n, dim), 1. / (dim + 1), 1e-15 * 4) << "n " << n << " corner " << k;
    }
  }
}

TYPED_TEST(PointsInSimplex, integrate_products_with_an_error_that_falls_with_the_square_of_n)
{
  // Exact mean of N_a N_b: (1 + delta_ab) / ((dim + 1)(dim + 2)). A rule of centroids is wrong by the parts' own inertia, 1/n^2 of the simplex's.
  constexpr int dim = TypeParam::value;
  for (int n = 1; n <= 4; ++n) {
    const auto points = points_in_simplex<dim>(n);
    Real worst = 0;
    for (int a = 0; a <= dim; ++a) {
      Real mean = 0;
      for (const auto& p : points) mean += p[a] * p[a] / power(n, dim);
      worst = std::max(worst, std::abs(mean - 2. / ((dim + 1) * (dim + 2))));
    }
    EXPECT_LT(worst, 0.06 / (n * n)) << n;
  }
}

}  // namespace
}  // namespace berm::bodies::this_file
