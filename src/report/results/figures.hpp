// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "report/claims/claims.hpp"

namespace berm::report {

/// Draws the curves of all runs and the mechanism of each, for print: SVG and PNG, into a folder that is made. Gives the names of what was drawn.
std::vector<std::string> draw_report_figures(const std::vector<pipe::RunRecord>& runs, const std::vector<PublishedPoint>& published,
                                             const std::filesystem::path& folder);

}  // namespace berm::report
