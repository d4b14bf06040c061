// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/describe.hpp"

namespace berm::material {

/// Where the water in the pores of a soil goes while the soil is deformed.
enum class Drainage {
  drained,   ///< it flows freely, and there is no excess pore pressure
  undrained  ///< it stays, and its pressure follows the volume of the soil
};

/// The water in the pores of a soil whose law is one of effective stress: parameters.
struct PoreWater {
  Drainage drainage = Drainage::undrained;
  std::optional<Real> bulk_modulus;  ///< K_w, Pa; empty: K_w / n is `stiffness_over_skeleton` P-wave moduli of the skeleton
  std::optional<Real> porosity;      ///< n; empty: e / (1 + e) of the law's void ratio
  Real water_depth = 0;              ///< m
  std::optional<Real> min_pressure;  ///< Pa, of the excess pore pressure; empty: that of cavitation

  bool operator==(const PoreWater&) const = default;
};

void describe(Describe& d, PoreWater& water);

/// The smallest excess pore pressure that water carries: it cavitates at no absolute pressure, -(100 kPa + rho_w g depth of the water), Pa.
Real min_pore_pressure(const PoreWater& water);

}  // namespace berm::material
