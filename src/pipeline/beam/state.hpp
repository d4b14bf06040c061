// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "beam/line.hpp"
#include "core/archive.hpp"

namespace berm::beam {

/// Work and energy since the start, J. The change of kinetic and elastic energy is work of loads and of heat less what springs and damping took (energy.hpp).
struct Totals {
  Real work_of_loads = 0;
  Real work_of_heat = 0;     ///< of the constrained force: of temperature and pressure
  Real work_on_springs = 0;  ///< stored in them or dissipated
  Real damped = 0;
};

/// All that changes during a run.
struct State {
  Real time = 0;                                           ///< s
  std::vector<Real> displacement, velocity, acceleration;  ///< by freedom, m or rad, and by s; displacement counts from the straight line
  std::vector<Real> force;                                 ///< by freedom, N or N m, of the loads of the last step
  std::vector<Real> constrained_force;                     ///< P_0 by element, N
  std::vector<SpringState> springs;
  std::vector<Real> spring_factor;  ///< by spring: its force and stiffness over those of its law; 1 but where the caller changes it
  std::vector<berm_macro_element_state> macro_elements;
  std::vector<Real> mean_axial,
      mean_lateral;  ///< by node: the direction in which it goes, a mean that fades over the way that mobilises its friction
  std::vector<std::uint8_t> sideways;  ///< by node: it slides sideways, and has no plastic springs along the line
  Totals totals;
};

/// A line at rest in its shape.
State state_of(const Line& line);

/// The whole state, bit for bit; reading puts it into one of the same line.
void archive(Archive& k, State& state);

}  // namespace berm::beam
