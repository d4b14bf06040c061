// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "beam/line.hpp"

namespace berm::beam {

/// What acts on the line at the end of a step. The force of a freedom is F - C (v - v_then): C makes a reaction that comes from the step before, such as that of soil computed apart, follow
/// the velocity.
struct Loads {
  std::vector<Real> force;              ///< F, by freedom, N; of slopes N m
  std::vector<Real> impedance;          ///< C, by freedom, N s/m
  std::vector<Real> velocity_then;      ///< by freedom, m/s, for which F was found
  std::vector<Real> constrained_force;  ///< P_0 by element, N (pipe_section.hpp)
};

/// None, for a line.
Loads no_loads(const Line& line);

/// Adds a load per metre (N/m) that is constant in an element.
void add_load(const Line& line, Plane plane, Index element, Real per_metre, Loads& loads);

/// Adds the submerged weight of all elements.
void add_weight(const Line& line, Loads& loads);

}  // namespace berm::beam
