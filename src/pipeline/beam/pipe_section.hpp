// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

namespace berm::beam {

/// What an element of the line has in its cross section.
struct Section {
  Real bending_stiffness = 0;  ///< EI, N m2, the same in both planes
  Real axial_stiffness = 0;    ///< EA, N
  Real mass = 0;               ///< kg/m, that moves sideways and upwards: of the pipe, what is in it, and the water that it carries along
  Real axial_mass = 0;         ///< kg/m, that moves along the line
  Real submerged_weight = 0;   ///< N/m
  Real radius = 0;             ///< m, of the outermost fibre
};

/// A round pipe of one material, full of its content, in water.
struct Pipe {
  Real outer_diameter = 0, wall = 0;  ///< m
  Real young_modulus = 0;             ///< Pa
  Real poisson_ratio = 0;
  Real expansion = 0;                                        ///< 1/K, of length
  Real density = 0, content_density = 0, water_density = 0;  ///< kg/m3
  Real added_mass = 1;                                       ///< over the mass of the water that the pipe displaces
  Real outer_area() const { return pi / 4 * outer_diameter * outer_diameter; }
  Real inner_area() const { return pi / 4 * (outer_diameter - 2 * wall) * (outer_diameter - 2 * wall); }
  Real wall_area() const { return outer_area() - inner_area(); }
};

/// Its section, the wall as thick as it is: with the areas A_e outside, A_i inside and A_s of the wall,
///
///   I = pi/64 (D^4 - (D - 2t)^4),  EA = E A_s,  W = g (rho A_s + rho_c A_i - rho_w A_e),
///   m = rho A_s + rho_c A_i + C_a rho_w A_e across the line, and without the last term along it.
Section section_of(const Pipe& pipe);

/// The effective compression of a length that cannot get longer, N:
///
///   P_0 = E A_s alpha dT + (1 - 2 nu) A_i dp - T,
///
/// dT and dp the rises of temperature (K) and internal pressure (Pa) since it was laid under the effective tension T (N). The effective force is that of the wall less A_i p: it
/// is what bends and buckles the line. The sum of hoop and radial stress, 2 p A_i/A_s, is the same all over the wall (Lame), so the formula is exact for thick walls, too (Fyrileiv and
/// Collberg 2005; DNV-RP-F110). Ends that are free and closed have the effective force zero.
Real constrained_force(const Pipe& pipe, Real temperature_rise, Real pressure_rise, Real lay_tension);

}  // namespace berm::beam
