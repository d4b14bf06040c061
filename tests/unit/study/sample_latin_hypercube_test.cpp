// SPDX-License-Identifier: BSD-3-Clause
#include "study/sample.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace berm::study::this_file {
namespace {

using Shares = std::vector<std::vector<Real>>;

TEST(LatinHypercube, has_one_share_in_each_part_of_each_parameter)
{
  for (const std::size_t rows : {1, 7, 100})
    for (std::vector<Real> shares : latin_hypercube(5, rows, 1)) {
      std::sort(shares.begin(), shares.end());
      for (std::size_t k = 0; k < rows; ++k) {
        EXPECT_GT(shares[k] * static_cast<Real>(rows), static_cast<Real>(k));
        EXPECT_LT(shares[k] * static_cast<Real>(rows), static_cast<Real>(k + 1));
      }
    }
}
TEST(LatinHypercube, is_the_same_everywhere)
{
  // From another program, which follows the words of the header and the definition of mt19937_64.
  EXPECT_EQ(latin_hypercube(2, 4, 7), (Shares{{0.4729782941781191, 0.5353178908009467, 0.013773289625985757, 0.9581307451328614},
                                              {0.43893625868502417, 0.8990471951946083, 0.09936136360393347, 0.5771321791568685}}));
}
TEST(LatinHypercube, of_more_parameters_keeps_those_before)
{
  const Shares two = latin_hypercube(2, 9, 5), three = latin_hypercube(3, 9, 5);
  EXPECT_EQ(Shares(three.begin(), three.begin() + 2), two);
  EXPECT_NE(three[1], three[2]);
  EXPECT_NE(latin_hypercube(2, 9, 6), two);
}
TEST(LatinHypercube, pairs_its_parameters_at_random)
{
  // Two parameters of 1000 rows: the correlation of shares has a deviation of 1/sqrt(1000) = 0.03; four of them.
  const Shares shares = latin_hypercube(2, 1000, 1);
  Real sum = 0;
  for (std::size_t k = 0; k < 1000; ++k) sum += (shares[0][k] - 0.5) * (shares[1][k] - 0.5) * 12 / 1000;
  EXPECT_LT(std::abs(sum), 0.13);
}

}  // namespace
}  // namespace berm::study::this_file
