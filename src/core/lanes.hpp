// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/numbers.hpp"

namespace berm {

/// Particles are computed eight at a time. A Lanes holds one number of each; arithmetic, comparison and `mask ? a : b` work lane by lane,
/// as for a Real, so that a law written for a type T serves one particle (T = Real) and eight (T = Lanes).
constexpr int lanes = 8;
using Lanes = Real __attribute__((vector_size(lanes * sizeof(Real))));
/// In memory that program and engine share: the alignment of Lanes itself depends on the vector unit that a file is compiled for.
struct alignas(64) StoredLanes {
  Lanes value;
};
using LaneMask = std::int64_t __attribute__((vector_size(lanes * sizeof(Real))));

[[gnu::always_inline]] inline Lanes all_lanes(Real value)
{
  return value - Lanes{};
}

/// 0, 1, 2, ... 7: compared with a count it masks the lanes that hold a particle.
constexpr Lanes lane_numbers = {0, 1, 2, 3, 4, 5, 6, 7};

[[gnu::always_inline]] inline bool any(bool mask)
{
  return mask;
}
[[gnu::always_inline]] inline bool any(LaneMask mask)
{
#if defined(__AVX512DQ__)  // the compiler would take the lanes apart, one by one
  using Wide = long long __attribute__((vector_size(sizeof(LaneMask))));
  return __builtin_ia32_cvtq2mask512(reinterpret_cast<Wide>(mask)) != 0;
#else
  std::int64_t found = 0;
  for (int l = 0; l < lanes; ++l) found |= mask[l];
  return found != 0;
#endif
}

[[gnu::always_inline]] inline Real square_root(Real x)
{
  return std::sqrt(x);
}
[[gnu::always_inline]] inline Lanes square_root(Lanes x)
{
  Lanes root;
  for (int l = 0; l < lanes; ++l) root[l] = std::sqrt(x[l]);
  return root;
}

template <class T>
[[gnu::always_inline]] inline T larger(T a, T b)
{
  return a > b ? a : b;
}
template <class T>
[[gnu::always_inline]] inline T smaller(T a, T b)
{
  return a < b ? a : b;
}
template <class T>
[[gnu::always_inline]] inline T magnitude(T a)
{
  return a < T{} ? -a : a;
}

/// The sum over the lanes, always in the same order (pairs, then pairs of pairs).
[[gnu::always_inline]] inline Real sum(Lanes x)
{
  return ((x[0] + x[4]) + (x[2] + x[6])) + ((x[1] + x[5]) + (x[3] + x[7]));
}

/// The sums over the lanes of eight vectors at once, lane k that of x[k]: the same additions in the same order as sum(), but eight at a time.
[[gnu::always_inline]] inline Lanes sums(const Lanes (&x)[lanes])
{
  Lanes fours[4], twos[2];
  for (int k = 0; k < 4; ++k)  // halves: x[2k] in the lower four lanes, x[2k + 1] in the upper
    fours[k] = __builtin_shufflevector(x[2 * k], x[2 * k + 1], 0, 1, 2, 3, 8, 9, 10, 11) +
               __builtin_shufflevector(x[2 * k], x[2 * k + 1], 4, 5, 6, 7, 12, 13, 14, 15);
  for (int k = 0; k < 2; ++k)
    twos[k] = __builtin_shufflevector(fours[2 * k], fours[2 * k + 1], 0, 1, 4, 5, 8, 9, 12, 13) +
              __builtin_shufflevector(fours[2 * k], fours[2 * k + 1], 2, 3, 6, 7, 10, 11, 14, 15);
  return __builtin_shufflevector(twos[0], twos[1], 0, 2, 4, 6, 8, 10, 12, 14) +
         __builtin_shufflevector(twos[0], twos[1], 1, 3, 5, 7, 9, 11, 13, 15);
}

}  // namespace berm
