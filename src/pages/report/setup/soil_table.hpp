// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record/run_record.hpp"

namespace berm::report {

/// Strength and stiffness over depth of the bodies whose soil varies: layers, regions, gradients and profiles, a row for each part over which they are linear;
/// runs of one soil together. "" where no soil varies. HTML.
std::string soil_over_depth(const std::vector<record::RunRecord>& runs);

}  // namespace berm::report
