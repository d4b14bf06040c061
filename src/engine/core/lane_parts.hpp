// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/lanes.hpp"

#include <cstring>
#include <type_traits>

namespace berm {

/// Passes over particles process a cell's chain of blocks in parts as wide as a register: the compiler handles comparison
/// and selection on wider vectors slowly (ten times in a return to the yield surface). A part is half a block (SSE), a block
/// (AVX2), or two consecutive blocks where there are two (AVX-512). Empty parts are skipped.
#if defined(__AVX__)
using LanePart = Lanes;
#else
using LanePart = Real __attribute__((vector_size(2 * sizeof(Real))));
#endif
#if defined(__AVX512F__)
using WidePart = Real __attribute__((vector_size(2 * lanes * sizeof(Real))));
#else
using WidePart = LanePart;
#endif

/// One part of a cell's particles, its numbers in vectors of type V.
template <class V>
struct Part {
  using Vector = V;
  using Mask = decltype(V() < V());
  static constexpr int size = lanes_of<V>;

  Index block, other;  ///< the block, and the next one where V spans two
  Index index;         ///< of the part's first particle in its cell
  Index left;          ///< particles of the cell from that one on, at least 1
  int first;           ///< lane of the part's first particle in its block

  /// Mask of the lanes that hold a particle.
  [[gnu::always_inline]] Mask alive() const
  {
    V numbers;
    for (int l = 0; l < size; ++l) numbers[l] = l;
    return numbers < static_cast<Real>(left) - V{};
  }

  /// The part's numbers: low from the block, high from the next one.
  [[gnu::always_inline]] V get(const Lanes& low, const Lanes& high) const
  {
    if constexpr (size > lanes) {
      return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
    } else if constexpr (size == lanes) {
      return low;
    } else {
      V numbers;
      std::memcpy(&numbers, reinterpret_cast<const char*>(&low) + first * sizeof(Real), sizeof numbers);
      return numbers;
    }
  }
  [[gnu::always_inline]] void set(Lanes& low, Lanes& high, const V& numbers) const
  {
    if constexpr (size > lanes) {
      low = __builtin_shufflevector(numbers, numbers, 0, 1, 2, 3);
      high = __builtin_shufflevector(numbers, numbers, 4, 5, 6, 7);
    } else if constexpr (size == lanes) {
      low = numbers;
    } else {
      std::memcpy(reinterpret_cast<char*>(&low) + first * sizeof(Real), &numbers, sizeof numbers);
    }
  }

  /// Calls change(V*) on this part of `count` Lanes, `max` at most; in place where a part is a block, so that unchanged values are not
  /// written.
  template <int max, class Change>
  [[gnu::always_inline]] void change(Lanes* low, Lanes* high, int count, const Change& change) const
  {
    if constexpr (std::is_same_v<V, Lanes>) {
      change(low);
    } else {
      V numbers[max + 1];  // an array has at least one element
      for (int k = 0; k < count; ++k) numbers[k] = get(low[k], high[k]);
      change(numbers);
      for (int k = 0; k < count; ++k) set(low[k], high[k], numbers[k]);
    }
  }
};

/// Calls visit(part) for each part of a cell's particles, in order. next_of(block) gives the next block of the chain.
template <class NextOf, class Visit>
[[gnu::always_inline]] inline void for_each_part(Index block, Index count, const NextOf& next_of, const Visit& visit)
{
  for (Index index = 0; index < count; index += lanes) {
    const Index next = next_of(block);
    if constexpr (lanes_of < WidePart >> lanes)
      if (count - index > lanes) {
        visit(Part<WidePart>{block, next, index, count - index, 0});
        index += lanes;
        block = next_of(next);
        continue;
      }
    for (int first = 0; first < lanes && first < count - index; first += lanes_of<LanePart>)
      visit(Part<LanePart>{block, block, index + first, count - index - first, first});
    block = next;
  }
}

}  // namespace berm
