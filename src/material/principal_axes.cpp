// SPDX-License-Identifier: BSD-3-Clause
#include "material/principal_axes.hpp"

#include <utility>

namespace berm {

namespace {

/// Turns axes i and j so that a(i, j) vanishes, by the smaller of the two angles that do it.
void rotate(Matrix<3>& a, Matrix<3>& axes, int i, int j)
{
  if (a(i, j) == 0) return;
  const Real ratio = (a(j, j) - a(i, i)) / (2 * a(i, j));
  const Real tangent = (ratio < 0 ? -1 : 1) / (std::abs(ratio) + std::sqrt(ratio * ratio + 1));
  const Real c = 1 / std::sqrt(tangent * tangent + 1), s = tangent * c;
  const int k = 3 - i - j;
  const Real a_ki = a(k, i), a_kj = a(k, j), change = tangent * a(i, j);
  a(k, i) = a(i, k) = c * a_ki - s * a_kj;
  a(k, j) = a(j, k) = s * a_ki + c * a_kj;
  a(i, i) -= change;
  a(j, j) += change;
  a(i, j) = a(j, i) = 0;
  const Vec<3> axis_i = axes.col(i), axis_j = axes.col(j);
  axes.col(i) = c * axis_i - s * axis_j;
  axes.col(j) = s * axis_i + c * axis_j;
}

}  // namespace

PrincipalAxes principal_axes(const SymTensor<3>& tensor)
{
  Matrix<3> a, axes = Matrix<3>::Identity();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) a(i, j) = tensor[tensor_place(i, j)];
  // Convergence is quadratic: rarely more than five sweeps.
  for (int sweep = 0; sweep < 12 && (a(0, 1) != 0 || a(1, 2) != 0 || a(0, 2) != 0); ++sweep) {
    const Real negligible = 1e-17 * (std::abs(a(0, 0)) + std::abs(a(1, 1)) + std::abs(a(2, 2)));
    if (std::abs(a(0, 1)) + std::abs(a(1, 2)) + std::abs(a(0, 2)) <= negligible) break;
    rotate(a, axes, 0, 1);
    rotate(a, axes, 0, 2);
    rotate(a, axes, 1, 2);
  }
  std::array<int, 3> order = {0, 1, 2};
  const auto put_larger_first = [&](int i, int j) {
    if (a(order[i], order[i]) < a(order[j], order[j])) std::swap(order[i], order[j]);
  };
  put_larger_first(0, 1);
  put_larger_first(1, 2);
  put_larger_first(0, 1);
  PrincipalAxes result;
  for (int k = 0; k < 3; ++k) {
    result.value[k] = a(order[k], order[k]);
    result.direction[k] = axes.col(order[k]);
  }
  return result;
}

SymTensor<3> tensor_from(const std::array<Real, 3>& value, const std::array<Vec<3>, 3>& direction)
{
  SymTensor<3> a;
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < 3; ++i)
      for (int j = i; j < 3; ++j) a[tensor_place(i, j)] += value[k] * direction[k][i] * direction[k][j];
  return a;
}

}  // namespace berm
