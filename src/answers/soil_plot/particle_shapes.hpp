// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "run_folder/frame.hpp"

namespace berm::soil_plot {

/// What a circle of radius 1 around each of these particles has become by the deformation that its `displacement` shows, at the same area: x = A c for |c| = 1.
///
/// F = (sum_n dx_n dX_n^T + r I) (sum_n dX_n dX_n^T + r I)^-1 over neighbours n that were within 1.8 sqrt(volume) and have not been torn off, dX and dx the way to them
/// then and now, r a tenth of the volume, so that a particle without neighbours keeps its circle; A A^T = F F^T / det F. The longer axis is 2.5 at most.
std::vector<Matrix<2>> particle_shapes(const run_folder::Frame<2>& frame, const std::vector<Index>& points);

}  // namespace berm::soil_plot
