// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "report/run_record.hpp"

#include <nlohmann/json.hpp>

// M. Maglia, N. M. Pinyol and C. Hoffman: Material Point Method modelling of offshore unburied cable/pipe interacting with soil.

namespace berm {

/// Whether a run has the pipe and the sand of the paper's centrifuge test: D = 20 mm at 50 g, phi = 35 deg without cohesion, E = 7 MPa, nu = 0.25, friction
/// of the interface 2/3 phi.
bool is_of_paper(const RunRecord& run);

/// What the paper states, for the page's charts: PaperPoint of web/src/data.ts. Empty unless a run is of the paper.
nlohmann::ordered_json paper_points(const std::vector<RunRecord>& runs);

}  // namespace berm
