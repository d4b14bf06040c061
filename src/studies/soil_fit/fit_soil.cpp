// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/soil_fit/fit_soil_test.cpp
#include "soil_fit/fit_soil.hpp"

#include "fit/least_squares.hpp"
#include "os/error.hpp"
#include "soil_fit/passages.hpp"
#include "soil_fit/simulate.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <fmt/format.h>
#include <random>

namespace berm::soil_fit {
namespace {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;

constexpr Real failed = 3;             // residual of a row that the law does not reach: three times the largest that was measured
constexpr Real accuracy = 1e-8;        // of what is computed, by which derivatives are taken by differences
constexpr Real smallest_volume = 0.2;  // of the largest strain of a kind in all tests: smaller ones count over that
constexpr Real at_bound = 1e-3;        // of the width of the bounds

/// A curve in the vector of residuals.
struct Place {
  std::size_t test, curve;
  Eigen::Index begin, count;
  Real scale;  ///< SI, that residuals of the curve are over
};

class Problem {
public:
  Problem(const FitCase& c, const std::vector<MeasuredTest>& tests) : c_(c), tests_(tests)
  {
    for (std::size_t t = 0; t < tests.size(); ++t)
      for (std::size_t k = 0; k < tests[t].curves.size(); ++k) {
        if (tests[t].held_out) continue;
        const Eigen::Index count =
            std::count_if(tests[t].curves[k].values.begin(), tests[t].curves[k].values.end(), [](Real x) { return std::isfinite(x); });
        const Real scale = std::max(largest(tests[t].curves[k]),
                                    is_strain(tests[t].curves[k].what) ? smallest_volume * largest_strain(tests[t].curves[k].what) : 0);
        if (count == 0 || !(scale > 0)) continue;  // it says nothing
        places_.push_back({t, k, rows_, count, scale});
        rows_ += count;
        weights_ += tests[t].weight;
      }
  }

  Eigen::Index rows() const { return rows_; }
  const std::vector<Place>& places() const { return places_; }
  int evaluations() const { return evaluations_; }

  static Real largest(const MeasuredCurve& curve)
  {
    Real size = 0;
    for (const Real x : curve.values)
      if (std::isfinite(x)) size = std::max(size, std::abs(x));
    return size;
  }

  Values values_of(const Vector& x) const
  {
    Values values;
    for (std::size_t k = 0; k < c_.free.size(); ++k) {
      const FreeKey& free = c_.free[k];
      values[free.key] = value_at(free, x[static_cast<Eigen::Index>(k)]);
    }
    return values;
  }

  /// What the law makes of a test; without a state where these values do not fit together.
  std::vector<std::vector<Real>> computed(const MeasuredTest& test, const Vector& x) const
  {
    try {
      Values values = values_of(x);
      values.insert(test.specimen.begin(), test.specimen.end());
      if (test.passages) return {resistances(test, material_with(c_, values))};
      const element::StartStress& start = element::start_of(test.settings.kind);
      return simulate(test, material::drained(material::at_depth(material_with(c_, values), 0, start.vertical())), c_.largest_step);
    } catch (const InputError&) {
      return {test.curves.size(), std::vector<Real>(test.rows(), nan)};
    }
  }

  /// By their places: over the scale of their curve. x: over the widths of the bounds.
  void residuals(const Vector& x, Vector& all)
  {
    ++evaluations_;
    std::vector<std::vector<std::vector<Real>>> answers(tests_.size());
    for (std::size_t t = 0; t < tests_.size(); ++t)
      if (!tests_[t].held_out) answers[t] = computed(tests_[t], x);
    for (const Place& place : places_) {
      const std::vector<Real>& measured = tests_[place.test].curves[place.curve].values;
      Eigen::Index n = place.begin;
      for (std::size_t row = 0; row < measured.size(); ++row) {
        if (!std::isfinite(measured[row])) continue;
        const Real answer = answers[place.test][place.curve][row];
        all[n++] = std::isfinite(answer) ? (answer - measured[row]) / place.scale : failed;
      }
    }
  }

  /// The factor of the residuals of a curve in the sum of squares.
  Real factor(const Place& place) const { return std::sqrt(tests_[place.test].weight / static_cast<Real>(place.count) / weights_); }

  void weighted(const Vector& x, Vector& all)
  {
    residuals(x, all);
    for (const Place& place : places_) all.segment(place.begin, place.count) *= factor(place);
  }

private:
  Real largest_strain(Compared what) const
  {
    Real most = 0;
    for (const MeasuredTest& test : tests_)
      for (const MeasuredCurve& curve : test.curves)
        if (curve.what == what) most = std::max(most, largest(curve));
    return most;
  }

