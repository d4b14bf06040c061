// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record/run_record.hpp"
#include "structures/driven/results.hpp"

namespace berm::driven {

// Times are those of the load history, not of a run that is faster by `time_scale`.

/// The ways of a drag by force between the turns of the body: a turn counts where the body goes back by a hundredth of D (m).
std::vector<HalfCycle> half_cycles_of(const DragPath& drag, const run_folder::History& history, Real D);

/// How far it moves the body.
Displacements displacements_of(const DragPath& drag, const run_folder::History& history, Real D);

/// Of D, in a half cycle: a body that a force moves farther breaks out. Of the largest H: where the mass of the body takes more, its inertia matters.
constexpr Real breaks_out = 0.1, inertia_matters = 0.1;

/// Whether how far a force moves a body of this mass, kg/m, depends on the time that its waves take: in a half cycle it breaks out, or its inertia matters,
///
///   m a = m (s/2) (pi/T)^2
///
/// with the displacement s of the half cycle and its time T in the run.
bool is_accelerated(const DragPath& drag, const run_folder::History& history, Real D, Real mass);

/// Of each drag by a force that varies, how its record was run; and of those that ran faster than their record with a body that is accelerated (is_accelerated), that
/// the displacement is a lower estimate. In sentences without a stop; without a history only the first.
std::vector<std::string> time_scale_lines(const record::RunRecord& run);
std::vector<std::string> lower_estimates(const record::RunRecord& run);

/// The half cycles of all drags of a run by a force that varies as CSV: stage, half cycle, begin_s, end_s, u_begin_m, u_end_m, w_end_m; "" where there are none.
std::string half_cycles_csv(const run_folder::History& history, const Stages& stages, Real D);

}  // namespace berm::driven
