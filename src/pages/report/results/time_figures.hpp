// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record/run_record.hpp"

namespace berm::report {

/// Draws energies and contact of each run over time, as SVG and PNG. Gives the names of what was drawn.
std::vector<std::string> draw_time_charts(const std::vector<record::RunRecord>& runs, const std::filesystem::path& folder);

}  // namespace berm::report
