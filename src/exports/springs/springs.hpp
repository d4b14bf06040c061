// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/driven/driven_run.hpp"
#include "structures/driven/states.hpp"

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
  std::string stage;    ///< of the case
  std::string state;    ///< of the pipe's life in which the drag begins; "" where that is not known
  Real V = nan;         ///< N/m, mean vertical reaction meanwhile
  bool breaks = false;  ///< there is a first peak
  /// N/m, that peak; without one the largest H, but of a drag that ends against a berm its residual: NaN where it has none.
  Real peak = nan;
  std::array<Real, 4> mobilised = {nan, nan, nan, nan};  ///< m, where H first reaches these parts of the peak
  Real u_peak = nan;                                     ///< m
  Real largest = nan;                                    ///< N/m, largest H behind the first peak and above it; none against a berm
  Real u_largest = nan;                                  ///< m
  Real residual = nan;                                   ///< N/m, the plateau of H (driven::Resistance)
  Real berm = nan;                                       ///< N/m, resistance against the berm at the end of the drag
  Real end = nan;                                        ///< N/m, mean over the end of the drag, whether it stays or not
  Real u_residual = nan;  ///< m, of a drag that breaks out: from where H is as near to it as it must stay (driven::max_residual_change)
  Real travel = nan;      ///< m
  Points curve;           ///< H over u, freed from noise

  /// Whether H grows against a berm with neither a peak nor a residual: it has no spring.
  bool only_berm() const { return std::isnan(peak) && !std::isnan(berm); }
  /// On the way to the peak, the peak if it breaks out, the largest H behind it, the residual and the end of the drag, from the origin on: what a program gets. Empty
  /// without a peak.
  Points spring() const;
  /// N/m per m: secant to half of the peak, else to the first part of more that is known, else to the peak; no stiffness (is_stiffness) where H begins with it.
  Real stiffness() const;
};

/// A push that unloads or reloads the pipe, or that begins with the pipe in the bed.
struct Unloading {
  std::string stage;
  Real V_begin = nan, V_end = nan;  ///< N/m
  /// N/m of V per m of w, by the line fitted to w over V; not more than 0 where w moves against V, NaN where neither changes or they do not go together.
  Real stiffness = nan;
};

/// How the bed resists the pipe downwards.
struct Vertical {
  Points
      curve;  ///< virgin: V over the embedment in the push, at multiples of 0.05 D and at its end. None where the pipe lay in the bed from the start
  std::string without_curve;  ///< why there is none: it follows "no vertical spring: "
  Real preload = nan;         ///< N/m, the largest V that the bed has carried, up to the state
  std::vector<Unloading> unloading;
  Real rebound = nan;          ///< N/m2, V over w for small changes of V, by a formula with the elasticity of the soil at the invert
  std::string rebound_source;  ///< the formula
};

/// What a rest in which the clay consolidated did to the axial resistance: mu times the computed effective normal force.
struct SetUp {
  std::string stage;
  Real degree;         ///< U at its end
  Real before, after;  ///< N/m
};

/// Low, best and high.
struct Range {
  Real low = nan, best = nan, high = nan;
};

/// How the bed resists the pipe along its axis; nothing where V of the state is not positive. A run in the plane across the pipe cannot compute it: it is by formula,
/// but for the normal force on a pipe in soil with water. From its breakout it falls to the residual: of clay that is undrained the remoulded one.
struct Axial {
  Real wedging = nan;    ///< normal force around the contact divided by V
  Real drained = nan;    ///< N/m, at V of the state, with the friction of the interface
  Real undrained = nan;  ///< N/m, with its adhesion over the length of the contact
  Real settled = nan;    ///< N/m, the drained one once no excess pore pressure is left, where `drained` is of a computed normal force
  Real residual = nan;   ///< N/m: the undrained one over the sensitivity, else the drained one
  std::string wedging_source, drained_source, undrained_source, settled_source;  ///< the formula, or the quantity of the run
  std::string strength;  ///< what the undrained resistance is of: "undisturbed clay", "given adhesion"; "" without one
  Real sensitivity = 1;  ///< of that clay or its interface, the larger: undisturbed strength over that remoulded
  std::vector<SetUp> set_up;
  Range u_breakout, u_residual;  ///< m, displacements at which the two are mobilised: estimates of a formula; NaN without resistance

  /// N/m: the undrained resistance where it is known, else the drained one.
  Real breakout() const { return std::isnan(undrained) ? drained : undrained; }
  /// N/m, what it may be after many cycles: remoulded and undrained at least, without excess pore pressure at most.
  Range cyclic() const;
  /// Takes the displacements for a pipe of this diameter, m.
  void mobilise(Real diameter);
};

/// The work and clause that they are from.
std::string axial_displacement_source();

/// What the bed does to the pipe of a run, as it is in a state: what pushes and drags found before a fill or an excavation at the pipe is no spring of it. In the size of the prototype where the run is a centrifuge's.
struct Springs {
  std::string run;           ///< name of its folder
  std::string state;         ///< of the pipe (structures/driven/states.hpp)
  std::string state_origin;  ///< how that was found
  Real V = nan;              ///< N/m, in that state
  Real diameter = nan;       ///< m
  Real embedment = nan;      ///< m, in that state
  Real scale = 1;            ///< size of the prototype over that of the model
  Real weight = nan;         ///< N/m: gamma' D^2
  Real strength = nan;       ///< N/m: s_u D at that embedment, NaN where soil has friction
  std::vector<Lateral> lateral;
  Vertical vertical;
  Axial axial;
  std::vector<std::string> missing;  ///< lines: which springs these runs do not tell, and why
};

/// What a run in undrained strengths does not know of the clay at the pipe, for its axial resistance.
struct AxialClay {
  std::optional<Real> strength_ratio{};   ///< (s_u/sigma'_v)_nc: its resistance is that after consolidation
  Real exponent = 0, consolidation = 1;   ///< m of OCR^m; U
  std::optional<Real> interface_angle{};  ///< rad: drained, for after many cycles
};

/// Which springs of a run.
struct Selection {
  std::string state{};                 ///< "" = operation, else touchdown
  std::vector<std::string> travels{};  ///< drags; none: those that begin in that state, before the next one, and do not lay the pipe
  bool whole_life = false;             ///< without travels: the drags of all states, but those that lay the pipe
  AxialClay clay{};
};

/// Of a run of a pipe in the plane. Throws RunError where it is no such run, or has neither push nor drag, InputError where it has no such state or travel.
Springs springs_of(const record::RunRecord& run, const Selection& selection = {});

}  // namespace berm::springs
