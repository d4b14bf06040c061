// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "formulas/formula.hpp"

// Whether the effective compression of a hot line bends it out of its place.

namespace berm::formulas {

/// The compression at which a line that is laid in a curve of radius R is pushed sideways by P/R against the resistance h (N/m): P = h R, N. [exact: of a line without
/// bending stiffness]
Formula curve_buckling_force(Real lateral, Real radius);

/// Elongation that a buckle takes from both sides, m: (P_0 - P)^2/(EA f), P_0 the compression where the line does not move, P that in the buckle, f the axial resistance.
/// [exact: for friction that is mobilised at once]
Formula buckle_feed_in(Real constrained_force, Real compression, Real axial_stiffness, Real axial);

/// What holds a line down on a prop of the bed, N/m, its own weight included, for a compression P not to lift it:
/// w = (1.16 - 4.76 sqrt(EI w_0/delta)/P) P sqrt(delta w_0/EI), delta the height of the prop and w_0 the submerged weight under which the line was laid over it; at
/// least 0. [fit: Palmer and others 1990]
Formula palmer_download(Real compression, Real bending_stiffness, Real weight_at_laying, Real height);

/// Vertical load of laying over the submerged weight: 0.6 + 0.4 (Q_v EI/(T_0^2 w))^0.25, Q_v the resistance at the embedment w and T_0 the tension on the bed. [fit: DNV-RP-F114]
Formula f114_lay_factor(Real resistance, Real embedment, Real bending_stiffness, Real tension);

}  // namespace berm::formulas
