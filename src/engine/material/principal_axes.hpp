// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/tensor.hpp"

namespace berm::material {

/// Principal values in descending order; direction[k] is the unit eigenvector of value[k].
struct PrincipalAxes {
  Real value[3];
  Real direction[3][3];
};

/// By iteration, for occasional use; laws use axis_and_circle.hpp.
PrincipalAxes principal_axes(const SymTensor<3>& tensor);

/// sum_k value[k] direction[k] direction[k]^T.
SymTensor<3> tensor_from(const Real (&value)[3], const Real (&direction)[3][3]);

}  // namespace berm::material
