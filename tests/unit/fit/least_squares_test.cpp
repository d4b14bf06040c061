// SPDX-License-Identifier: BSD-3-Clause
#include "fit/least_squares.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace berm::fit::this_file {
namespace {

TEST(LeastSquares, finds_the_decay_that_made_the_points_to_the_tolerance_of_the_search)
{
  const auto residuals = [](const Eigen::VectorXd& x, Eigen::VectorXd& f) {
    for (Eigen::Index k = 0; k < f.size(); ++k)
      f[k] = x[0] * std::exp(-x[1] * 0.1 * static_cast<Real>(k)) - 3 * std::exp(-0.07 * static_cast<Real>(k));
  };
  const LeastSquares found = least_squares(residuals, Eigen::Vector2d(1, 0.1), 20);
  EXPECT_NEAR(found.unknowns[0], 3, 1e-6);
  EXPECT_NEAR(found.unknowns[1], 0.7, 1e-6);
  EXPECT_LT(found.norm, 1e-6);
}

TEST(LeastSquares, of_a_line_is_that_of_the_normal_equations)
{
  const Eigen::Vector4d y(1, 3, 2, 6);
  const auto residuals = [&](const Eigen::VectorXd& x, Eigen::VectorXd& f) {
    for (Eigen::Index k = 0; k < 4; ++k) f[k] = x[0] + x[1] * static_cast<Real>(k) - y[k];
  };
  const LeastSquares found = least_squares(residuals, Eigen::Vector2d(0, 0), 4);
  EXPECT_NEAR(found.unknowns[0], 0.9, 1e-6);  // mean 3, slope 7/5
  EXPECT_NEAR(found.unknowns[1], 1.4, 1e-6);
  EXPECT_NEAR(found.norm * found.norm, 4.2, 1e-6);
}

}  // namespace
}  // namespace berm::fit::this_file
