// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "report/claims/claims.hpp"

namespace berm::report {

/// Draws V(w), H(u), w(u) and H/V of all runs over one another, and energies and contact of each run, as SVG and PNG. Gives the names of what was
/// drawn.
std::vector<std::string> draw_curves(const std::vector<pipe::RunRecord>& runs, const std::vector<PublishedPoint>& published,
                                     const std::filesystem::path& folder);

}  // namespace berm::report
