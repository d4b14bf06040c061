// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/mesh/lattice_seabed_test.cpp, tests/unit/mesh/spatial_seabed_test.cpp
#pragma once

#include "core/types.hpp"

#include <algorithm>
#include <cmath>

namespace berm::mesh {

/// Size of a cell by its distance from the fine zone, m, and the number of cells up to there.
struct Coarsening {
  Real first, rate, last;

  Real grown() const { return rate > 0 ? (last - first) / rate : infinity; }  ///< distance at which cells have their last size
  Real count(Real distance) const
  {
    const Real growing = std::min(distance, grown());
    const Real cells = rate > 0 ? std::log1p(rate * growing / first) / rate : growing / first;
    return distance > growing ? cells + (distance - growing) / last : cells;
  }
  Real distance(Real cells) const
  {
    const Real growing = std::min(cells, grown() < infinity ? count(grown()) : infinity);
    const Real way = rate > 0 ? first / rate * std::expm1(rate * growing) : growing * first;
    return cells > growing ? way + (cells - growing) * last : way;
  }
};

}  // namespace berm::mesh
