// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/lane_parts.hpp"

namespace berm {

/// The numbers of a part as wide as the widest: a narrow one fills the lower lanes, the others are 0.
template <class V>
[[gnu::always_inline]] inline WidePart widened(const V& numbers)
{
  if constexpr (lanes_of<V> < lanes_of<WidePart>)
    return __builtin_shufflevector(numbers, V{}, 0, 1, 2, 3, 4, 5, 6, 7);
  else
    return numbers;
}

}  // namespace berm
