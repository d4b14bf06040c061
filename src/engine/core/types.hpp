// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "os/numbers.hpp"

#include <Eigen/Core>
#include <cmath>

namespace berm {

template <int dim>
using Vec = Eigen::Matrix<Real, dim, 1, Eigen::DontAlign>;
template <int dim>
using Matrix = Eigen::Matrix<Real, dim, dim, Eigen::DontAlign>;

/// The normal acceleration of gravity, m/s2 (CGPM 1901).
constexpr Real standard_gravity = 9.80665;

}  // namespace berm
