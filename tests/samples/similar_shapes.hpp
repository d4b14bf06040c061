// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <vector>

namespace berm::test {

/// A line on a plane with Coulomb's friction that grows in its own shape.
enum class SimilarKind { symmetric, antisymmetric, pulled_end };

/// Its largest ordinate and second derivative.
struct SimilarShape {
  Real ordinate, curvature;
};

/// The shape g(s) by finite differences:
///
///   g'''' + p g'' = -sign(4 g - turn s g'),  g -> 0 far away,
///
/// p = 1 and g symmetric or antisymmetric for a buckle v = (w EI/P^2) g(x sqrt(P/EI)) while P falls; p = 0, g''(0) = 0, g'''(0) = 1 for the end of a line that a growing force F pulls sideways, v = F^4/(EI w^3) g(x w/F).
/// `turn` 1: friction resists the motion; 0: the displacement. The sign is a hyperbolic tangent at first, and sharper and sharper then. Throws where no shape is found.
class SimilarShapes {
public:
  SimilarShapes(SimilarKind kind, Real turn, int intervals = 600)
      : kind_(kind),
        count_(intervals),
        h_((kind == SimilarKind::pulled_end ? 6. : 18.) / intervals),
        unit_(kind == SimilarKind::pulled_end ? 0.05 : 1),
        g_(intervals)
  {
    for (int i = 0; i < count_; ++i) {
      const Real s = i * h_;
      g_[i] = kind == SimilarKind::symmetric       ? 12 * std::exp(-s * s / 9) * std::cos(s)
              : kind == SimilarKind::antisymmetric ? 9 * std::exp(-s * s / 16) * std::sin(s)
                                                   : 0.3 * std::exp(-s) * (1 - 0.6 * s);
    }
    for (Real smooth = 4; smooth > 0.5; smooth *= 0.8) solve(smooth * unit_, 0);
    for (int k = 1; k <= 20; ++k) solve(0.5 * unit_, turn * k / 20);
    for (Real smooth = 0.5; smooth > 1e-3; smooth *= 0.8) solve(smooth * unit_, turn);
  }

  SimilarShape shape() const
  {
    SimilarShape shape{std::abs(g_[0]), kind_ == SimilarKind::symmetric ? 2 * std::abs(g_[1] - g_[0]) / (h_ * h_) : 0};
    for (int i = 1; i + 1 < count_; ++i) {
      shape.ordinate = std::max(shape.ordinate, std::abs(g_[i]));
      shape.curvature = std::max(shape.curvature, std::abs(g_[i + 1] - 2 * g_[i] + g_[i - 1]) / (h_ * h_));
    }
    return shape;
  }

private:
  /// Adds c g_j to a row, j anywhere: beyond the ends by what holds there.
  void add(Eigen::VectorXd& residual, std::vector<Eigen::Triplet<Real>>& matrix, int row, int j, Real c) const
  {
    if (j >= count_) return;
    if (j >= 0) {
      residual[row] += c * g_[j];
      matrix.emplace_back(row, j, c);
    } else if (kind_ == SimilarKind::symmetric) {
      add(residual, matrix, row, -j, c);
    } else if (kind_ == SimilarKind::antisymmetric) {
      add(residual, matrix, row, -j, -c);
    } else if (j == -1) {
      add(residual, matrix, row, 0, 2 * c), add(residual, matrix, row, 1, -c);
    } else {
      add(residual, matrix, row, 2, c), add(residual, matrix, row, 1, -4 * c), add(residual, matrix, row, 0, 4 * c);
      residual[row] -= c * 2 * h_ * h_ * h_;
    }
  }

  void solve(Real smooth, Real turn)
  {
    const Real p = kind_ == SimilarKind::pulled_end ? 0 : 1, second = 1 / (h_ * h_), fourth = second * second;
    for (int iteration = 0; iteration < 200; ++iteration) {
      Eigen::VectorXd residual = Eigen::VectorXd::Zero(count_), rate = residual;
      std::vector<Eigen::Triplet<Real>> matrix, of_rate;
      for (int i = 0; i < count_; ++i) {
        if (kind_ == SimilarKind::antisymmetric && i == 0) {
          add(residual, matrix, 0, 0, 1);
          continue;
        }
        const Real by_place[5] = {fourth, -4 * fourth + p * second, 6 * fourth - 2 * p * second, -4 * fourth + p * second, fourth};
        for (int k = -2; k <= 2; ++k) add(residual, matrix, i, i + k, by_place[k + 2]);
        of_rate.clear();
        add(rate, of_rate, i, i, 4);
        add(rate, of_rate, i, i + 1, -turn * i / 2), add(rate, of_rate, i, i - 1, turn * i / 2);
        const Real sign = std::tanh(rate[i] / smooth), slope = (1 - sign * sign) / smooth;
        residual[i] += sign;
        for (const Eigen::Triplet<Real>& entry : of_rate) matrix.emplace_back(entry.row(), entry.col(), slope * entry.value());
      }
      if (residual.cwiseAbs().maxCoeff() < 1e-7) return;
      Eigen::SparseMatrix<Real> all(count_, count_);
      all.setFromTriplets(matrix.begin(), matrix.end());
      const Eigen::VectorXd change = Eigen::SparseLU<Eigen::SparseMatrix<Real>>(all).solve(residual);
      const Real part = std::min(1., (iteration < 30 ? 1. : 0.2) * unit_ / change.cwiseAbs().maxCoeff());
      for (int i = 0; i < count_; ++i) g_[i] -= part * change[i];
    }
    throw std::runtime_error("no similar shape at " + std::to_string(smooth) + ", " + std::to_string(turn));
  }

  SimilarKind kind_;
  int count_;
  Real h_, unit_;
  std::vector<Real> g_;
};

}  // namespace berm::test
