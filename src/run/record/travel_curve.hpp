// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

#include <vector>

namespace berm::record {

/// A noisy quantity along a travel that only grows.
class TravelCurve {
public:
  /// Takes the rows whose travel is beyond that of all earlier rows; rows where either is NaN are left out.
  TravelCurve(const std::vector<Real>& travel, const std::vector<Real>& value);

  bool empty() const { return travel_.empty(); }
  const std::vector<Real>& travel() const { return travel_; }
  const std::vector<Real>& value() const { return value_; }
  Real begin() const { return travel_.front(); }
  Real end() const { return travel_.back(); }

  /// The value at s, freed from noise: that of the straight line fitted over s - half ... s + half, each row weighted by the travel that it
  /// stands for. Away from the ends this is the mean over that travel; near an end the window stays inside the curve and the line is followed
  /// to s, where a mean would lag by half a window. With fewer than three rows in the window, linear interpolation. NaN where s is outside the
  /// curve or the curve is empty.
  Real at(Real s, Real half) const;

  /// A curve for averaging over +-half: itself, but of more than 10000 points those within half/50 of travel are one, their mean; the ends stay. at()
  /// takes as long as there are points in its window.
  TravelCurve condensed(Real half) const;

  /// The curve of at(s, half), at its own travels; of more than 2000 travels, at 2000 equally spaced ones from begin to end.
  TravelCurve smoothed(Real half) const;

  /// The same as it is drawn: its windows do not reach from the first row further than to both sides of s, so that it begins at that row, and are a tenth of the travel at most.
  TravelCurve drawn(Real half) const;

private:
  friend std::vector<Real> drawn_along(const std::vector<Real>& travel, const std::vector<Real>& value, Real half);

  Real interpolated(Real s) const;
  std::vector<Real> marks() const;
  Real drawn_at(Real s, Real half) const;

  std::vector<Real> travel_, value_;
};

/// Values along a travel as a smooth line is drawn through their rows (TravelCurve::drawn), by row; half = 0: the values. NaN in all rows where the travel goes back by more than
/// half of a window: a mean over a travel that goes back and forth means nothing.
std::vector<Real> drawn_along(const std::vector<Real>& travel, const std::vector<Real>& value, Real half);

}  // namespace berm::record
