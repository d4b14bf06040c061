// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/timer.hpp"

#include <exception>

namespace berm {

/// Runs body(k) for k = 0 ... count-1 in parallel with dynamic scheduling, for tasks of unequal length. The label is the row
/// of the timing table. body may write only data of k, so that the result is independent of the number of threads. Where it throws the others are done all the same,
/// and what the first of those k threw is thrown.
template <class Body>
void for_each_task(const char* label, Index count, const Body& body)
{
  const Timer timer(label);
  Index failed = count;
  std::exception_ptr error;
#pragma omp parallel for schedule(dynamic)
  for (Index k = 0; k < count; ++k) try {
      body(k);
    } catch (...) {
#pragma omp critical(failed_task)
      if (k < failed) failed = k, error = std::current_exception();
    }
  if (error) std::rethrow_exception(error);
}

}  // namespace berm
