// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

#include <map>
#include <string>
#include <vector>

namespace berm::cyclic {

/// A point of a contour: the cyclic shear stress over s_u at which N cycles make its strain.
struct ContourPoint {
  Real cycles, stress;
};
using ContourCurve = std::vector<ContourPoint>;  ///< by rising cycles; the stress does not rise

/// Contours by their strain (or pore pressure ratio), each by the average shear stress over s_u.
using ContourTable = std::map<Real, std::map<Real, ContourCurve>>;

/// Contours at one average stress, as gamma(tau_cy/s_u, N) (Andersen 2004, 2015). Along a contour and between average stresses tau_cy is linear in log N and in tau_a; between contours log gamma is linear in log tau_cy
/// at the same N; below the lowest gamma grows with tau_cy from 0.
class Contours {
public:
  Contours() = default;
  /// Throws InputError where the table does not have this average stress, or contours cross.
  Contours(const ContourTable& table, Real average);

  /// The numbers of cycles between which all contours are known.
  Real first() const { return first_; }
  Real last() const { return last_; }
  /// Of all contours, rising.
  const std::vector<Real>& strains() const { return strains_; }

  /// The stress at which N cycles, from first() to last(), make the strain of the k-th contour.
  Real stress(std::size_t k, Real cycles) const;
  /// The strain after N cycles, up to last(), of a stress; infinity above the highest contour. Fewer cycles than first() make their share of the strain of first().
  Real strain(Real tau, Real cycles) const;
  /// The number of cycles of a stress that makes a strain: the largest where contours are level; last() where it takes more.
  Real cycles(Real tau, Real gamma) const;

private:
  /// A contour between two average stresses.
  struct Between {
    ContourCurve low, high;
    Real part;  ///< 0: that of low
  };

  std::vector<Real> strains_;
  std::vector<Between> curves_;
  Real first_ = 0, last_ = 0;
};

}  // namespace berm::cyclic
