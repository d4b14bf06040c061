// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/timer.hpp"

#include <algorithm>
#include <omp.h>

namespace berm {

/// Number of consecutive indices that a thread takes at a time, cyclically with the others, in all loops over `count`. Cells
/// with many particles lie next to each other, so one range per thread would be unbalanced; equal chunks in all loops keep
/// data in the thread's cache.
inline Index chunk_of(Index count)
{
  constexpr Index min_chunks = 64, max = 256;
  return std::clamp(count / min_chunks, 1, max);
}

/// Runs body(i) for i = 0 ... count-1 in parallel; each thread gets the same chunks at every call. The label is the row of
/// the timing table. body may write only data of i, so that the result is independent of the number of threads.
template <class Body>
void for_each(const char* label, Index count, const Body& body)
{
  const Timer timer(label);
  const Index chunk = chunk_of(count);
#pragma omp parallel for schedule(static, chunk)
  for (Index i = 0; i < count; ++i) body(i);
}

/// Sum of term(i) over i = 0 ... count-1, bitwise independent of the number of threads: chunks of fixed size are summed
/// separately, then in order. Sum needs a default value of zero and +=. One thread does fewer terms than `min_for_threads`.
template <class Sum, class Term>
Sum sum_of(const char* label, Index count, const Term& term, Index min_for_threads = 0)
{
  const Timer timer(label);
  constexpr Index max_chunks = 256;
  const Index chunk = chunk_of(count);
  Sum total{};
  for (Index first = 0; first < count; first += chunk * max_chunks) {
    Sum part[max_chunks] = {};
    const Index chunks = std::min(max_chunks, (count - first + chunk - 1) / chunk);
#pragma omp parallel for schedule(static, 1) if (count >= min_for_threads)
    for (Index c = 0; c < chunks; ++c) {
      Sum sum{};
      const Index end = std::min(count, first + (c + 1) * chunk);
      for (Index i = first + c * chunk; i < end; ++i) sum += term(i);
      part[c] = sum;
    }
    for (Index c = 0; c < chunks; ++c) total += part[c];
  }
  return total;
}

/// Maximum of value(i), or `lowest` where count = 0.
template <class Value>
Real largest_of(const char* label, Index count, Real lowest, const Value& value)
{
  const Timer timer(label);
  Real largest = lowest;
#pragma omp parallel for schedule(static) reduction(max : largest)
  for (Index i = 0; i < count; ++i) largest = std::max(largest, value(i));
  return largest;
}

}  // namespace berm
