// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record/run_record.hpp"
#include "structures/base/published_point.hpp"

namespace berm::report {

/// Draws the figures of all runs for print, those of their structures and those over time: SVG and PNG, into a folder that is made. Gives the names of what
/// was drawn.
std::vector<std::string> draw_report_figures(const std::vector<record::RunRecord>& runs, const base::PublishedPoints& published,
                                             const std::filesystem::path& folder);

}  // namespace berm::report
