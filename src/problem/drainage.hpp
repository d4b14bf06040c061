// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "problem/case.hpp"

namespace berm::problem {

/// How fast the soil of a body whose water flows consolidates.
struct Consolidation {
  std::string material;
  Real depth;    ///< m below the surface, where its stiffness is taken
  Real modulus;  ///< M, Pa: of one-dimensional compression of the skeleton, from the stress at the start
  Real c_v;      ///< m2/s, coefficient of consolidation
};

/// c_v = k / (gamma_w (1/M + n/K_w)) of each body whose water flows, at a depth below its surface, m.
std::vector<Consolidation> consolidation_of(const Case& c, Real depth);

/// A stage against the flow of the water, by the width D of the body, m.
struct StageDrainage {
  std::size_t stage;
  bool moves;   ///< whether a body is moved
  Real number;  ///< v D / c_v of a stage that moves a body; T = c_v t / D^2 of one that rests, NaN where the input does not say how long
};

// v D / c_v, c_v of soil that does not yield: to 5 % drained below the one and undrained above the other (examples/pipe_consolidation).
constexpr Real drained_up_to = 0.01, undrained_from = 30;

/// All stages but geostatic ones, load histories and sweeps.
std::vector<StageDrainage> drainage_of_stages(const Case& c, Real width, Real c_v);

}  // namespace berm::problem
