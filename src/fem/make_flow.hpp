// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fem/fem_problem.hpp"

namespace berm::fem {

/// Gives the corners of elements whose water flows their unknowns, and finds where it leaves the soil: at sides of the boundary that are
/// neither at a rigid body that is not drained, nor on the axis, nor held across by a support that is not drained, and beside drained soil.
void make_flow(FemModel& model);

}  // namespace berm::fem
