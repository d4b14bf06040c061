// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "formulas/formula.hpp"

// The longitudinal compressive strain at which the wall of a pipe buckles that is bent by its displacement.

namespace berm::formulas {

/// What girth welds leave of the strain: 1 up to D/t = 20, then 1 - (D/t - 20)/100. [fit: as f101_compressive_strain]
Real f101_girth_weld_factor(Real diameter, Real wall);

/// The characteristic strain, positive, without the term by which internal overpressure makes it larger, and with no external overpressure:
///
///   epsilon_c = 0.78 (t/D - 0.01) alpha_h^-1.5 alpha_gw,
///
/// alpha_h the largest ratio of yield stress to tensile strength, alpha_gw the factor of girth welds. [fit: DNV-OS-F101]
Formula f101_compressive_strain(Real diameter, Real wall, Real yield_over_tensile);

/// What it is divided by in the safety class "medium"; 2.0 in "low", 3.3 in "high".
constexpr Real f101_strain_factor_medium = 2.5;
/// What strain of functional loads is multiplied with.
constexpr Real f101_load_factor = 1.1;
/// The largest ratio of yield stress to tensile strength of carbon manganese steel.
constexpr Real f101_yield_over_tensile = 0.93;

}  // namespace berm::formulas
