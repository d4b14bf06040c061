// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/for_each.hpp"
#include "core/ranks.hpp"

#include <type_traits>
#include <vector>

namespace berm {

/// The runs of an ascending list of cells (or nodes) that lie in one chunk, a range of their numbers. Loops over the list go chunk by chunk: sums of a chunk
/// depend on what is in it alone, and chunks are added in their order, so that sums depend neither on threads nor on what else is listed.
struct Chunks {
  std::vector<Index> number;    ///< of each chunk with entries, ascending
  std::vector<Index> begin{0};  ///< in the list, of each of them; then the end

  Index all = 0;  ///< chunks there are, with those that have no entry

  Index count() const { return static_cast<Index>(number.size()); }
};

/// Where chunks of so many numbers begin; then the end.
inline std::vector<Index> chunk_bounds(Index count)
{
  constexpr Index usual_count = 1024, min = 32, max = 4096;
  const Index size = std::clamp(count / usual_count, min, max);
  std::vector<Index> bounds;
  for (Index first = 0; first < count; first += size) bounds.push_back(first);
  bounds.push_back(count);
  return bounds;
}

/// Lists, ascending and in parallel, the numbers within `bounds` for which keep(number) is true, and their chunks. It allocates only where the capacity of the
/// lists is too small. keep is called twice for each number and may write nothing.
template <class Keep>
void select(const char* label, const std::vector<Index>& bounds, const Keep& keep, std::vector<Index>& selected, Chunks& chunks)
{
  const Timer timer(label);
  const auto all = static_cast<Index>(bounds.size()) - 1;
  chunks.all = all;
  chunks.number.reserve(static_cast<std::size_t>(all));
  chunks.begin.assign(static_cast<std::size_t>(all) + 1, 0);
#pragma omp parallel for schedule(static)
  for (Index c = 0; c < all; ++c) {
    Index kept = 0;
    for (Index i = bounds[c]; i < bounds[c + 1]; ++i) kept += keep(i) ? 1 : 0;
    chunks.begin[c + 1] = kept;
  }
  chunks.number.clear();
  for (Index c = 0; c < all; ++c)
    if (const Index counted = chunks.begin[c + 1]; counted > 0) {
      const Index first = chunks.begin[chunks.number.size()];
      chunks.number.push_back(c);
      chunks.begin[chunks.number.size()] = first + counted;
    }
  chunks.begin.resize(chunks.number.size() + 1);
  selected.resize(static_cast<std::size_t>(chunks.begin.back()));
#pragma omp parallel for schedule(static)
  for (Index k = 0; k < chunks.count(); ++k) {
    const Index c = chunks.number[k];
    Index at = chunks.begin[k];
    for (Index i = bounds[c]; i < bounds[c + 1]; ++i)
      if (keep(i)) selected[at++] = i;
  }
}

/// Runs body(i) for each entry i of the list in parallel; each thread gets the same chunks at every call. body may write only data of i.
template <class Body>
void for_each(const char* label, const Chunks& chunks, const Body& body)
{
  const Timer timer(label);
#pragma omp parallel for schedule(static, 1)
  for (Index k = 0; k < chunks.count(); ++k)
    for (Index i = chunks.begin[k]; i < chunks.begin[k + 1]; ++i) body(i);
}

/// Sum of what first(i, carried, sum) and then(i, carried, sum) add over the entries of the list, on all ranks that have a part of it. Sum needs a default value of zero and +=, and
/// is copied by its bytes. Each thread gets the chunks that it has in for_each. then(i) runs soon after first(i), when what both touch is in the cache still, with
/// the Carried that first(i) left; no first(j) may read what then(i) writes, but where i = j.
template <class Sum, class Carried, class First, class Then>
Sum sum_in_two_steps(const char* label, const Chunks& chunks, const First& first_step, const Then& then)
{
  constexpr Index group = 16;  // entries
  const Timer timer(label);
  static thread_local std::vector<Sum> kept;  // from call to call; problems may be stepped side by side
  std::vector<Sum>& parts = kept;
  Ranks& ranks = Ranks::of_run();
  parts.reserve(static_cast<std::size_t>(chunks.all));
  if (ranks.divided())
    parts.assign(static_cast<std::size_t>(chunks.all), Sum{});
  else
    parts.resize(chunks.number.size());
#pragma omp parallel for schedule(static, 1)
  for (Index k = 0; k < chunks.count(); ++k) {
    First first_of_chunk = first_step;  // copies: no write to memory can change what they have captured by value
    Then then_of_chunk = then;
    Sum sum{};
    Carried carried[group];
    for (Index first = chunks.begin[k]; first < chunks.begin[k + 1]; first += group) {
      const Index end = std::min(first + group, chunks.begin[k + 1]);
      for (Index i = first; i < end; ++i) first_of_chunk(i, carried[i - first], sum);
      for (Index i = first; i < end; ++i) then_of_chunk(i, carried[i - first], sum);
    }
    parts[ranks.divided() ? chunks.number[k] : k] = sum;
  }
  ranks.share_chunks(parts.data(), sizeof(Sum));
  Sum total{};
  for (const Sum& part : parts) total += part;
  return total;
}
/// Sum of term(i), or of what term(i, sum) adds, over the entries of the list, likewise.
template <class Sum, class Term>
Sum sum_of(const char* label, const Chunks& chunks, const Term& term)
{
  struct Nothing {};
  return sum_in_two_steps<Sum, Nothing>(
      label, chunks,
      [&](Index i, Nothing&, Sum& sum) {
        if constexpr (std::is_invocable_v<const Term&, Index, Sum&>)
          term(i, sum);
        else
          sum += term(i);
      },
      [](Index, const Nothing&, Sum&) {});
}

}  // namespace berm
