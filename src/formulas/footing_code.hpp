// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "formulas/formula.hpp"

// Bearing and sliding resistance of shallow foundations by ISO 19901-4 and API RP 2GEO.

namespace berm::formulas {

/// The part of a base that carries an eccentric load evenly, m2 and m; of a strip per metre run, with an infinite length.
struct EffectiveBase {
  Real area, width, length;
  Real ratio() const { return width / length; }
};

/// A base.
struct FoundationBase {
  enum class Shape : std::uint8_t { strip, circle, rectangle };
  Shape shape = Shape::strip;
  Real width = 0;   ///< m, B or D, in the plane of the load
  Real length = 0;  ///< m, of a rectangle, across that plane
  Real depth = 0;   ///< m below the bed

  Real area() const;
  /// Under a load at an eccentricity e = M/V: B - 2 e of a strip and a rectangle, of a circle a rectangle of the area of the two segments about the load. Nothing from the edge on.
  EffectiveBase under(Real eccentricity) const;
};

/// Clay below and beside a foundation.
struct ClayOfFoundation {
  Real strength = 0;    ///< s_u0 at the base, Pa
  Real growth = 0;      ///< k below it, Pa/m
  Real above = 0;       ///< mean s_u from the bed to the base, Pa
  Real roughness = 1;   ///< 0 to 1: of the base
  Real overburden = 0;  ///< Pa, effective, that the base carries besides where no soil is above it
};

/// V that the base carries beside H and a moment with V at an eccentricity, N (of a strip N/m):
///
///   V = (F (5.14 s_u0 + k B'/4) K_c + sigma_v) A',  K_c = 1 + s_c + d_c - i_c,  i_c = 0.5 - 0.5 sqrt(1 - H'/(A' s_u0)),
///   s_c = s_cv (1 - 2 i_c) B'/L',  d_c = 0.3 (s_u,above/s_u2) atan(z/B'),  s_u2 = F (s_u0 + k B'/(4 5.14)),
///
/// H' = H less what the soil above the base carries, none on the base beside the effective area. F and s_cv by kB'/s_u0. NaN where H is more than the effective area carries. [fit: ISO 19901-4, API RP 2GEO]
Formula code_bearing_clay(const FoundationBase& base, const ClayOfFoundation& clay, Real H, Real eccentricity);
/// H at which it slides, s_u0 times the roughness times A, and K_ru s_u,above B z of the soil above the base, K_ru = 4. [fit: the same]
Formula code_sliding_clay(const FoundationBase& base, const ClayOfFoundation& clay);

/// Sand below a foundation on its surface.
struct SandOfFoundation {
  Real friction_angle = 0;  ///< rad
  Real unit_weight = 0;     ///< effective, N/m3
};
/// V beside H = V tan(inclination): gamma' B'/2 N_gamma s_gamma i_gamma A', N_gamma = 1.5 (N_q - 1) tan phi, i_gamma = (1 - 0.7 H/V)^5, s_gamma = 1 - 0.4 i_gamma B'/L'. [fit: the same]
Formula code_bearing_sand(const FoundationBase& base, const SandOfFoundation& sand, Real H_over_V, Real eccentricity);

}  // namespace berm::formulas
