// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/describe.hpp"

#include <algorithm>

namespace berm::material {

/// Where the water in the pores of a soil goes while the soil is deformed.
enum class Drainage {
  drained,       ///< it flows freely, and there is no excess pore pressure
  undrained,     ///< it stays, and its pressure follows the volume of the soil
  consolidation  ///< it flows through the pores by Darcy's law
};

constexpr Real water_density = 1000, unit_weight_of_water = 9810;  ///< kg/m3, N/m3

/// The water in the pores of a soil whose law is one of effective stress: parameters.
struct PoreWater {
  Drainage drainage = Drainage::undrained;
  std::optional<Real> bulk_modulus;            ///< K_w, Pa; empty: K_w / n is `stiffness_over_skeleton` P-wave moduli of the skeleton
  std::optional<Real> porosity;                ///< n; empty: e / (1 + e) of the law's void ratio
  Real water_depth = 0;                        ///< m
  std::optional<Real> min_pressure = {};       ///< Pa, of the excess pore pressure; empty: that of cavitation
  std::optional<Real> permeability = {};       ///< k, m/s: hydraulic conductivity, at the porosity of the start
  bool kozeny_carman = false;                  ///< k follows the porosity
  std::optional<Real> real_permeability = {};  ///< m/s, of the soil that is modelled, where k is scaled

  bool operator==(const PoreWater&) const = default;
};

void describe(Describe& d, PoreWater& water);

/// What Darcy's law takes of a soil: the flux is -(k / gamma_w) grad p.
struct Hydraulics {
  Real permeability = 0;       ///< k, m/s, at the porosity of the start
  Real porosity = 0;           ///< n, at the start
  bool kozeny_carman = false;  ///< k grows with n^3 / (1 - n)^2

  /// The porosity once a volume is `ratio` times that of the start, whose grains keep theirs; 0.05 to 0.95.
  Real porosity_at(Real ratio) const { return std::clamp(1 - (1 - porosity) / ratio, 0.05, 0.95); }
  /// k there, m/s (Kozeny 1927; Carman 1937).
  Real permeability_at(Real n) const
  {
    const auto shape = [](Real m) { return m * m * m / ((1 - m) * (1 - m)); };
    return kozeny_carman ? permeability * shape(n) / shape(porosity) : permeability;
  }
};

/// Speed, m/s, of the faster of the two pressure waves of a soil whose water does not resist flow, which limits explicit time steps: the square is the larger
/// root of det([M + Q, Q; Q, Q] - c^2 [rho, rho_w; rho_w, rho_w / n]) = 0, M the P-wave modulus of the skeleton, Q = K_w / n (Pa), rho of the saturated soil.
Real fast_wave_speed(Real skeleton, Real water, Real density, Real porosity);

/// The smallest excess pore pressure that water carries: it cavitates at no absolute pressure, -(100 kPa + rho_w g depth of the water), Pa.
Real min_pore_pressure(const PoreWater& water);

}  // namespace berm::material
