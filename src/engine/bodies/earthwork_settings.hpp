// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/rigid/polygon.hpp"

namespace berm::bodies {

/// Where and when soil is placed or taken out: what fills and excavations have in common.
struct EarthworkSettings {
  std::string name;
  std::string stage;          ///< at whose begin it starts
  PolygonSettings area;       ///< in space a prism along z
  std::vector<Real> z_range;  ///< m, from and to, in space; empty: all along z
  int lifts = 1;              ///< equal steps of height, one after the other
  Real duration = 0;          ///< s from the first lift to when one after the last would be due
};

/// Soil that a stage takes out, from the top down.
struct ExcavationSettings : EarthworkSettings {};

/// Soil that a stage places where there is none, from the bottom up.
struct FillSettings : EarthworkSettings {
  std::string material;
  std::optional<Real> k0;  ///< horizontal over vertical stress that each lift has from its own weight; empty: no stress
};

void describe(Describe& d, ExcavationSettings& excavation);
void describe(Describe& d, FillSettings& fill);

}  // namespace berm::bodies
