// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/dual.hpp"
#include "core/lane_parts.hpp"

#include <bit>
#include <cstdint>

namespace berm::material {

/// The bits of as many numbers as T has.
template <class T>
struct BitsOf {
  using type [[gnu::vector_size(sizeof(T))]] = std::uint64_t;
};
template <>
struct BitsOf<Real> {
  using type = std::uint64_t;
};

/// Added to a small whole number, it moves that number into the lowest bits: 1.5 * 2^52.
constexpr Real whole_number_shift = 6755399441055744.;
constexpr Real logarithm_of_two = 0.69314718055994531;

/// The Taylor series of e^r for |r| <= log(2) / 2: the term left out is below 2e-16. Its even and odd powers go side by side.
template <class T>
[[gnu::always_inline]] inline T exponential_series(const T& r)
{
  const T s = r * r;
  const T even = 1. + s * (1. / 2 + s * (1. / 24 + s * (1. / 720 + s * (1. / 40320 + s * (1. / 3628800 + s * (1. / 479001600))))));
  const T odd = 1. + s * (1. / 6 + s * (1. / 120 + s * (1. / 5040 + s * (1. / 362880 + s * (1. / 39916800)))));
  return even + r * odd;
}

/// e^x to a few units in the last place, the same operations in each lane of a vector; x beyond -700 and 700 is taken as these.
template <class T>
[[gnu::always_inline]] inline T exponential(T x)
{
  using Bits = typename BitsOf<T>::type;
  // What follows leaves such a number as it is: the way depends on the neighbours, the result does not.
  constexpr Real small = 0.34;
  if (!any(x * x > T{} + small * small)) return exponential_series(x);
  x = smaller(larger(x, T{} - 700.), T{} + 700.);
  // x = k log(2) + r, |r| <= log(2) / 2; log(2) in two parts, the first with room for k.
  const T shifted = x * (1 / logarithm_of_two) + whole_number_shift, k = shifted - whole_number_shift;
  const T r = (x - k * 0.693147180369123816490) - k * 1.90821492927058770002e-10;
  const T power = std::bit_cast<T>((std::bit_cast<Bits>(shifted) << 52) + std::bit_cast<Bits>(T{} + 1.));
  return exponential_series(r) * power;
}

/// log(x) of a positive normal number to a few units in the last place.
template <class T>
[[gnu::always_inline]] inline T logarithm(T x)
{
  using Bits = typename BitsOf<T>::type;
  // x = 2^k m, m from sqrt(1/2) to sqrt(2); the exponent is counted from sqrt(1/2).
  const Bits root = std::bit_cast<Bits>(T{} + 0.70710678118654752), one = std::bit_cast<Bits>(T{} + 1.);
  const Bits from_root = std::bit_cast<Bits>(x) - root + one, exponent = from_root >> 52;
  const T k = std::bit_cast<T>(exponent + std::bit_cast<Bits>(T{} + whole_number_shift)) - (whole_number_shift + 1023.);
  const T m = std::bit_cast<T>(std::bit_cast<Bits>(x) - ((exponent << 52) - one));
  // log(m) = 2 artanh((m - 1) / (m + 1)); the term left out is below 1e-17.
  const T f = (m - 1.) / (m + 1.), square = f * f;
  const T series =
      square *
      (1. / 3 +
       square *
           (1. / 5 +
            square * (1. / 7 +
                      square * (1. / 9 +
                                square * (1. / 11 +
                                          square * (1. / 13 +
                                                    square * (1. / 15 + square * (1. / 17 + square * (1. / 19 + square * (1. / 21))))))))));
  return k * logarithm_of_two + (2. * f + 2. * f * series);
}

[[gnu::always_inline]] inline Dual exponential(const Dual& x)
{
  const Real power = exponential(x.value);
  return {power, x.slope * power};
}

[[gnu::always_inline]] inline Dual logarithm(const Dual& x)
{
  return {logarithm(x.value), x.slope / x.value};
}

}  // namespace berm::material
