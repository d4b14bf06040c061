// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/lanes.hpp"

#include <type_traits>

namespace berm {

using TwoLanes = Real __attribute__((vector_size(2 * sizeof(Real))));
/// Two numbers anywhere in an array of Real, which such a vector may alias in GCC and Clang. To copy them by their bytes would make the compiler fetch all pointers
/// anew, since bytes may be anything.
using TwoReals = Real __attribute__((vector_size(2 * sizeof(Real)), aligned(alignof(Real))));

/// The components of a vector in the plane or in space as lanes: what is done to each of them is done at once. In space the last lane is zero.
template <int dim>
using Components = std::conditional_t<dim == 2, TwoLanes, Lanes>;

/// From `dim` numbers in memory.
template <int dim>
[[gnu::always_inline]] inline Components<dim> components(const Real* from)
{
  if constexpr (dim == 2) {
    return *reinterpret_cast<const TwoReals*>(from);
  } else {
    return Components<dim>{from[0], from[1], from[2], 0};
  }
}
template <int dim>
[[gnu::always_inline]] inline Components<dim> components(const Vec<dim>& vector)
{
  return components<dim>(vector.data());
}

/// Writes `dim` numbers.
template <int dim>
[[gnu::always_inline]] inline void store(const Components<dim>& components, Real* to)
{
  if constexpr (dim == 2)
    *reinterpret_cast<TwoReals*>(to) = components;
  else
    for (int d = 0; d < dim; ++d) to[d] = components[d];
}
template <int dim>
[[gnu::always_inline]] inline void store(const Components<dim>& components, Vec<dim>& to)
{
  store<dim>(components, to.data());
}
template <int dim>
[[gnu::always_inline]] inline Vec<dim> vector_of(const Components<dim>& components)
{
  Vec<dim> made;
  store<dim>(components, made);
  return made;
}

template <int dim>
[[gnu::always_inline]] inline Real sum_of_components(const Components<dim>& components)
{
  Real sum = components[0] + components[1];
  if constexpr (dim == 3) sum += components[2];
  return sum;
}

}  // namespace berm
