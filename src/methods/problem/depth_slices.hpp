// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/axes.hpp"

#include <algorithm>

namespace berm::problem {

/// Slices of the part of a rigid body that is in the soil at the start, from the bed down to its lowest point, all of one thickness. They go up and down with its centre.
struct DepthSlices {
  Index count = 0;     ///< 0: forces on the body are not told apart by depth
  Real top = 0;        ///< m, height of the bed over its centre at the start (Axes::height)
  Real thickness = 0;  ///< m

  /// The slice that has a point of the surface so high over the centre, m; what lies beyond counts to the first or the last.
  Index at(Real height_over_center) const
  {
    return std::clamp(static_cast<Index>(std::floor((top - height_over_center) / thickness)), Index(0), count - 1);
  }
  /// Calls give(slice, fraction) for the slices between two heights over the centre, m, with the fraction of the way that lies in each. The fractions add up to 1.
  template <class Give>
  void share(Real lower, Real upper, const Give& give) const
  {
    const Index first = at(upper), last = at(lower);
    Real left = 1;
    for (Index k = first; k < last; ++k) {
      const Real from = k == first ? upper : top - k * thickness;
      const Real fraction = std::clamp((from - top + (k + 1) * thickness) / (upper - lower), Real(0), left);
      give(k, fraction);
      left -= fraction;
    }
    give(last, left);
  }
};

}  // namespace berm::problem
