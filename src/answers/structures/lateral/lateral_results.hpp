// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "run_folder/summary.hpp"
#include "structures/lateral/lateral_run.hpp"

namespace berm::lateral {

/// Where H is told, over D: of the displacement at the seabed.
constexpr Real told_at[] = {0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1};

/// "lateral_H_at_u_0.01D".
std::string name_at(Real over_D);

/// Key results, with u the displacement at the seabed:
///   lateral_H_at_u_{...}D, lateral_H_max (N) and u_at_lateral_H_max (m);
///   at the end lateral_H_end (N), lateral_M_end (N m, about the axis at the seabed), lateral_u_end, lateral_u_load_end (m, at the height of the load), lateral_tilt_end (rad),
///   lateral_height_end (m above the seabed, of the load) and lateral_pivot_end (m below the seabed, of the point of the axis that stayed);
///   lateral_H_end_over_DLsu in clay, L the length in the seabed and s_u the mean over it.
/// None where nothing loads the body sideways.
std::vector<run_folder::Quantity> lateral_quantities(const LateralRun& run);

/// Those at the end as a table of the page.
std::string lateral_table(const LateralRuns& runs, const std::string& id);

/// The names of all that a run may have of these.
std::vector<std::string> lateral_names();

}  // namespace berm::lateral
