// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "formulas/formula.hpp"

// Resistance of the seabed to a pipe that slides along its axis.

namespace berm::formulas {

/// Half of the angle over which the pipe touches the soil: cos b = 1 - 2 w/D, at most pi/2. 0 at and above the surface.
Real contact_angle(Real diameter, Real embedment);

/// The normal force all around the contact over the vertical load that makes it: zeta = 2 sin b/(b + sin b cos b), for a normal stress that falls with the cosine of
/// the angle from the invert. 1 at the surface, 4/pi from w = D/2 on. [exact: for that stress; White and Randolph 2007; DNV-RP-F114]
Formula wedging_factor(Real diameter, Real embedment);

/// Drained axial resistance, N/m, of an interface with the friction angle delta under a vertical load V: zeta tan(delta) V. [exact: as the wedging factor]
Formula axial_drained(Real diameter, Real embedment, Real delta, Real V);

/// Undrained axial resistance, N/m, of an interface with this shear strength, Pa, over its whole length D b. [exact: where it acts all around]
Formula axial_undrained(Real diameter, Real embedment, Real strength);

/// The friction of both faces of a skirt or an open pile that slides along its axis, N: strength times pi (D + d) z, with this shear strength of the interface, Pa, on average, and the
/// soil inside at the level of the bed. [exact: where it acts over both faces]
Formula skirt_friction(Real outer_diameter, Real inner_diameter, Real depth, Real strength);

/// What clay at the surface of a pipe carries once it has consolidated under the pipe.
struct ConsolidatedInterface {
  Real ratio;              ///< s_u/sigma'_v of the normally consolidated clay
  Real exponent = 0;       ///< m of OCR^m
  Real roughness = 1;      ///< alpha: share of the clay's strength that the surface has
  Real preload_ratio = 1;  ///< OCR: largest V so far over that of now; 1 where it is less
};

/// Undrained axial resistance, N/m, after the share U of the excess pore pressure under the load V has gone: alpha (s_u/sigma'_v)_nc OCR^m zeta U V.
/// [fit: DNV-RP-F114, with U = 1]
Formula axial_consolidated(Real diameter, Real embedment, Real V, Real U, const ConsolidatedInterface& clay);

/// Axial displacement at breakout, m: min(1.25 mm, 0.0025 D), min(5 mm, 0.01 D), max(50 mm, 0.01 D). [fit: DNV-RP-F114]
Estimates f114_axial_breakout_displacement(Real diameter);

/// Axial displacement from which the resistance is residual, m: min(7.5 mm, 0.015 D), min(30 mm, 0.06 D), max(250 mm, 0.5 D). [fit: DNV-RP-F114]
Estimates f114_axial_residual_displacement(Real diameter);

}  // namespace berm::formulas
