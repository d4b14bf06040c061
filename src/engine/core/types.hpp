// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <limits>

namespace berm {

using Real = double;
using Index = std::int32_t;     ///< local: cells, nodes, blocks
using BigIndex = std::int64_t;  ///< global: particles times steps
constexpr Index none = -1;

template <int dim>
using Vec = Eigen::Matrix<Real, dim, 1, Eigen::DontAlign>;
template <int dim>
using Matrix = Eigen::Matrix<Real, dim, dim, Eigen::DontAlign>;

constexpr Real pi = 3.14159265358979323846;
constexpr Real degree = pi / 180;  ///< rad
constexpr Real infinity = std::numeric_limits<Real>::infinity();
constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();  ///< unknown, or not there

/// The normal acceleration of gravity, m/s2 (CGPM 1901).
constexpr Real standard_gravity = 9.80665;

}  // namespace berm
