// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/for_each.hpp"

#include <vector>

namespace berm {

/// Lists, ascending, the i = 0 ... count-1 for which keep(i) is true, in parallel. `selected` is overwritten; it allocates only where its capacity is too small. keep is called
/// twice for each i and may write nothing.
template <class Keep>
void select(const char* label, Index count, const Keep& keep, std::vector<Index>& selected)
{
  const Timer timer(label);
  constexpr Index chunks = 256;
  const Index size = (count + chunks - 1) / chunks;
  Index first[chunks + 1] = {};
#pragma omp parallel for schedule(static)
  for (Index c = 0; c < chunks; ++c) {
    const Index end = std::min(count, (c + 1) * size);
    for (Index i = c * size; i < end; ++i) first[c + 1] += keep(i) ? 1 : 0;
  }
  for (Index c = 0; c < chunks; ++c) first[c + 1] += first[c];
  selected.resize(static_cast<std::size_t>(first[chunks]));
#pragma omp parallel for schedule(static)
  for (Index c = 0; c < chunks; ++c) {
    const Index end = std::min(count, (c + 1) * size);
    Index at = first[c];
    for (Index i = c * size; i < end; ++i)
      if (keep(i)) selected[at++] = i;
  }
}

}  // namespace berm
