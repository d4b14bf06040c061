// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/describe.hpp"

#include <optional>
#include <string>
#include <vector>

namespace berm::base {

/// A published number in a chart of V over w, H over u or w over u; without x it is a level.
struct PublishedPoint {
  enum class Chart { V_w, H_u, w_u };
  Chart chart = Chart::V_w;
  std::optional<Real> x;  ///< m
  Real y = 0;             ///< N/m or m
  std::string label;
};
using PublishedPoints = std::vector<PublishedPoint>;

void describe(Describe& d, PublishedPoint& point);

/// The word of a chart: "V_w".
const char* word_of(PublishedPoint::Chart chart);

}  // namespace berm::base
