// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "material/axis_and_circle.hpp"

namespace berm::material {

/// The direction of a deviator, compression positive: with q = sqrt(3/2 s : s) and the mean effective stress p' the largest and the smallest principal stress are
/// p' + largest q and p' - smallest q; lode = 27 det(s) / (2 q^3) is 1 in triaxial compression and -1 in extension.
template <class T>
struct DeviatorShape {
  T largest, smallest, lode;
};

/// Of a deviator in Pa, tension positive, and its q.
template <class T>
[[gnu::always_inline]] inline DeviatorShape<T> deviator_shape(const SymTensor<2, T>& deviator, const T& q)
{
  constexpr Real smallest = 1e-100;  // Pa; its cube does not underflow
  const T mean = (deviator[0] + deviator[1]) * 0.5, half = (deviator[0] - deviator[1]) * 0.5, z = deviator[2];
  const T radius = square_root(half * half + deviator[3] * deviator[3]), a = mean + radius, b = mean - radius;
  const T scale = 1. / larger(q, T{} + smallest);
  return {-(smaller(b, z) * scale), larger(a, z) * scale, -13.5 * (a * scale) * (b * scale) * (z * scale)};
}
template <class T>
[[gnu::always_inline]] inline DeviatorShape<T> deviator_shape(const SymTensor<3, T>& s, const T& q)
{
  constexpr Real smallest = 1e-100;
  const T scale = 1. / larger(q, T{} + smallest);
  const T determinant = s[0] * (s[1] * s[2] - s[4] * s[4]) - s[3] * (s[3] * s[2] - s[4] * s[5]) + s[5] * (s[3] * s[4] - s[1] * s[5]);
  const T lode = smaller(larger(-13.5 * determinant * scale * scale * scale, T{} - 1.), T{} + 1.);
  const T far = cosine_of_third(magnitude(lode)), near = 0.5 * far + 0.86602540378443865 * square_root(larger(1. - far * far, T{}));
  const auto compression = lode >= T{};
  return {(2. / 3) * (compression ? far : near), (2. / 3) * (compression ? near : far), lode};
}

/// The sine of a mobilised friction angle, and its derivative.
template <class T>
struct MobilisedSine {
  T value, change;
};

/// The mobilised friction angle of Matsuoka and Nakai (1974), I1 I2 / I3 = 9 + 8 tan^2(phi_m), at the stress ratio x = q / p' of a stress in compression:
///
///   sin^2(phi_m) = (I1 I2 - 9 I3) / (I1 I2 - I3) = x^2 (1 - lode x / 3) / (4 - x^2 / 3 - lode x^3 / 27),
///
/// which in triaxial compression and extension is that of Mohr and Coulomb. The derivative is with respect to x.
template <class T>
[[gnu::always_inline]] inline MobilisedSine<T> mobilised_sine(const T& x, const T& lode)
{
  const T square = x * x, bent = lode * x, denominator = 4. - square * (1. / 3) * (1. + bent * (1. / 9)), numerator = 1. - bent * (1. / 3);
  const T root = square_root(numerator * denominator), per = 1. / (denominator * root);
  // Sine and derivative without division by x, which may be zero.
  const T value = x * numerator * denominator * per;
  return {value, 0.5 * per * (denominator * (2. - bent) + square * numerator * (2. / 3 + bent * (1. / 9)))};
}

/// The stress ratio q / p' at which the sine of the mobilised friction angle is s. Its reciprocal is the largest root of a cubic polynomial:
///
///   x = 3 s / (sqrt(3 + s^2) cos(acos(k) / 3)),   k = -lode s (9 - s^2) / (3 + s^2)^(3/2).
template <class T>
[[gnu::always_inline]] inline T stress_ratio(const T& s, const T& lode)
{
  const T s2 = s * s, per_root = 1. / square_root(3. + s2), k = -lode * s * (9. - s2) * (per_root * per_root * per_root);
  const T far = cosine_of_third(smaller(magnitude(k), T{} + 1.));
  const T near = 0.5 * far + 0.86602540378443865 * square_root(larger(1. - far * far, T{}));
  return 3. * s * per_root / (k >= T{} ? far : near);
}

}  // namespace berm::material
