// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "formulas/formula.hpp"
#include "settings/case.hpp"
#include "structures/base/published_envelope.hpp"
#include "structures/driven/driven_run.hpp"

namespace berm::pipe {

/// A value of a run beside what a formula gives.
struct Comparison {
  enum class Unit {
    force,  ///< N/m
    length  ///< m
  };
  std::string quantity;  ///< a symbol or some words
  Unit unit;
  Real berm;  ///< NaN: the run has no such value
  formulas::Formula published;
  std::string about;  ///< what the source's name leaves out, such as "wished in place"

  /// berm over formula; NaN where one of them is missing.
  Real ratio() const { return published.value == 0 ? nan : berm / published.value; }
};

/// The low, best and high estimate of a formula, in the words of design codes.
std::vector<Comparison> with_estimates(const char* quantity, Comparison::Unit unit, Real berm, const formulas::Estimates& estimates,
                                       const std::string& about);

/// Horizontal displacements (m; NaN where there is none) of a drag that begins at embedment w (m): at breakout, and from which H is residual.
std::vector<Comparison> displacement_at_breakout(Real diameter, Real w, Real u);
std::vector<Comparison> displacement_to_the_residual(Real diameter, Real u);

/// Comparisons for one state of a run.
struct ComparedState {
  /// peak: H at breakout, at the onset of sliding in a drag without one, or the largest where the drag is too short to tell that; breakout: how far the pipe goes until
  /// then, from where the drag begins; end_of_drag: of a drag of a diameter or more; uplift: the largest resistance against a lift, u the travel upwards and w where it began.
  enum class Kind { push, end_of_push, drag, peak, breakout, end_of_drag, uplift };
  Kind kind;
  Real u, w, V;  ///< m, m, N/m, as the run found them and the formulas take them; NaN where they do not matter
  std::vector<Comparison> comparisons;
  enum class Point { peak, onset, largest } point = Point::peak;  ///< of a peak: what H is, of an uplift whether it falls after it
  std::string stage{};                                            ///< of the end of a drag: its name
  Real strength = nan;                                            ///< Pa, s_u of intact clay at the invert
  Real w_begin = nan;  ///< m, of the end of a drag: where it began, which formulas of the residual take
};

/// What design codes and published formulas give for the soil, the pipe and the states of a run.
struct PublishedValues {
  std::vector<ComparedState> states;
  std::vector<std::string> remarks;  ///< what to know before they are compared, text
};

/// Which formulas apply to a run, and what they give: at w = 0.1, 0.25, 0.5, 0.75, 1 D and the end of a push; of the first drag at breakout, which is what
/// the formulas of design codes are for, at the onset of sliding, or where H is largest; of a drag in clay at u = 0.1, 0.3, 0.5, 1 D; of each drag of a diameter or more its residual, or its H against a berm; of each lift that the soil resists. The
/// embedment is that of the run there; in the finite element method, whose strains are small, that at the start. Forces of half a pipe beside an axis of
/// symmetry are doubled.
PublishedValues published_beside(const driven::DrivenRun& run);

/// The pipe that the case drives. Throws InputError where the case is not plane, drives no circle, or the pipe lies above the bed or beyond the walls.
base::EmbeddedBody embedded_pipe(const settings::Case& c);

/// For clay (Mohr-Coulomb without friction) the fits for a pipe wished in place, the buoyancy gamma' A of the clay that it takes the place of added
/// to V. For sand (without cohesion) the tabulated V_max, and a parabola (YieldSurface) fitted to the probes' ends with their own V_max. Formulas
/// that are only recalled are not among them.
base::PublishedEnvelope pipe_envelope(const settings::Case& c, const base::EnvelopeEnds& ends);

}  // namespace berm::pipe
