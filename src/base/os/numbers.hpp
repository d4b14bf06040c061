// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>

namespace berm {

using Real = double;
using Index = std::int32_t;     ///< local: cells, nodes, blocks
using BigIndex = std::int64_t;  ///< global: particles times steps
constexpr Index none = -1;

constexpr Real pi = 3.14159265358979323846;
constexpr Real degree = pi / 180;  ///< rad
constexpr Real infinity = std::numeric_limits<Real>::infinity();
constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();  ///< unknown, or not there

}  // namespace berm
