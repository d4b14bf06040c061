// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "formulas/formula.hpp"

#include <span>

namespace berm::formulas {

/// A pipe in drained sand without cohesion.
struct PipeInSand {
  Real diameter;             ///< D, m
  Real embedment;            ///< w, m: depth of the invert below the surface
  Real unit_weight;          ///< gamma', N/m3: weight of the submerged sand
  Real friction_angle;       ///< phi, rad
  Real interface_angle = 0;  ///< delta, rad: friction angle of the surface of the pipe
};

/// The vertical resistance of a pipe wished in place below a flat surface, associated flow, N/m, upwards. A table of V/(gamma' D^2) over w/D for
/// phi = 35 deg and delta = 0 or 2/3 phi, between and beyond its entries a power of w/D; NaN for other angles (by more than 0.02 deg).
/// [exact at the entries: characteristics, 0.1 %]
Formula sand_vertical(const PipeInSand& pipe);

/// The embedment under a vertical load V (N/m), m: w = 0.037 D (V/(gamma' D^2))^(2/3); the pipe's own embedment is not used.
/// [fit: Verley and Sotberg 1994, DNV-RP-F109]
Formula sand_embedment(const PipeInSand& pipe, Real V);

/// The yield surface H = mu (V/V_max + beta) (V_max - V).
struct YieldSurface {
  Real mu, beta;  ///< 1
};

/// The horizontal resistance under a vertical load V on that surface, N/m; zero at V = V_max. [recalled: Zhang and others 1999, 2002]
Formula zhang_envelope(const YieldSurface& surface, Real V, Real V_max);

/// The surface nearest to points (V, H), N/m, in the least squares of H, for a known V_max; NaN unless two of the points
/// have different V below V_max.
YieldSurface fit_zhang(std::span<const Real> V, std::span<const Real> H, Real V_max);

// Lateral resistance by DNV-RP-F109, on-bottom stability; the embedment is sand_embedment.

/// The largest horizontal resistance in sand under a vertical load V, N/m, against the motion: with k = gamma' D^2/V
/// H = 0.6 V + V (5 k - 0.15 k^2) (w/D)^1.25 for k <= 20, else 0.6 V + V 2 k (w/D)^1.25. [fit: DNV-RP-F109]
Formula f109_sand_lateral(const PipeInSand& pipe, Real V);

}  // namespace berm::formulas
