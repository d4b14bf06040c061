// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "settings/random_field_settings.hpp"

#include <cstdint>

namespace berm::settings {

/// Where soil lies at the start, m: along the bed, below its surface, and across.
struct SoilPlace {
  Real x = 0, depth = 0, z = 0;
};

/// Variance of the mean over a length T of a process of variance 1 with the scale of fluctuation theta:
///
///   markov:    rho = exp(-2 |tau|/theta),      gamma = 2 (theta/2T)^2 (2T/theta - 1 + exp(-2T/theta))
///   gaussian:  rho = exp(-pi (tau/theta)^2),   gamma = (theta/T)^2 (pi T/theta erf(sqrt(pi) T/theta) - 1 + exp(-pi (T/theta)^2)) / pi
///
/// [Vanmarcke, Random Fields, 1983, chapter 5]
Real variance_function(Correlation correlation, Real theta, Real length);

/// Covariance of two means over L = `averaging` (m; 0: of two points) whose centres lie tau = `lag` apart:
///
///   C(tau) = ((tau+L)^2 gamma(tau+L) - 2 tau^2 gamma(tau) + (tau-L)^2 gamma(|tau-L|)) / 2 L^2.   [Vanmarcke 1983, chapter 5]
Real covariance_of_means(Correlation correlation, Real theta, Real averaging, Real lag);

/// The symmetric weights w from -reach to reach with which sums of white noise have this covariance by lag, from 0 to twice the reach: the square root of its spectrum.
std::vector<Real> symmetric_root(const std::vector<Real>& covariance, Index reach);

/// One realisation of a Gaussian field of mean 0 and, at a point, variance 1, whose covariance is a product of functions of the three directions, on a grid of cells.
///
/// Along each direction the value of a cell is a sum of white noise, Z_i = sum_m w_m W_(i+m); w is the symmetric root of the covariance, by its spectrum. W is a function of seed, name
/// and number of the cell alone, and cells are counted from x = depth = z = 0: so is Z, whatever the mesh, its extent and the order of calls. Known values are met by simple
/// kriging, Z + k^T K^-1 (known - Z there). (docs/decisions/0128)
class RandomField {
public:
  struct Known {
    SoilPlace place;
    Real score;  ///< ln of the value over the median, over its standard deviation
  };
  /// In the part of the bed between two places. `path`: "random_field.NAME". Throws KeyError where the grid would be too large, a known value lies outside, or known values contradict the
  /// correlation.
  RandomField(const RandomFieldSettings& settings, const std::string& path, const SoilPlace& lower, const SoilPlace& upper,
              const std::vector<Known>& known = {});

  /// Z in the cell of a place; beyond the part of the bed that of its border.
  Real at(const SoilPlace& place) const;
  /// m, side of the cells along x (0), depth (1) or z (2); infinite along a direction in which nothing varies.
  Real cell_size(int direction) const { return direction_[static_cast<std::size_t>(direction)].cell; }

private:
  /// The grid along a direction.
  struct Direction {
    Real cell = infinity;
    Index first = 0, count = 1;
    std::vector<Real> covariance{1};  ///< by lag in cells
    std::vector<Real> weight{1};      ///< w from -reach to reach

    Index reach() const { return static_cast<Index>(weight.size() / 2); }
    Index cell_at(Real coordinate) const;
  };
  using Cell = std::array<Index, 3>;  ///< from 0 along each direction

  Cell cell_at(const SoilPlace& place) const;
  bool holds(const Cell& cell) const;
  std::size_t place_of(const Cell& cell) const;
  Real covariance(const Cell& a, const Cell& b) const;
  void draw(std::uint64_t key);
  void meet(const std::vector<Known>& known, const std::string& path);

  std::array<Direction, 3> direction_;
  std::vector<Real> value_;  ///< x fastest, then depth
};

}  // namespace berm::settings
