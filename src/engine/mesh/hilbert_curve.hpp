// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

#include <array>

namespace berm::mesh {

/// Coordinates along a side of the grid that hilbert_index numbers: 0 ... 2^curve_bits - 1.
constexpr int curve_bits = 20;

/// Index of a grid point along the Hilbert curve through a square or cube of 2^curve_bits points a side: points adjacent
/// along the curve are adjacent in the grid. Source: J. Skilling, Programming the Hilbert curve, AIP Conf. Proc. 707 (2004)
/// 381.
template <int dim>
std::uint64_t hilbert_index(std::array<std::uint32_t, dim> point);

}  // namespace berm::mesh