  const FitCase& c_;
  const std::vector<MeasuredTest>& tests_;
  std::vector<Place> places_;
  Eigen::Index rows_ = 0;
  Real weights_ = 0;
  int evaluations_ = 0;
};

// The bounds: a number without any, z, is x = (1 - cos z) / 2 of their width. z is not near 0 but at a bound: differences are taken by steps in proportion to it.
Vector inside(const Vector& z)
{
  return (1 - z.array().cos()) / 2;
}
Vector outside(const Vector& x)
{
  constexpr Real off = 1e-3;  // at a bound itself no difference shows where to go
  return (1 - 2 * x.array().max(off).min(1 - off)).acos();
}

Vector start_of(const FitCase& c)
{
  Vector x(static_cast<Eigen::Index>(c.free.size()));
  for (std::size_t k = 0; k < c.free.size(); ++k) x[static_cast<Eigen::Index>(k)] = place_of(c.free[k], value_in(c, c.free[k]));
  return x;
}

/// Derivatives of the residuals, unweighted, towards the inside of the bounds.
Matrix jacobian(Problem& problem, const Vector& x)
{
  const Real step = std::cbrt(accuracy);
  Matrix J(problem.rows(), x.size());
  Vector up(problem.rows()), down(problem.rows());
  for (Eigen::Index k = 0; k < x.size(); ++k) {
    Vector high = x, low = x;
    high[k] = std::min(Real(1), x[k] + step), low[k] = std::max(Real(0), x[k] - step);
    problem.residuals(high, up);
    problem.residuals(low, down);
    J.col(k) = (up - down) / (high[k] - low[k]);
  }
  return J;
}

/// How many times as much the mean of a curve's rows scatters as that of independent rows: 1 + 2 times the sum of the correlations of rows that are 1, 2, ... apart, about 0, as far as they
/// are positive. A curve that is off as a whole counts as one row.
Real clustering(const Vector& residuals)
{
  const Eigen::Index count = residuals.size();
  const Real own = residuals.squaredNorm();
  if (count < 4 || !(own > 0)) return 1;
  Real sum = 1;
  for (Eigen::Index apart = 1; apart < count; ++apart) {
    const Real both = residuals.head(count - apart).dot(residuals.tail(count - apart));
    if (both <= 0) break;
    sum += 2 * both / own;
  }
  return std::min(sum, static_cast<Real>(count));
}

/// Standard errors, correlations and flat directions, over the widths of the bounds.
void find_errors(Problem& problem, const Vector& x, FittedSoil& soil)
{
  std::vector<Eigen::Index> loose;
  for (Eigen::Index k = 0; k < x.size(); ++k) {
    soil.keys[static_cast<std::size_t>(k)].at_bound = x[k] < at_bound || x[k] > 1 - at_bound;
    if (!soil.keys[static_cast<std::size_t>(k)].at_bound) loose.push_back(k);
  }
  const Eigen::Index count = static_cast<Eigen::Index>(loose.size());
  soil.correlation = Matrix::Identity(x.size(), x.size());
  if (count == 0) return;
  const Matrix all = jacobian(problem, x);
  Matrix J(problem.rows(), count);
  for (Eigen::Index k = 0; k < count; ++k) J.col(k) = all.col(loose[static_cast<std::size_t>(k)]);
  Vector residuals(problem.rows());
  problem.residuals(x, residuals);
  const Real freedom = static_cast<Real>(problem.rows()) / std::max(static_cast<Real>(problem.rows() - count), Real(1));
  Matrix H = Matrix::Zero(count, count), S = Matrix::Zero(count, count);
  for (const Place& place : problem.places()) {
    const auto rows = J.middleRows(place.begin, place.count);
    const Vector r = residuals.segment(place.begin, place.count);
    const Real w = std::pow(problem.factor(place), 2);
    H += w * rows.transpose() * rows;
    S += w * w * freedom * clustering(r) * rows.transpose() * r.cwiseAbs2().asDiagonal() * rows;
  }
  const Eigen::SelfAdjointEigenSolver<Matrix> axes(H);
  constexpr Real blind = 1e-12;  // of the largest curvature: below, the tests say nothing
  const Real most = std::max(axes.eigenvalues().maxCoeff(), Real(1e-300));
  Vector inverse(count);
  for (Eigen::Index k = 0; k < count; ++k) inverse[k] = 1 / std::max(axes.eigenvalues()[k], blind * most);
  const Matrix H_inverse = axes.eigenvectors() * inverse.asDiagonal() * axes.eigenvectors().transpose();
  const Matrix covariance = H_inverse * S * H_inverse;
  for (Eigen::Index i = 0; i < count; ++i) {
    FittedKey& key = soil.keys[static_cast<std::size_t>(loose[static_cast<std::size_t>(i)])];
    const Real unseen =
        (axes.eigenvectors().row(i).array().square() * (axes.eigenvalues().transpose().array() < blind * most).cast<Real>()).sum();
    key.error = unseen > 0.01 ? infinity : std::sqrt(std::max(covariance(i, i), Real(0))) * slope_of(key.free, key.value);
    for (Eigen::Index j = 0; j < count; ++j) {
      const Real both = std::sqrt(covariance(i, i) * covariance(j, j));
      if (i != j)
        soil.correlation(loose[static_cast<std::size_t>(i)], loose[static_cast<std::size_t>(j)]) = both > 0 ? covariance(i, j) / both : 0;
    }
  }
  constexpr Real wide = 0.1;  // of the widths of the bounds, by one standard error
  const Eigen::SelfAdjointEigenSolver<Matrix> spread(covariance);
  for (Eigen::Index k = count - 1; k >= 0; --k) {
    const Real error = std::sqrt(std::max(spread.eigenvalues()[k], Real(0)));
    if (error < wide) break;
    FlatDirection direction{std::vector<Real>(static_cast<std::size_t>(x.size()), 0)};
    for (Eigen::Index i = 0; i < count; ++i)
      direction.step[static_cast<std::size_t>(loose[static_cast<std::size_t>(i)])] = error * spread.eigenvectors()(i, k);
    soil.flat.push_back(direction);
  }
}

FittedTest compare(const Problem& problem, const MeasuredTest& test, const Vector& x)
{
  FittedTest fitted{test, problem.computed(test, x), {}, {}, true};
  for (std::size_t k = 0; k < test.curves.size(); ++k) {
    Real sum = 0, count = 0;
    for (std::size_t row = 0; row < test.rows(); ++row) {
      const Real measured = test.curves[k].values[row], answer = fitted.computed[k][row];
      if (!std::isfinite(answer)) fitted.complete = false;
      if (std::isfinite(measured) && std::isfinite(answer)) sum += std::pow(answer - measured, 2), count += 1;
    }
    fitted.rms.push_back(count > 0 ? std::sqrt(sum / count) : nan);
    fitted.largest.push_back(Problem::largest(test.curves[k]));
  }
  return fitted;
}

}  // namespace

FittedSoil fit_soil(const FitCase& c, const std::vector<MeasuredTest>& tests)
{
  Problem problem(c, tests);
  const Vector begin = start_of(c);
  FittedSoil soil;
  Vector residuals(problem.rows()), best;
  problem.weighted(begin, residuals);
  soil.misfit_at_start = residuals.norm();
  if (problem.rows() <= begin.size())
    throw InputError(
        fmt::format("{}: {} keys are free, and the tests have {} numbers to fit", c.document.file, begin.size(), problem.rows()));
  std::mt19937_64 random(1);
  std::uniform_real_distribution<Real> anywhere(0.1, 0.9);
  const fit::Residuals function = [&](const Vector& z, Vector& all) { problem.weighted(inside(z), all); };
  for (int n = 0; n < c.starts; ++n) {
    Vector x = begin;
    for (Eigen::Index k = 0; n > 0 && k < x.size(); ++k) x[k] = anywhere(random);
    const fit::LeastSquares found = fit::least_squares(function, outside(x), static_cast<int>(problem.rows()),
                                                       {.difference = accuracy, .evaluations = 100, .tolerance = 1e-5});
    if (!std::isfinite(found.norm)) continue;
    soil.misfits.push_back(found.norm);
    if (best.size() == 0 || found.norm <= *std::min_element(soil.misfits.begin(), soil.misfits.end()))
      best = inside(found.unknowns), soil.misfit = found.norm;
  }
  if (best.size() == 0) throw RunError(c.document.file + ": the law has no state for these tests, wherever the search begins");
  std::sort(soil.misfits.begin(), soil.misfits.end());
  const Values values = problem.values_of(best);
  for (std::size_t k = 0; k < c.free.size(); ++k)
    soil.keys.push_back({c.free[k], value_in(c, c.free[k]), values.at(c.free[k].key), nan, false});
  find_errors(problem, best, soil);
  for (const MeasuredTest& test : tests) soil.tests.push_back(compare(problem, test, best));
  soil.evaluations = problem.evaluations();
  return soil;
}

}  // namespace berm::soil_fit
