// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/plot/isometric_raster_test.cpp
#pragma once

#include "core/types.hpp"

#include <cmath>

namespace berm::plot {

/// Where a point is in an isometric picture, seen from the positive side of all axes with y up: m to the right and m up.
inline Vec<2> isometric(const Vec<3>& x)
{
  return {(x[0] - x[2]) / std::sqrt(2.), (2 * x[1] - x[0] - x[2]) / std::sqrt(6.)};
}

/// How far a point is towards the eye of that picture, m.
inline Real towards_eye(const Vec<3>& x)
{
  return x.sum() / std::sqrt(3.);
}

}  // namespace berm::plot
