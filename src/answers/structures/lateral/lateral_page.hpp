// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "run_folder/run_folder.hpp"
#include "structures/lateral/lateral_run.hpp"

namespace berm::lateral {

/// What a run met that is loaded sideways, in some sentences, HTML; "" where it is not.
std::string lateral_words(const LateralRun& run);

/// The key results of the runs that are loaded sideways as HTML tables, whose names begin with `id`; "" where there is none.
std::string lateral_key_results(const LateralRuns& runs, const std::string& id);

/// curves.png: H over u at the seabed and at the load, and M over the tilt. False, with a warning, where it could not be drawn.
bool draw_lateral_curves(const run_folder::RunFolder& folder, const LateralRun& run);

/// The same of all runs over one another, as SVG and PNG in two pictures. Gives their names.
std::vector<std::string> draw_lateral_figures(const LateralRuns& runs, const std::string& name, const std::filesystem::path& folder);

}  // namespace berm::lateral
