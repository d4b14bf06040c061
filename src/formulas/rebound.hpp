// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "formulas/formula.hpp"

// How a pipe that was pressed into the seabed comes back when it is unloaded.

namespace berm::formulas {

/// Slope of the vertical reaction over the embedment for small changes of load, N/m2: 0.88 G/(1 - nu). [fit: DNV Guideline 14, as dynamic stiffness]
Formula pipe_rebound_stiffness(Real shear_modulus, Real poisson_ratio);

}  // namespace berm::formulas
