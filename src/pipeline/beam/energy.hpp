// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "beam/assembly.hpp"

namespace berm::beam {

/// 1/2 int m v^2 dx of the motion along the line (m of the wall and the content) and in the planes, J.
Real kinetic_energy(const Line& line, const State& state);

/// Of bending and of the membrane, sum of EI/2 int (v'' - v_0'')^2 dx and L N^2/(2 EA), J.
Real elastic_energy(const Line& line, const State& state);

/// Adds what a step does to the totals: from the state to the displacement of `work`, with the mean of each force over it. Heat does -int N dP_0 L/EA.
void add_work(const Line& line, const Loads& loads, const TimeTerms& terms, Real dt, const Work& work, State& state);

}  // namespace berm::beam
