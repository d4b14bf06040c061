// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "formulas/formula.hpp"

namespace berm::formulas {

/// A pipe in undrained clay, wished in place below a level surface unless a formula says otherwise. The clay_... formulas
/// give the resistance of the strength; the buoyancy of the displaced clay is additional.
struct PipeInClay {
  Real diameter;               ///< D, m
  Real embedment;              ///< w, m: depth of the invert below the surface
  Real strength;               ///< s_u, Pa: undrained shear strength at the depth of the invert
  Real roughness = 0;          ///< r: shear strength of the interface over s_u, 0 (smooth) to 1 (rough)
  Real strength_gradient = 0;  ///< Pa/m: growth of s_u with depth
  Real unit_weight = 0;        ///< gamma', N/m3: weight of the submerged clay
};

/// w/D up to which clay_vertical_smooth is exact: (1 - cos 45 deg)/2 = 0.146. There the pipe touches the clay over a half-angle theta of 45 degrees; beyond it the
/// velocities of these slip lines would give work back, so that they prove no upper bound.
inline constexpr Real clay_slip_lines_exact_to = 0.14644660940672624;

/// The vertical resistance of a smooth pipe, N/m, upwards:
/// V = D s_u [(2 + pi - 2 theta) sin theta + 2 (1 - cos theta)], cos theta = 1 - 2 w/D. [slip lines: exact to w = 0.146 D, a lower bound beyond]
Formula clay_vertical_smooth(const PipeInClay& pipe);

/// The largest vertical resistance, N/m, upwards: V = D s_u 5.66 (w/D)^0.32 smooth, 7.40 (w/D)^0.40 rough, linear in the
/// roughness between. [fit: Merifield and others 2008]
Formula clay_vertical(const PipeInClay& pipe);

/// The largest horizontal resistance, N/m, against the motion: H = D s_u 2.72 (w/D)^0.78 smooth, 3.26 (w/D)^0.82 rough, linear
/// in the roughness between. [fit: Merifield and others 2008]
Formula clay_horizontal(const PipeInClay& pipe);

/// The horizontal resistance under a vertical load V, N/m: with v = V/V_max, H = H_max b v^b1 (1 - v)^b2, b1 = (0.8 - 0.15 r)(1.2 - w/D),
/// b2 = 0.35 (2.5 - w/D), b = (b1 + b2)^(b1 + b2) / (b1^b1 b2^b2). Zero at V = 0 and V_max, NaN beyond. [fit: Merifield and others 2008]
Formula clay_envelope(const PipeInClay& pipe, Real V, Real V_max, Real H_max);

/// The vertical resistance of a pipe pushed to its embedment, with heave, N/m, upwards: V = D s_u 5.3 (w/D)^0.25 smooth, 7.1
/// (w/D)^0.33 rough, linear in the roughness between. [recalled: Merifield and others 2009]
Formula clay_vertical_with_heave(const PipeInClay& pipe);

/// The resistance of a deeply buried pipe in any direction across it, N/m: with sin d = r,
/// P = D s_u [pi + 2 d + 4 cos((pi/2 - d)/2) (sqrt 2 + sin((pi/2 - d)/2))]; 6 + pi = 9.14 smooth, 4 sqrt 2 + 2 pi = 11.94 rough.
/// [exact: smooth and rough, Randolph and Houlsby 1984; recalled between]
Formula clay_deep(const PipeInClay& pipe);

/// Bounds of V/(D s_u) at w = D/2.
struct MurffBounds {
  Real lower, upper;
};
constexpr MurffBounds murff_smooth{4.0, 4.6}, murff_rough{5.6, 5.6};
constexpr Source murff_source{Label::recalled, "bounds of Murff, Wagner and Randolph 1989", "w/D = 0.5"};

// What a pipe meets that is swept over clay, once or many times; the strength is that of intact clay at the invert.

/// The residual horizontal resistance after a sweep of some diameters under a vertical load V, N/m: H = V (1 - 0.65 [1 - exp(-s_u/(2 gamma' D))]), s_u that at
/// the invert before it. [fit: White and Cheuk 2008]
Formula clay_residual(const PipeInClay& pipe, Real V);

/// Horizontal resistance in the middle of a sweep between berms, N/m: V times 0.25 (low; + 0.3 (w/D - 0.8) beyond 0.8 D) and 0.9 (high; + 1.5 (w/D - 0.7)
/// beyond 0.7 D). `best` is the mean of both. [fit: SAFEBUCK design guideline]
Estimates safebuck_mid_sweep(const PipeInClay& pipe, Real V);

/// Horizontal resistance against the berm at the end of a sweep of many, N/m: 0.9 (w/D) s_u D (low) and 4.5 (w/D)^0.4 s_u D (high). `best` is the mean of both.
/// [fit: SAFEBUCK design guideline]
Estimates safebuck_berm(const PipeInClay& pipe);

}  // namespace berm::formulas
