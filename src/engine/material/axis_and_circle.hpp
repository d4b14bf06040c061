// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/lanes.hpp"
#include "core/tensor.hpp"

namespace berm::material {

/// A stress in space as the principal stress that is farthest from the other two, and Mohr's circle of those two, in the plane across its axis:
///
///   stress = value axis + centre (1 - axis) + deviator,   axis = n n^T with the unit vector n of that principal direction.
///
/// Neither needs the two directions in the plane, which are undefined where the circle is a point. T is Real for one stress, or a vector of numbers for
/// several, in Pa.
template <class T>
struct AxisAndCircle {
  using Mask = decltype(T{} < T{});

  Mask first{};  ///< value is the largest principal stress, not the smallest
  T value{}, centre{}, radius{};
  SymTensor<3, T> axis, deviator;
};

/// The largest root x of 4 x^3 - 3 x = q for q from 0 to 1: cos(acos(q)/3).
template <class T>
[[gnu::always_inline]] inline T cosine_of_third(const T& q)
{
  const T q2 = q * q, q4 = q2 * q2;  // interpolated at the zeros of a Chebyshev polynomial, to 2e-9
  const T low = (0.866025405599564 + 0.16666637114459293 * q) + (0.02460429680494765 * q - 0.04810444145461736) * q2;
  const T high = (0.009383330672620772 * q - 0.01510727520943827) + (0.0017648569477158788 * q - 0.004929691292929874) * q2;
  const T x = low + (high - 0.0003028542202729437 * q4) * q4, square = x * x;
  return x - ((4. * square - 3.) * x - q) / (12. * square - 3.);  // Newton's method: rounding
}

/// In closed form. The root of the characteristic polynomial that is farthest from the others is well-conditioned whatever the stress; so is its axis, by
/// Sylvester's formula. What is left lies in a plane and has the exact solution of plane stress. The error is that of rounding, as of principal_axes, also
/// where principal stresses are equal. An isotropic stress has no axis; what stands for it multiplies only rounding.
template <class T>
[[gnu::always_inline]] inline AxisAndCircle<T> axis_and_circle(const SymTensor<3, T>& stress)
{
  constexpr Real smallest = 1e-100;  // Pa; its cube does not underflow
  const T mean = trace(stress) * (1. / 3);
  SymTensor<3, T> s;  // by components: a copy of the whole is made in pieces, for which registers then wait
  for (int k = 0; k < 6; ++k) s[k] = k < 3 ? stress[k] - mean : stress[k];
  // The square and the determinant do not wait for the size.
  SymTensor<3, T> square;
  square[0] = s[0] * s[0] + s[3] * s[3] + s[5] * s[5];
  square[1] = s[3] * s[3] + s[1] * s[1] + s[4] * s[4];
  square[2] = s[5] * s[5] + s[4] * s[4] + s[2] * s[2];
  square[3] = s[0] * s[3] + s[3] * s[1] + s[5] * s[4];
  square[4] = s[3] * s[5] + s[1] * s[4] + s[4] * s[2];
  square[5] = s[0] * s[5] + s[3] * s[4] + s[5] * s[2];
  const T determinant = s[0] * (s[1] * s[2] - s[4] * s[4]) - s[3] * (s[3] * s[2] - s[4] * s[5]) + s[5] * (s[3] * s[4] - s[1] * s[5]);
  const T size = square_root(double_dot(s, s) * (2. / 3)), scale = 1. / larger(size, T{} + smallest), scale2 = scale * scale;

  // The principal values of s are size times cos(a), cos(a + 120 deg), cos(a - 120 deg) with cos(3 a) = 4 det(s) / size^3.
  const T triple = (4. * scale) * (scale2 * determinant);

  AxisAndCircle<T> made;
  made.first = triple >= T{};
  const T far = cosine_of_third(smaller(magnitude(triple), T{} + 1.)), x = made.first ? far : -far;
  const T inverse = 1. / (3. * x * x - 0.75), of_one = (x * x - 0.75) * inverse, of_stress = x * scale * inverse,
          of_square = scale2 * inverse;
  const T value = size * x;
  for (int k = 0; k < 6; ++k) {
    made.axis[k] = of_square * square[k] + of_stress * s[k] + (k < 3 ? of_one : T{});
    made.deviator[k] = s[k] - 1.5 * value * made.axis[k] + (k < 3 ? 0.5 * value : T{});
  }
  made.value = mean + value;
  made.centre = mean - 0.5 * value;
  made.radius = square_root(double_dot(made.deviator, made.deviator) * 0.5);
  return made;
}

/// Principal stresses, s1 >= s2 >= s3, Pa.
template <class T>
struct Principal {
  T s1, s2, s3;
};

template <class T>
[[gnu::always_inline]] inline Principal<T> principal(const AxisAndCircle<T>& s)
{
  const T high = s.centre + s.radius, low = s.centre - s.radius;
  return {s.first ? s.value : high, s.first ? high : low, s.first ? low : s.value};
}

/// The stress with the same directions and other principal stresses.
template <class T>
[[gnu::always_inline]] inline SymTensor<3, T> with_principal(const AxisAndCircle<T>& s, const Principal<T>& now)
{
  const T value = s.first ? now.s1 : now.s3, high = s.first ? now.s2 : now.s1, low = s.first ? now.s3 : now.s2;
  const T centre = 0.5 * (high + low), radius = 0.5 * (high - low);
  const T shrink = radius / (s.radius > T{} ? s.radius : T{} + 1.), along = value - centre;
  SymTensor<3, T> stress;
  for (int k = 0; k < 6; ++k) stress[k] = along * s.axis[k] + shrink * s.deviator[k] + (k < 3 ? centre : T{});
  return stress;
}

}  // namespace berm::material
