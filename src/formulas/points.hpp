// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/formulas/pile_axial_test.cpp
#pragma once

#include "core/types.hpp"

#include <algorithm>
#include <array>

namespace berm::formulas {

/// y over ascending x by straight lines, level beyond both ends.
template <std::size_t n>
Real along_points(const std::array<Real, n>& x, const std::array<Real, n>& y, Real at)
{
  if (at <= x.front()) return y.front();
  if (!(at < x.back())) return y.back();
  const std::size_t k = std::upper_bound(x.begin(), x.end(), at) - x.begin();
  return std::lerp(y[k - 1], y[k], (at - x[k - 1]) / (x[k] - x[k - 1]));
}

}  // namespace berm::formulas
