// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/timer.hpp"

namespace berm {

/// Runs body(k) for k = 0 ... count-1 in parallel with dynamic scheduling, for tasks of unequal length. The label is the row
/// of the timing table. body may write only data of k, so that the result is independent of the number of threads, and must
/// not throw.
template <class Body>
void for_each_task(const char* label, Index count, const Body& body)
{
  const Timer timer(label);
#pragma omp parallel for schedule(dynamic)
  for (Index k = 0; k < count; ++k) body(k);
}

}  // namespace berm
