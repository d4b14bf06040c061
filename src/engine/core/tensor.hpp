// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

namespace berm {

/// Independent components of a stress or strain: xx yy zz xy in plane strain, xx yy zz xy yz zx in space.
template <int dim>
constexpr int tensor_size = dim == 2 ? 4 : 6;

/// A symmetric tensor. Tension is positive. Shear components are tensor components (half the engineering shear strain).
/// T is Real for one particle, or a vector of numbers for several.
template <int dim, class T = Real>
struct SymTensor {
  T c[tensor_size<dim>] = {};

  T& operator[](int k) { return c[k]; }
  const T& operator[](int k) const { return c[k]; }
};

/// Component (i, j) of a SymTensor is c[tensor_index(i, j)].
constexpr int tensor_index(int i, int j)
{
  return i == j ? i : i + j == 1 ? 3 : i + j == 3 ? 4 : 5;
}

template <int dim, class T>
[[gnu::always_inline]] inline T trace(const SymTensor<dim, T>& a)
{
  return a[0] + a[1] + a[2];
}

/// a : b; shear components count twice.
template <int dim, class T>
[[gnu::always_inline]] inline T double_dot(const SymTensor<dim, T>& a, const SymTensor<dim, T>& b)
{
  T normal = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  for (int k = 3; k < tensor_size<dim>; ++k) normal += (a[k] + a[k]) * b[k];
  return normal;
}

/// Equivalent deviatoric strain sqrt(2/3 e : e) of a strain increment, e its deviator; never negative.
template <int dim>
inline Real equivalent_deviatoric_strain(SymTensor<dim> strain)
{
  const Real mean = trace(strain) * (1. / 3);
  for (int k = 0; k < 3; ++k) strain[k] -= mean;
  return std::sqrt(2. / 3 * double_dot(strain, strain));
}

}  // namespace berm
