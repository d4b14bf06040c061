// SPDX-License-Identifier: BSD-3-Clause
#include "material/principal_axes.hpp"

#include <Eigen/Eigenvalues>

namespace berm::material {

PrincipalAxes principal_axes(const SymTensor<3>& tensor)
{
  Matrix<3> matrix;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) matrix(i, j) = tensor[tensor_index(i, j)];
  const Eigen::SelfAdjointEigenSolver<Matrix<3>> solver(matrix);
  PrincipalAxes axes;
  for (int k = 0; k < 3; ++k) {
    axes.value[k] = solver.eigenvalues()[2 - k];  // ascending there
    for (int d = 0; d < 3; ++d) axes.direction[k][d] = solver.eigenvectors()(d, 2 - k);
  }
  return axes;
}

SymTensor<3> tensor_from(const Real (&value)[3], const Real (&direction)[3][3])
{
  SymTensor<3> a;
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < 3; ++i)
      for (int j = i; j < 3; ++j) a[tensor_index(i, j)] += value[k] * direction[k][i] * direction[k][j];
  return a;
}

}  // namespace berm::material
