// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

namespace berm {

/// A number with its partial derivatives by up to four unknowns. Arithmetic follows the rules of differentiation and comparison looks at the value
/// alone, so that a law written for a type T gives its own derivative with T = Dual: that of the branch which the value takes.
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

/// Of two equal numbers `smaller` gives the first and `larger` (core/lanes.hpp) the second: numbers sorted with the two keep each its own slope.
[[gnu::always_inline]] inline Dual smaller(const Dual& a, const Dual& b)
{
  return b < a ? b : a;
}

/// At 0, where the root has no derivative, it is given as 0.
[[gnu::always_inline]] inline Dual square_root(const Dual& a)
{
  const Real root = std::sqrt(a.value);
  return {root, a.slope * (root > 0 ? 0.5 / root : 0.)};
}

[[gnu::always_inline]] inline Dual decimal_logarithm(const Dual& a)
{
  constexpr Real of_e = 0.43429448190325183;
  return {std::log10(a.value), a.slope * (of_e / a.value)};
}

}  // namespace berm
