// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "formulas/formula.hpp"

// When waves and currents move the sand of a seabed.

namespace berm::formulas {

/// Critical Shields parameter of quartz sand of a median grain size d (m) in sea water of 10 deg: theta_cr = 0.30/(1 + 1.2 D*) + 0.055 (1 - exp(-0.020 D*)), D* = d ((s - 1) g/nu^2)^(1/3), s = 2.65,
/// nu = 1.36e-6 m2/s. [fit: Soulsby and Whitehouse 1997]
Formula critical_shields(Real grain);

/// Water over a flat bed of sand: amplitude (m/s) and period (s) of the oscillation, and a current (m/s) at a height (m), over a bed of roughness z_0 (m).
struct BedFlow {
  Real velocity = 0, period = 0;                   ///< of the waves
  Real current = 0, height = 1, roughness = 1e-5;  ///< V_r at z_r
  Real angle = 0;                                  ///< rad, between waves and current
};

/// The largest Shields parameter in a wave, tau_max/(rho (s - 1) g d):
///
///   tau_w = rho/2 f_w U^2,  f_w = 0.237 (A/(2.5 d))^-0.52,  A = U T/(2 pi);   tau_c = rho (0.4 V_r/ln(1 + z_r/z_0))^2,
///   tau_m = tau_c (1 + 1.2 (tau_w/(tau_c + tau_w))^3.2),   tau_max^2 = (tau_m + tau_w cos)^2 + (tau_w sin)^2.
///
/// [fit: Soulsby 1997]
Formula shields_parameter(const BedFlow& flow, Real grain);

}  // namespace berm::formulas
