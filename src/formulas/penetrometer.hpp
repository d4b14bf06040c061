// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "formulas/formula.hpp"

namespace berm::formulas {

/// A body that is pushed deep into undrained clay of Tresca's law, with its steady resistance.
struct DeepInClay {
  Real rigidity_index = 0;  ///< I_r = G/s_u
  Real roughness = 0;       ///< shear strength of the interface over s_u, 0 (smooth) to 1 (rough); NaN: not known
  Real anisotropy = 0;      ///< Delta = (sigma_v0 - sigma_h0)/(2 s_u)
};

/// Pressure in a cavity that has grown from nothing, less the stress before, over s_u: sphere (4/3)(1 + ln I_r), cylinder 1 + ln I_r. Incompressible soil of Tresca's
/// law. [exact: Gibson and Anderson 1961]
Formula sphere_limit(Real rigidity_index);
Formula cylinder_limit(Real rigidity_index);

/// Cone factors of a cone of 60 degrees, N_kt = (q_t - sigma_v0)/s_u, with face and shaft of one roughness a:
/// (4/3)(1 + ln I_r)(1.25 + I_r/2000) + 2.4 a - 0.2 a - 1.8 Delta. [recalled: Teh and Houlsby 1991]
Formula cone_factor_strain_path(const DeepInClay& cone);
/// 3.4 + 1.6 ln I_r - 1.9 Delta + 1.3 a. [recalled: Lu and others 2004]
Formula cone_factor_remeshed(const DeepInClay& cone);
/// 2.45 + 1.8 ln I_r - 2.1 Delta. [recalled: Abu-Farsakh, Tumay and Voyiadjis 2003]
Formula cone_factor_steady(const DeepInClay& cone);

/// q/s_u of a sphere around which clay flows: 11.0 to 11.8 smooth, 15.1 to 15.3 rough, straight line in the roughness; the mean of the bounds.
/// [recalled: Randolph, Martin and Hu 2000]
Formula ball_factor(Real roughness);

/// V/(D^2 s_u) of a smooth sphere wished in place with its lowest point w below the surface of weightless clay; table at w/D of 0.05, 0.1, 0.3 and 0.5, between them a
/// power of w/D. [exact at the entries: characteristics, hypothesis of Haar and von Karman]
Formula smooth_sphere(Real w_over_D);

/// q/s_u of a deep round plate: 12.42 smooth, 13.11 rough, straight line in the roughness. [recalled: Martin and Randolph 2001]
Formula deep_plate_factor(Real roughness);

}  // namespace berm::formulas
