// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record/run_record.hpp"
#include "run_folder/frame_reader.hpp"
#include "structures/base/chart.hpp"

#include <optional>

namespace berm::report {

/// The points along the free surface of the soil from its left to its right wall, with those in contact with the body; none where it does not reach from wall to wall.
std::vector<Index> ground_points(const run_folder::SavedSoil& soil);

/// The ground of a finite element run of large deformations at its start and at the ends of stages, over one another, near the path of the body; each outline is of a
/// row of the history. Of many stages some are left out, evenly. Empty for other runs, and where there are no frames that can be read.
std::optional<base::Chart> ground_chart(const record::RunRecord& run);

}  // namespace berm::report
