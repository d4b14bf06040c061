// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "run_folder/run_folder.hpp"
#include "structures/base/structure.hpp"

namespace berm::line {

/// P, y and M of a run over the rise of temperature; of a line that is not heated over that of pressure, of one that is neither over time. None where the line has not been
/// loaded.
base::Charts load_charts(const record::RunRecord& run);

/// curves.png of a run. False, with a warning, where it could not be drawn.
bool draw_load_curves(const run_folder::RunFolder& folder, const record::RunRecord& run);

/// pipeline_P, pipeline_y, pipeline_M of all runs over one another, as SVG and PNG. Gives their names.
std::vector<std::string> draw_load_figures(const base::Runs& runs, const std::filesystem::path& folder);

}  // namespace berm::line
