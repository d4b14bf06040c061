// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "formulas/formula.hpp"

// Resistance of soil to a pile that is pushed along its axis: friction t of its shaft and Q of its base, over the displacement of the pile.

namespace berm::formulas {

/// The friction of a pile's shaft in clay, Pa: alpha s_u, alpha = 0.5 psi^-0.5 for psi = s_u/sigma_v up to 1 and 0.5 psi^-0.25 beyond, at most 1. [fit: API RP 2GEO]
Formula api_clay_friction(Real strength, Real overburden);
/// The same in sand: K sigma_v tan delta, K = 1 of a closed and 0.8 of an open end, at most a limit that grows with delta. Angle in rad. [fit: API RP 2A-WSD 2000]
Formula api_sand_friction(Real overburden, Real interface_angle, bool closed);

/// The pressure on a pile's base in clay, Pa: 9 s_u. [fit: API RP 2GEO]
Formula api_clay_base(Real strength);
/// The same in sand: N_q sigma_v, N_q from 8 to 50 and its limit by the angle of the interface, rad. [fit: API RP 2A-WSD 2000]
Formula api_sand_base(Real overburden, Real interface_angle);

/// The part of a shaft's friction that a displacement mobilises, static: in clay straight between points over z/D, 1 at 0.01 and 0.9 from 0.02 on (0.7 to 0.9); in sand straight to 1 at 2.54 mm. [fit: API RP 2GEO]
Real api_clay_friction_share(Real displacement, Real diameter);
Real api_sand_friction_share(Real displacement);
/// The same of the base: 1 at 0.1 D. [fit: API RP 2GEO]
Real api_base_share(Real displacement, Real diameter);

}  // namespace berm::formulas
