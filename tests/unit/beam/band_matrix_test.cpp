// SPDX-License-Identifier: BSD-3-Clause
#include "beam/band_matrix.hpp"

#include "samples/rough_numbers.hpp"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

namespace berm::beam::this_file {
namespace {

constexpr Index size = 40, width = 9;

/// The same matrix with a band and full; `shift` is added to its diagonal.
std::pair<BandMatrix, Eigen::MatrixXd> sample(Real shift)
{
  std::pair<BandMatrix, Eigen::MatrixXd> both = {BandMatrix(size, width), Eigen::MatrixXd::Zero(size, size)};
  const std::vector<Real> numbers = small_numbers(size * (width + 1));
  for (Index i = 0, k = 0; i < size; ++i)
    for (Index j = std::max(0, i - width); j <= i; ++j, ++k) {
      const Real value = numbers[k] + (i == j ? shift : 0);
      both.first.add(i, j, value);
      both.second(i, j) = both.second(j, i) = value;
    }
  return both;
}

TEST(BandMatrix, solves_as_a_full_matrix_does)
{
  auto [band, full] = sample(40);
  std::vector<Real> values = small_numbers(size);
  const Eigen::VectorXd expected = full.ldlt().solve(Eigen::Map<Eigen::VectorXd>(values.data(), size));
  ASSERT_EQ(band.factorize(), 0);
  band.solve(values);
  for (Index i = 0; i < size; ++i) EXPECT_NEAR(values[i], expected[i], 1e-10 * expected.norm());
}

TEST(BandMatrix, counts_negative_eigenvalues)
{
  int counted = 0;
  for (const Real shift : {-50., -1., 0., 1., 50.}) {
    auto [band, full] = sample(shift);
    const Eigen::VectorXd eigenvalues = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(full, Eigen::EigenvaluesOnly).eigenvalues();
    EXPECT_EQ(band.factorize(), (eigenvalues.array() < 0).count());
    counted += static_cast<int>((eigenvalues.array() < 0).count());
  }
  EXPECT_GT(counted, 0);
}

TEST(BandMatrix, says_that_it_is_singular_or_not_finite)
{
  BandMatrix zero(3, 1);
  EXPECT_EQ(zero.factorize(), none);
  BandMatrix endless(2, 1);
  endless.add(0, 0, nan), endless.add(1, 1, 1);
  EXPECT_EQ(endless.factorize(), none);
}

TEST(BandMatrix, leaves_an_unknown_alone_whose_row_is_that_of_the_unit_matrix)
{
  auto [band, full] = sample(40);
  band.set_unit(20);
  full.row(20).setZero(), full.col(20).setZero(), full(20, 20) = 1;
  std::vector<Real> values = small_numbers(size);
  const Eigen::VectorXd expected = full.ldlt().solve(Eigen::Map<Eigen::VectorXd>(values.data(), size));
  ASSERT_EQ(band.factorize(), 0);
  band.solve(values);
  for (Index i = 0; i < size; ++i) EXPECT_NEAR(values[i], expected[i], 1e-10 * expected.norm());
}

}  // namespace
}  // namespace berm::beam::this_file
