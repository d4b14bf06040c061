// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/lateral/lateral_run.hpp"

namespace berm::lateral {

/// p-y curves of a run at four depths with those of design codes, as SVG for the page; "" without slices.
std::string code_curves(const LateralRun& run);

/// What design codes and published methods give beside the runs, as HTML with its heading: the load of a rigid pile at the same displacement of the point of load, the largest, and axial
/// resistance; "" where there is nothing.
std::string code_values(const LateralRuns& runs, const std::string& id);

}  // namespace berm::lateral
