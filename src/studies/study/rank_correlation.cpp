// SPDX-License-Identifier: BSD-3-Clause
#include "study/rank_correlation.hpp"

#include "study/sample.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <fmt/format.h>
#include <numeric>

namespace berm::study {
namespace {

/// The correlation of normal scores that is asked for.
Eigen::MatrixXd wanted_matrix(const std::vector<SampleCorrelation>& correlations, const std::vector<std::string>& names)
{
  const auto count = static_cast<Eigen::Index>(names.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(count, count);
  for (const SampleCorrelation& each : correlations) {
    const auto place = [&](std::size_t k) { return std::find(names.begin(), names.end(), each.parameters[k]) - names.begin(); };
    matrix(place(0), place(1)) = matrix(place(1), place(0)) = 2 * std::sin(pi / 6 * each.rank);
  }
  return matrix;
}

}  // namespace

void describe(Describe& d, SampleCorrelation& correlation)
{
  d.value("parameters", correlation.parameters, {.meaning = "names of two parameters of the sample", .required = true});
  d.value("rank", correlation.rank,
          {.meaning = "their rank correlation (Spearman): 1 they rise together, 0 independent",
           .range = {-1, 1, true, true},
           .required = true});
}

void check(Describe& d, const std::vector<SampleCorrelation>& correlations, const std::vector<std::string>& names, int rows)
{
  if (correlations.empty()) return;
  bool pairs = true;
  for (std::size_t k = 0; k < correlations.size(); ++k) {
    const std::string path = fmt::format("sample.correlation[{}].parameters", k);
    const std::vector<std::string>& both = correlations[k].parameters;
    const auto require = [&](bool holds, const std::string& why, const std::vector<std::string>& known = {}) {
      d.check(holds, path, why, known);
      pairs = pairs && holds;
    };
    require(both.size() == 2 && both[0] != both[1], "needs the names of two parameters");
    for (const std::string& name : both)
      require(std::find(names.begin(), names.end(), name) != names.end(), fmt::format("there is no parameter \"{}\"", name), names);
    for (std::size_t before = 0; before < k; ++before) {
      const std::vector<std::string>& other = correlations[before].parameters;
      require(!std::is_permutation(both.begin(), both.end(), other.begin(), other.end()), "is given twice");
    }
  }
  d.check(rows > static_cast<int>(names.size()), "sample.size", "must be larger than the number of parameters where they are correlated");
  if (!pairs) return;
  const Real least = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(wanted_matrix(correlations, names)).eigenvalues()[0];
  constexpr Real enough = 1e-6, comfortable = 0.01;
  d.check(least > enough, "sample.correlation",
          fmt::format("contradict each other: what rises with two parameters cannot have these two fall with each other (the matrix of "
                      "correlations is not positive definite, its least eigenvalue is {:.3g}). All of them times {:.2f} are possible",
                      least, (1 - comfortable) / (1 - least)));
}

std::vector<Real> places_of(const std::vector<Real>& values)
{
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  std::vector<Real> places(values.size());
  for (std::size_t first = 0, end = 0; first < order.size(); first = end) {
    while (end < order.size() && values[order[end]] == values[order[first]]) ++end;
    for (std::size_t k = first; k < end; ++k) places[order[k]] = static_cast<Real>(first + end - 1) / 2;
  }
  return places;
}

Real rank_correlation(const std::vector<Real>& x, const std::vector<Real>& y)
{
  if (x.size() < 3) return nan;
  const std::vector<Real> of_x = places_of(x), of_y = places_of(y);
  const Real middle = static_cast<Real>(x.size() - 1) / 2;
  Real xy = 0, xx = 0, yy = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    xy += (of_x[k] - middle) * (of_y[k] - middle);
    xx += (of_x[k] - middle) * (of_x[k] - middle);
    yy += (of_y[k] - middle) * (of_y[k] - middle);
  }
  return xx > 0 && yy > 0 ? xy / std::sqrt(xx * yy) : nan;
}

std::vector<std::vector<Real>> with_rank_correlations(std::vector<std::vector<Real>> shares,
                                                      const std::vector<SampleCorrelation>& correlations,
                                                      const std::vector<std::string>& names)
{
  if (correlations.empty()) return shares;
  const auto rows = static_cast<Eigen::Index>(shares[0].size()), count = static_cast<Eigen::Index>(shares.size());
  Eigen::MatrixXd scores(rows, count);
  for (Eigen::Index j = 0; j < count; ++j) {
    const std::vector<Real> places = places_of(shares[j]);
    for (Eigen::Index k = 0; k < rows; ++k) scores(k, j) = standard_normal_quantile((places[k] + 1) / static_cast<Real>(rows + 1));
  }
  // All columns have the same numbers, so that their products are correlations but for a factor.
  const Eigen::MatrixXd found = scores.transpose() * scores / scores.col(0).squaredNorm();
  const Eigen::MatrixXd root = found.llt().matrixL(), wanted = wanted_matrix(correlations, names).llt().matrixL();
  const Eigen::MatrixXd correlated = root.triangularView<Eigen::Lower>().solve(scores.transpose()).transpose() * wanted.transpose();
  for (Eigen::Index j = 0; j < count; ++j) {
    std::vector<Real> column(rows), sorted = shares[j];
    for (Eigen::Index k = 0; k < rows; ++k) column[k] = correlated(k, j);
    std::sort(sorted.begin(), sorted.end());
    const std::vector<Real> places = places_of(column);
    for (Eigen::Index k = 0; k < rows; ++k) shares[j][k] = sorted[static_cast<std::size_t>(places[k])];
  }
  return shares;
}

}  // namespace berm::study
