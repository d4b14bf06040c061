// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

namespace berm {

/// Calls visit(first, end) in parallel for each run of indices 0 ... count-1 of which each is the same(previous, index) as the one before it. visit may write
/// only data of its run. Few indices stay on one thread, which needs less time for them than threads need to wait for each other.
template <class Same, class Visit>
void for_each_run(Index count, const Same& same, const Visit& visit)
{
  constexpr Index min_for_threads = 128;
#pragma omp parallel for schedule(static) if (count >= min_for_threads)
  for (Index first = 0; first < count; ++first) {
    if (first > 0 && same(first - 1, first)) continue;
    Index end = first + 1;
    while (end < count && same(first, end)) ++end;
    visit(first, end);
  }
}

}  // namespace berm
