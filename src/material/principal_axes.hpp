// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/tensor.hpp"

#include <array>

namespace berm {

/// Principal values in descending order; direction[k] is the unit vector of value[k].
struct PrincipalAxes {
  std::array<Real, 3> value;
  std::array<Vec<3>, 3> direction;
};

/// By Jacobi's rotations (Golub and Van Loan, Matrix Computations, section 8.5): as exact for equal values as for distinct ones, and no memory taken.
PrincipalAxes principal_axes(const SymTensor<3>& a);

/// sum_k value[k] direction[k] direction[k]^T.
SymTensor<3> tensor_from(const std::array<Real, 3>& value, const std::array<Vec<3>, 3>& direction);

}  // namespace berm
