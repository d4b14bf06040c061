// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cyclic/contours.hpp"

#include <cmath>

namespace berm::cyclic {

/// gamma = scale (tau_cy/s_u)^b N^c, on whose contours tau_cy falls with N^(-c/b).
struct PowerLaw {
  Real scale = 0.15 / std::pow(1.2, 4), b = 4, c = 0.5;

  Real strain(Real stress, Real cycles) const { return scale * std::pow(stress, b) * std::pow(cycles, c); }
  Real stress(Real strain, Real cycles) const { return std::pow(strain / (scale * std::pow(cycles, c)), 1 / b); }
  /// Of a stress, to a strain.
  Real cycles(Real stress, Real strain) const { return std::pow(strain / (scale * std::pow(stress, b)), 1 / c); }

  /// Its contours from 1 to 10^4 cycles, with so many points per tenfold number.
  ContourTable table(int points) const
  {
    ContourTable all;
    for (const Real strain : {0.005, 0.01, 0.03, 0.15})
      for (int k = 0; k <= 4 * points; ++k) {
        const Real n = std::pow(10., Real(k) / points);
        all[strain][0].push_back({n, stress(strain, n)});
      }
    return all;
  }

  /// A chord of exp(-c/b x), x = log N, lies above it by (h c/b)^2/8 of it at most, h = ln(10)/points being its length.
  Real error_of_stress(int points) const { return std::pow(std::log(10.) / points * c / b, 2) / 8; }
};

/// Drammen clay, plasticity index 27, simple shear, 15 % (Andersen 2015, as docs/validation.md has it).
inline ContourTable drammen()
{
  ContourTable all;
  const Real average[] = {0, 0.25, 0.5, 0.75}, at_10[] = {0.924, 0.893, 0.76, 0.444}, at_100[] = {0.692, 0.677, 0.516, 0.288},
             at_1000[] = {0.547, 0.524, 0.395, 0.219};
  for (int k = 0; k < 4; ++k) all[0.15][average[k]] = {{10, at_10[k]}, {100, at_100[k]}, {1000, at_1000[k]}};
  return all;
}

}  // namespace berm::cyclic
