// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/base/structure.hpp"
#include "structures/depth/profile.hpp"

namespace berm::depth {

/// depth_profile.csv: body, stage, z_top_m, z_bottom_m, H (empty around an axis) and V per metre of depth, axial force at the top and at the bottom; a row a slice.
/// "" without slices.
std::string profile_csv(const record::RunRecord& run);

/// tz.csv: body, stage, z_m, w_m and t; a row a point. "" without curves.
std::string tz_csv(const record::RunRecord& run);

/// Writes both into the run's folder, where they have rows.
void write_files(const run_folder::RunFolder& folder, const record::RunRecord& run);

/// How the soil pulls on bodies along their depth at the end of the last stage: sentence, picture (SVG) and table of each, HTML; "" without slices. `id` begins
/// the names of the tables.
std::string profile_section(const record::RunRecord& run, const std::string& id);

/// The same of any structure, with a picture for a run after the other.
base::Reading reading();

}  // namespace berm::depth
