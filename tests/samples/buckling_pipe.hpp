// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "beam/answers.hpp"
#include "beam/step.hpp"

#include <algorithm>
#include <cmath>

namespace berm::test {

/// A 16 inch pipe on a plane with friction, by its stiffness and weight.
struct HotPipe {
  Real EI = 69.4e6, EA = 3.74e9, mass = 330, weight = 1500;  ///< N m2, N, kg/m, N/m
  Real friction = 0.6;
  Real mobilisation = 1e-3;  ///< m

  Real resistance() const { return friction * weight; }
  beam::Section section() const { return {EI, EA, mass, mass, weight, 0.2}; }
};

/// A line with a stress-free wave in the plane: one bump at x = 0, or with `antisymmetric` one to each side; half of it is there. The other end is anchored.
inline beam::Line bent_line(const HotPipe& pipe, bool antisymmetric, Real amplitude, Real wave, std::vector<Real> nodes)
{
  beam::Line line = beam::straight_line(std::move(nodes), pipe.section(), {beam::Plane::lateral});
  const Real l = wave, y0 = amplitude;
  if (antisymmetric)
    beam::set_shape(
        line, beam::Plane::lateral, [=](Real x) { return x < l ? y0 / 1.3 * std::sin(pi * x / l) * (1 + std::cos(pi * x / l)) : 0; },
        [=](Real x) { return x < l ? y0 / 1.3 * pi / l * (std::cos(pi * x / l) + std::cos(2 * pi * x / l)) : 0; });
  else
    beam::set_shape(
        line, beam::Plane::lateral, [=](Real x) { return x < l / 2 ? y0 / 2 * (1 + std::cos(2 * pi * x / l)) : 0; },
        [=](Real x) { return x < l / 2 ? -y0 * pi / l * std::sin(2 * pi * x / l) : 0; });
  beam::hold(line, 0, antisymmetric ? beam::EndCondition::antisymmetric : beam::EndCondition::symmetric);
  beam::hold(line, line.nodes() - 1, beam::EndCondition::clamped);
  return line;
}

/// Largest displacement sideways and moment of a line, m and N m.
struct Crown {
  Real amplitude = 0, moment = 0;
};
inline Crown crown_of(const beam::Line& line, const beam::State& state)
{
  Crown crown;
  for (Index i = 0; i < line.nodes(); ++i) {
    crown.amplitude = std::max(crown.amplitude, std::abs(state.displacement[line.across(beam::Plane::lateral, i)]));
    crown.moment = std::max(crown.moment, std::abs(moment(line, state, beam::Plane::lateral, i)));
  }
  return crown;
}

}  // namespace berm::test
