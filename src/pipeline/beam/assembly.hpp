// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "beam/band_matrix.hpp"
#include "beam/hermite.hpp"
#include "beam/loads.hpp"
#include "beam/state.hpp"
#include "os/error.hpp"

namespace berm::beam {

/// The line finds no equilibrium; the state is as it was before, and a smaller step may find one.
struct NoEquilibrium : RunError {
  using RunError::RunError;
};

/// How acceleration and velocity follow from a displacement d in the step: a = acceleration (d - d~), v = v~ + velocity (d - d~), with the predictions of Work. Both are zero without inertia.
struct TimeTerms {
  Real acceleration = 0;  ///< 1/s2
  Real velocity = 0;      ///< 1/s
};

/// Memory of the steps of a line; none of it is part of the state.
struct Work {
  explicit Work(const Line& line);

  std::vector<Real> displacement;                   ///< looked for, by freedom
  std::vector<Real> predicted, predicted_velocity;  ///< d~, v~
  std::vector<Real>
      residual;  ///< force out of balance, by freedom, N or N m; within an iteration the change of displacement that takes it away
  std::vector<Real> unit;  ///< by freedom, m: what makes a moment a force; 1 of forces
  BandMatrix tangent;      ///< its derivative; of macro-elements, whose own is not symmetric, the symmetric part
  std::vector<berm_macro_element_state> macro_elements;  ///< at that displacement
  Real largest_force = 0;                                ///< N, of those that are in balance
};

/// The membrane of an element.
struct ElementNow {
  Real length, strain, force;  ///< m; von Karman's; N, tension positive
};

/// At a displacement of all freedoms:
///
///   epsilon = (u_b - u_a)/L + 1/(2L) sum over planes of int v'^2 - v_0'^2 dx,   N = EA epsilon - P_0.
ElementNow membrane(const Line& line, Index element, const std::vector<Real>& displacement, Real constrained_force);

/// Residual and tangent at the displacement of `work`, of springs and macro-elements from their last accepted state on. Throws NoEquilibrium where a macro-element cannot follow.
void assemble(const Line& line, const State& state, const Loads& loads, const TimeTerms& terms, Work& work);

/// Whether a spring acts: those along the line that are plastic do not where it slides sideways.
inline bool acts(const Line& line, const State& state, const Spring& spring)
{
  return state.sideways[spring.node] == 0 || spring.freedom != line.axial(spring.node) ||
         !std::holds_alternative<PlasticSpring>(line.laws[spring.law]);
}

}  // namespace berm::beam
