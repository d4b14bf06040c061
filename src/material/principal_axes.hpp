// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/lane_parts.hpp"
#include "core/tensor.hpp"

#include <utility>

namespace berm::material {

/// Principal values in descending order; direction[k] is the unit eigenvector of value[k]. T is Real for one tensor, or a
/// vector of numbers for several.
template <class T>
struct PrincipalAxes {
  T value[3];
  T direction[3][3];
};

/// A symmetric tensor during diagonalization; axes[k] belongs to a[k][k].
template <class T>
struct TurningTensor {
  T a[3][3], axes[3][3];

  /// Rotates axes i and j so that a[i][j] vanishes, by the smaller of the two possible angles.
  template <int i, int j>
  [[gnu::always_inline]] void turn()
  {
    constexpr int k = 3 - i - j;
    const T one = T{} + 1.;
    const auto rotates = a[i][j] != T{};
    const T ratio = (a[j][j] - a[i][i]) / (2. * (rotates ? a[i][j] : one));
    const T size = one / (magnitude(ratio) + square_root(ratio * ratio + one));
    const T tangent = rotates ? (ratio < T{} ? -size : size) : T{};
    const T c = one / square_root(tangent * tangent + one), s = tangent * c;
    const T a_ki = a[k][i], a_kj = a[k][j], change = tangent * a[i][j];
    a[k][i] = a[i][k] = c * a_ki - s * a_kj;
    a[k][j] = a[j][k] = s * a_ki + c * a_kj;
    a[i][i] -= change;
    a[j][j] += change;
    a[i][j] = a[j][i] = T{};
    for (int d = 0; d < 3; ++d) {
      const T axis_i = axes[i][d], axis_j = axes[j][d];
      axes[i][d] = c * axis_i - s * axis_j;
      axes[j][d] = s * axis_i + c * axis_j;
    }
  }

  /// Moves the larger of the values i and j to position i.
  template <int i, int j>
  [[gnu::always_inline]] void order()
  {
    const auto swap = a[i][i] < a[j][j];
    const auto exchange = [&](T& first, T& second) {
      const T old = first;
      first = swap ? second : first;
      second = swap ? old : second;
    };
    exchange(a[i][i], a[j][j]);
    for (int d = 0; d < 3; ++d) exchange(axes[i][d], axes[j][d]);
  }
};

/// By Jacobi rotations (Golub and Van Loan, Matrix Computations, section 8.5): accurate for equal values, too; allocates
/// nothing.
template <class T>
[[gnu::always_inline]] inline PrincipalAxes<T> principal_axes(const SymTensor<3, T>& tensor)
{
  TurningTensor<T> t;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      t.a[i][j] = tensor[tensor_index(i, j)];
      t.axes[i][j] = T{} + (i == j ? 1. : 0.);
    }
  // Convergence is quadratic: rarely more than five sweeps.
  for (int sweep = 0; sweep < 12; ++sweep) {
    const T negligible = 1e-17 * (magnitude(t.a[0][0]) + magnitude(t.a[1][1]) + magnitude(t.a[2][2]));
    if (!any(magnitude(t.a[0][1]) + magnitude(t.a[1][2]) + magnitude(t.a[0][2]) > negligible)) break;
    t.template turn<0, 1>();
    t.template turn<0, 2>();
    t.template turn<1, 2>();
  }
  t.template order<0, 1>();
  t.template order<1, 2>();
  t.template order<0, 1>();
  PrincipalAxes<T> result;
  for (int k = 0; k < 3; ++k) {
    result.value[k] = t.a[k][k];
    for (int d = 0; d < 3; ++d) result.direction[k][d] = t.axes[k][d];
  }
  return result;
}

/// sum_k value[k] direction[k] direction[k]^T.
template <class T>
[[gnu::always_inline]] inline SymTensor<3, T> tensor_from(const T (&value)[3], const T (&direction)[3][3])
{
  SymTensor<3, T> a;
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < 3; ++i)
      for (int j = i; j < 3; ++j) a[tensor_index(i, j)] += value[k] * direction[k][i] * direction[k][j];
  return a;
}

}  // namespace berm::material
