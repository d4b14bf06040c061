// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

namespace berm {

/// A number with its partial derivatives with respect to up to four unknowns (forward automatic differentiation).
/// Comparisons use the value alone, so that a law written for a type T gives, with T = Dual, the derivative of the branch
/// taken.
struct Dual {
  using Slope = Real __attribute__((vector_size(4 * sizeof(Real))));

  Real value = 0;
  Slope slope = {};  ///< d value / d unknown
};

[[gnu::always_inline]] inline Dual operator-(const Dual& a)
{
  return {-a.value, -a.slope};
}

[[gnu::always_inline]] inline Dual operator+(const Dual& a, const Dual& b)
{
  return {a.value + b.value, a.slope + b.slope};
}
[[gnu::always_inline]] inline Dual operator+(const Dual& a, Real b)
{
  return {a.value + b, a.slope};
}
[[gnu::always_inline]] inline Dual operator+(Real a, const Dual& b)
{
  return b + a;
}

[[gnu::always_inline]] inline Dual operator-(const Dual& a, const Dual& b)
{
  return {a.value - b.value, a.slope - b.slope};
}
[[gnu::always_inline]] inline Dual operator-(const Dual& a, Real b)
{
  return {a.value - b, a.slope};
}
[[gnu::always_inline]] inline Dual operator-(Real a, const Dual& b)
{
  return {a - b.value, -b.slope};
}

[[gnu::always_inline]] inline Dual operator*(const Dual& a, const Dual& b)
{
  return {a.value * b.value, a.value * b.slope + b.value * a.slope};
}
[[gnu::always_inline]] inline Dual operator*(const Dual& a, Real b)
{
  return {a.value * b, a.slope * b};
}
[[gnu::always_inline]] inline Dual operator*(Real a, const Dual& b)
{
  return b * a;
}

[[gnu::always_inline]] inline Dual operator/(const Dual& a, const Dual& b)
{
  const Real ratio = a.value / b.value;
  return {ratio, (a.slope - ratio * b.slope) / b.value};
}
[[gnu::always_inline]] inline Dual operator/(const Dual& a, Real b)
{
  return {a.value / b, a.slope / b};
}
[[gnu::always_inline]] inline Dual operator/(Real a, const Dual& b)
{
  const Real ratio = a / b.value;
  return {ratio, b.slope * (-ratio / b.value)};
}

template <class Number>
[[gnu::always_inline]] inline Dual& operator+=(Dual& a, const Number& b)
{
  return a = a + b;
}
template <class Number>
[[gnu::always_inline]] inline Dual& operator-=(Dual& a, const Number& b)
{
  return a = a - b;
}
template <class Number>
[[gnu::always_inline]] inline Dual& operator*=(Dual& a, const Number& b)
{
  return a = a * b;
}
template <class Number>
[[gnu::always_inline]] inline Dual& operator/=(Dual& a, const Number& b)
{
  return a = a / b;
}

[[gnu::always_inline]] inline bool operator<(const Dual& a, const Dual& b)
{
  return a.value < b.value;
}
[[gnu::always_inline]] inline bool operator<(const Dual& a, Real b)
{
  return a.value < b;
}
[[gnu::always_inline]] inline bool operator<=(const Dual& a, const Dual& b)
{
  return a.value <= b.value;
}
[[gnu::always_inline]] inline bool operator<=(const Dual& a, Real b)
{
  return a.value <= b;
}
[[gnu::always_inline]] inline bool operator>(const Dual& a, const Dual& b)
{
  return a.value > b.value;
}
[[gnu::always_inline]] inline bool operator>(const Dual& a, Real b)
{
  return a.value > b;
}
[[gnu::always_inline]] inline bool operator>=(const Dual& a, const Dual& b)
{
  return a.value >= b.value;
}
[[gnu::always_inline]] inline bool operator>=(const Dual& a, Real b)
{
  return a.value >= b;
}

/// Of two equal numbers `smaller` returns the first and `larger` (core/lanes.hpp) the second, so that sorting keeps each
/// derivative with its value.
[[gnu::always_inline]] inline Dual smaller(const Dual& a, const Dual& b)
{
  return b < a ? b : a;
}

/// The derivative at 0, where the root has none, is set to 0.
[[gnu::always_inline]] inline Dual square_root(const Dual& a)
{
  const Real root = std::sqrt(a.value);
  return {root, a.slope * (root > 0 ? 0.5 / root : 0.)};
}

}  // namespace berm
