// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/pipe/results/pipe_run.hpp"

#include <array>

namespace berm::springs {

/// A point of a spring: displacement and resistance per length of pipe.
struct Point {
  Real x, F;  ///< m, N/m
};
using Points = std::vector<Point>;

/// Parts of the peak at which a spring has points on the way to it.
constexpr std::array<Real, 4> mobilised_parts = {0.25, 0.5, 0.75, 0.95};

/// How the bed resists the pipe sideways: one drag. Numbers that are not known are NaN.
struct Lateral {
  std::string stage;                                     ///< of the case
  Real V = nan;                                          ///< N/m, mean vertical reaction meanwhile
  bool breaks = false;                                   ///< there is a first peak; else the peak is the largest H
  Real peak = nan;                                       ///< N/m
  std::array<Real, 4> mobilised = {nan, nan, nan, nan};  ///< m, where H first reaches these parts of the peak
  Real u_peak = nan;                                     ///< m
  Real residual = nan;                                   ///< N/m, that stays at the end of the drag
  Real berm = nan;                                       ///< N/m, met against a berm at the end of a sweep: never the residual
  Real end = nan;                                        ///< N/m, mean over the end of the drag, whether it stays or not
  Real u_residual = nan;  ///< m, of a drag that breaks out: from where H is as near to it as it must stay (pipe::max_residual_change)
  Real travel = nan;      ///< m
  Points curve;           ///< H over u, freed from noise

  /// On the way to the peak, the peak if it breaks out, the residual and the end of the drag, from the origin on: what a program gets.
  Points spring() const;
  /// N/m per m: secant to half of the peak.
  Real stiffness() const { return peak / 2 / mobilised[1]; }
};

/// A push that unloads, reloads or lifts the pipe, or that begins with the pipe in the bed: the secant of its stage.
struct Unloading {
  std::string stage;
  Real V_begin = nan, V_end = nan;  ///< N/m
  Real stiffness = nan;             ///< N/m of V per m of w
};

/// How the bed resists the pipe downwards.
struct Vertical {
  Points
      curve;  ///< V over the embedment, at multiples of 0.05 D and at the end of the push; none where the pipe lay in the bed from the start
  std::vector<Unloading> unloading;
};

/// How the bed resists the pipe along its axis, by formula: a run in the plane across the pipe cannot compute it.
struct Axial {
  Real wedging = nan;    ///< pressure around the contact over V (formulas/axial.hpp)
  Real drained = nan;    ///< N/m, at V of the first drag, with the friction of the interface
  Real undrained = nan;  ///< N/m, with its adhesion over the length of the contact
  Real breakout_low = nan, breakout = nan,
       breakout_high = nan;  ///< m, displacement at which it is mobilised: estimates of a formula; NaN without resistance
  std::string drained_source, undrained_source;  ///< formula with its citation, or "axial_friction_of_rest: computed with water"

  /// Takes these displacements for a pipe of this diameter, m.
  void mobilise(Real diameter);
};

/// The work and clause that they are from.
std::string axial_breakout_source();

/// What the bed does to the pipe of a run, in the size of the prototype where the run is a centrifuge's.
struct Springs {
  std::string run;           ///< name of the run folder
  std::string state;         ///< its name, as "operation"
  std::string state_origin;  ///< how it was found, as "end of stage unload"
  Real V = nan;              ///< N/m, vertical force in that state
  Real diameter = nan;       ///< m
  Real embedment = nan;      ///< m, at the end of the push
  Real scale = 1;            ///< size of the prototype over that of the model
  Real weight = nan;         ///< N/m: gamma' D^2
  Real strength = nan;       ///< N/m: s_u D, NaN where soil has friction
  std::vector<Lateral> lateral;
  Vertical vertical;
  Axial axial;
};

/// Of a run of a pipe in the plane. Throws RunError where it is no such run, or has neither push nor drag.
Springs springs_of(const record::RunRecord& run);

}  // namespace berm::springs
