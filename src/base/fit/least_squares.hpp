// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "os/numbers.hpp"

#include <Eigen/Core>
#include <functional>

namespace berm::fit {

/// Writes the residuals (as many as the vector has) for these unknowns.
using Residuals = std::function<void(const Eigen::VectorXd& unknowns, Eigen::VectorXd& residuals)>;

/// How the minimum is searched for.
struct Search {
  Real difference = 1e-9;    ///< relative error of the residuals, by which derivatives are taken by differences
  int evaluations = 400;     ///< of the residuals, at most, but for those of derivatives
  Real tolerance = 0x1p-26;  ///< relative, of the unknowns and of the sum of squares
};

/// Unknowns at which the sum of squares is least nearby, and the root of that sum.
struct LeastSquares {
  Eigen::VectorXd unknowns;
  Real norm;
};

/// Levenberg and Marquardt's method from `start` (Eigen's, after MINPACK's lmdif). count: of the residuals, at least as many as unknowns.
LeastSquares least_squares(const Residuals& residuals, const Eigen::VectorXd& start, int count, const Search& search = {});

}  // namespace berm::fit
