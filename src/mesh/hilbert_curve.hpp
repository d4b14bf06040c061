// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

#include <array>

namespace berm::mesh {

/// Coordinates along a side of the grid that hilbert_place numbers: 0 ... 2^curve_bits - 1.
constexpr int curve_bits = 20;

/// Place of a grid point along the Hilbert curve through a square or cube of 2^curve_bits points a side: points next to each other along the
/// curve are next to each other in the grid. Source: J. Skilling, Programming the Hilbert curve, AIP Conf. Proc. 707 (2004) 381.
template <int dim>
std::uint64_t hilbert_place(std::array<std::uint32_t, dim> point);

}  // namespace berm::mesh
