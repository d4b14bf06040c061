// SPDX-License-Identifier: BSD-3-Clause
#include "fit/least_squares.hpp"

#include <unsupported/Eigen/NonLinearOptimization>
#include <unsupported/Eigen/NumericalDiff>

namespace berm::fit {
namespace {

/// What Eigen's algorithms ask of a function.
struct Function {
  using Scalar = Real;
  using InputType = Eigen::VectorXd;
  using ValueType = Eigen::VectorXd;
  using JacobianType = Eigen::MatrixXd;
  enum { InputsAtCompileTime = Eigen::Dynamic, ValuesAtCompileTime = Eigen::Dynamic };

  const Residuals& residuals;
  int unknowns, count;

  int inputs() const { return unknowns; }
  int values() const { return count; }
  int operator()(const InputType& x, ValueType& f) const
  {
    residuals(x, f);
    return 0;
  }
};

}  // namespace

LeastSquares least_squares(const Residuals& residuals, const Eigen::VectorXd& start, int count, const Search& search)
{
  const Function function{residuals, static_cast<int>(start.size()), count};
  Eigen::NumericalDiff<Function> with_derivatives(function, search.difference);
  Eigen::LevenbergMarquardt<Eigen::NumericalDiff<Function>> method(with_derivatives);
  method.parameters.maxfev = search.evaluations;
  method.parameters.ftol = method.parameters.xtol = search.tolerance;
  LeastSquares found{start, nan};
  method.minimize(found.unknowns);
  found.norm = method.fnorm;
  return found;
}

}  // namespace berm::fit
