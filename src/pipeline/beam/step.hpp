// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "beam/assembly.hpp"

namespace berm::beam {

/// How the iteration of a step ended.
struct StepEnd {
  int iterations = 0;
  Real unbalance = 0;  ///< N, largest force out of balance; moments over the length of their elements
};

/// One step of time, dt (s), under loads that act at its end: Newmark's
///
///   d = d_t + dt v_t + dt^2 ((1/2 - beta) a_t + beta a),  v = v_t + dt ((1 - gamma) a_t + gamma a),  gamma = 0.55, beta = (gamma + 1/2)^2/4,
///
/// stable at any dt, with Newton's iteration. gamma above 1/2 takes from motion of the angular frequency omega the part (gamma - 1/2) omega dt/2 of critical damping: from waves that the step does not
/// resolve nearly all, from a buckle nothing. Throws NoEquilibrium.
StepEnd step(const Line& line, const Loads& loads, Real dt, State& state, Work& work);

/// Equilibrium under these loads, without inertia: the line is at rest then. Throws NoEquilibrium.
StepEnd find_equilibrium(const Line& line, const Loads& loads, State& state, Work& work);

/// How many natural modes of the line at this state, its springs as stiff as they are there, have an angular frequency below this (rad/s). At 0: how many ways to buckle there are.
Index modes_below(const Line& line, const State& state, Real angular_frequency, Work& work);

}  // namespace berm::beam
