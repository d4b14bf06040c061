// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/driven/results/results.hpp"

namespace berm::driven {

// Times are those of the load history, not of a run that is faster by `time_scale`.

/// The ways of a drag by force between the turns of the body: a turn counts where the body goes back by a hundredth of D (m).
std::vector<HalfCycle> half_cycles_of(const DragPath& drag, const run_folder::History& history, Real D);

/// How far it moves the body.
Displacements displacements_of(const DragPath& drag, const run_folder::History& history, Real D);

/// The half cycles of all drags of a run by a force that varies as CSV: stage, half cycle, begin_s, end_s, u_begin_m, u_end_m, w_end_m; "" where there are none.
std::string half_cycles_csv(const run_folder::History& history, const Stages& stages, Real D);

}  // namespace berm::driven
