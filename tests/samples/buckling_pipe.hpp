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

/// Hobbs' solution (1984) of a buckle of one of his modes 1 to 4, for a compression P in it.
struct HobbsBuckle {
  Real length, half_length;  ///< m, of a wave; from the middle to the end of the last one
  Real amplitude, moment;    ///< m, N m
  Real constrained_force;    ///< N, P_0 far from it
};
inline HobbsBuckle hobbs_buckle(int mode, const HotPipe& pipe, Real P)
{
  constexpr Real k[4][5] = {{80.76, 6.391e-5, 0.5, 2.407e-3, 0.06938},
                            {39.478, 1.743e-4, 1, 5.532e-3, 0.1088},
                            {34.06, 1.668e-4, 1.294, 1.032e-2, 0.1434},
                            {28.20, 2.144e-4, 1.608, 1.047e-2, 0.1483}};
  const Real* const c = k[mode - 1];
  const Real w = pipe.resistance(), L = std::sqrt(c[0] * pipe.EI / P);
  const Real feed = std::sqrt(1 + c[1] * pipe.EA * w * std::pow(L, 5) / (pipe.EI * pipe.EI)) - 1;
  return {L, c[2] * L, c[3] * w * std::pow(L, 4) / pipe.EI, c[4] * w * L * L, P + c[2] * w * L * feed};
}

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
