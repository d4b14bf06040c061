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

TEST(CellPoints, twice_a_square_share_a_triangle_equally_across_its_longest_side)
{
  // A right triangle with the longest side between corners 0 and 1; the mean of x is that of the area, and mirroring the triangle at its axis maps the points
  // onto each other.
  mesh::Mesh<2> mesh;
  for (const Vec<2>& corner : {Vec<2>(0, 0), Vec<2>(1, 1), Vec<2>(1, 0)}) mesh.position.push_back(corner);
  mesh.nodes.push_back({0, 2, 1});
  for (const int count : {2, 8, 18, 32}) {
    const CellPoints<2> points(count);
    ASSERT_EQ(points.count(), count);
    Vec<2> mean = Vec<2>::Zero();
    for (int k = 0; k < count; ++k) mean += points.at(mesh, 0, k) / count;
    EXPECT_NEAR((mean - Vec<2>(2. / 3, 1. / 3)).norm(), 0, 1e-14) << count;
    for (int k = 0; k < count; ++k) {
      const Vec<2> x = points.at(mesh, 0, k), mirrored(1 - x[1], 1 - x[0]);
      EXPECT_GT(std::min({x[1], 1 - x[0], x[0] - x[1]}), 0) << count;
      Real nearest = infinity;
      for (int other = 0; other < count; ++other) nearest = std::min(nearest, (points.at(mesh, 0, other) - mirrored).norm());
      EXPECT_NEAR(nearest, 0, 1e-14) << count << ' ' << k;
    }
  }
  EXPECT_TRUE(shares_cell<2>(8) && shares_cell<2>(9) && shares_cell<3>(8));
  EXPECT_FALSE(shares_cell<2>(3) || shares_cell<2>(0) || shares_cell<3>(2) || shares_cell<3>(9));
}

}  // namespace
}  // namespace berm::bodies::this_file
