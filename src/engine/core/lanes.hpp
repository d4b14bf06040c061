// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

#include <type_traits>

namespace berm {

/// Four numbers, one of each particle of a block; arithmetic, comparison and `mask ? a : b` act lane by lane as on a Real,
/// so that a law written for a type T serves one particle (T = Real) and several (T = Lanes).
constexpr int lanes = 4;
using Lanes = Real __attribute__((vector_size(lanes * sizeof(Real))));
/// Lanes in memory shared by program and engine: the alignment of Lanes itself depends on the vector unit that a file is
/// compiled for.
struct alignas(lanes * sizeof(Real)) StoredLanes {
  Lanes value;
};
using LaneMask = std::int64_t __attribute__((vector_size(lanes * sizeof(Real))));

[[gnu::always_inline]] inline Lanes all_lanes(Real value)
{
  return value - Lanes{};
}

/// 0, 1, 2, 3: compared with a count, the mask of the lanes that hold a particle.
constexpr Lanes lane_numbers = {0, 1, 2, 3};

/// Number of lanes of a vector.
template <class V>
constexpr int lanes_of = sizeof(V) / sizeof(Real);

[[gnu::always_inline]] inline bool any(bool mask)
{
  return mask;
}
/// Whether a lane of a mask is set; the compiler by itself would extract the lanes one by one.
template <class Mask>
requires(lanes_of<Mask> > 1) [[gnu::always_inline]] inline bool any(Mask mask)
{
#if defined(__AVX512DQ__)
  if constexpr (lanes_of<Mask> == 8) {
    using Eight = long long __attribute__((vector_size(64)));
    return __builtin_ia32_cvtq2mask512(reinterpret_cast<Eight>(mask)) != 0;
  }
#endif
#if defined(__AVX__)
  if constexpr (lanes_of<Mask> == 4) {
    using Four = Real __attribute__((vector_size(32)));
    return __builtin_ia32_movmskpd256(reinterpret_cast<Four>(mask)) != 0;
  }
#endif
  std::int64_t found = 0;
  for (int l = 0; l < lanes_of<Mask>; ++l) found |= mask[l];
  return found != 0;
}

[[gnu::always_inline]] inline Real square_root(Real x)
{
  return std::sqrt(x);
}
template <class V>
requires(lanes_of<V> > 1) [[gnu::always_inline]] inline V square_root(V x)
{
  V root;
  for (int l = 0; l < lanes_of<V>; ++l) root[l] = std::sqrt(x[l]);
  return root;
}

/// The second number where both are equal or one is not a number, as the instruction of the processor has it; the compiler by itself would compare and select.
template <class T>
[[gnu::always_inline]] inline T larger(T a, T b)
{
#if defined(__AVX__)
  if constexpr (std::is_same_v<T, Lanes>) return __builtin_ia32_maxpd256(a, b);
#endif
  return a > b ? a : b;
}
template <class T>
[[gnu::always_inline]] inline T smaller(T a, T b)
{
#if defined(__AVX__)
  if constexpr (std::is_same_v<T, Lanes>) return __builtin_ia32_minpd256(a, b);
#endif
  return a < b ? a : b;
}
template <class T>
[[gnu::always_inline]] inline T magnitude(T a)
{
  return a < T{} ? -a : a;
}

/// Horizontal sums of as many vectors as each has lanes; lane k is the sum of x[k]. Order: neighbours, then pairs of neighbours, then
/// halves, which takes the fewest moves between lanes.
template <class V>
[[gnu::always_inline]] inline V sums(const V (&x)[lanes_of<V>])
{
  if constexpr (lanes_of<V> == 2) {
    return __builtin_shufflevector(x[0], x[1], 0, 2) + __builtin_shufflevector(x[0], x[1], 1, 3);
  } else if constexpr (lanes_of<V> == 4) {
    V twos[2];
    for (int k = 0; k < 2; ++k)
      twos[k] = __builtin_shufflevector(x[2 * k], x[2 * k + 1], 0, 4, 2, 6) + __builtin_shufflevector(x[2 * k], x[2 * k + 1], 1, 5, 3, 7);
    return __builtin_shufflevector(twos[0], twos[1], 0, 1, 4, 5) + __builtin_shufflevector(twos[0], twos[1], 2, 3, 6, 7);
  } else {
    static_assert(lanes_of<V> == 8);
    V twos[4], fours[2];
    for (int k = 0; k < 4; ++k)
      twos[k] = __builtin_shufflevector(x[2 * k], x[2 * k + 1], 0, 8, 2, 10, 4, 12, 6, 14) +
                __builtin_shufflevector(x[2 * k], x[2 * k + 1], 1, 9, 3, 11, 5, 13, 7, 15);
    for (int k = 0; k < 2; ++k)
      fours[k] = __builtin_shufflevector(twos[2 * k], twos[2 * k + 1], 0, 1, 8, 9, 4, 5, 12, 13) +
                 __builtin_shufflevector(twos[2 * k], twos[2 * k + 1], 2, 3, 10, 11, 6, 7, 14, 15);
    return __builtin_shufflevector(fours[0], fours[1], 0, 1, 2, 3, 8, 9, 10, 11) +
           __builtin_shufflevector(fours[0], fours[1], 4, 5, 6, 7, 12, 13, 14, 15);
  }
}

/// Horizontal sum of one vector, in the order of sums().
template <class V>
[[gnu::always_inline]] inline Real sum(V x)
{
  if constexpr (lanes_of<V> == 2) {
    return x[0] + x[1];
  } else if constexpr (lanes_of<V> == 4) {
    return (x[0] + x[1]) + (x[2] + x[3]);
  } else {
    static_assert(lanes_of<V> == 8);
    return ((x[0] + x[1]) + (x[2] + x[3])) + ((x[4] + x[5]) + (x[6] + x[7]));
  }
}

}  // namespace berm
