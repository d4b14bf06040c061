// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/lanes.hpp"

#include <cstring>

namespace berm {

/// As many lanes as one register of the machine holds: 8, 4 or 2. Comparing and choosing are slow in the compiler for vectors wider than a register
/// (ten times in a return to the yield surface), so the passes over particles take a block in such parts, and leave out those that hold no particle.
/// With AVX-512 the part is the whole.
#if defined(__AVX512F__)
constexpr int part_lanes = 8;
#elif defined(__AVX__)
constexpr int part_lanes = 4;
#else
constexpr int part_lanes = 2;
#endif
using LanePart = Real __attribute__((vector_size(part_lanes * sizeof(Real))));
using LanePartMask = decltype(LanePart() < LanePart());

/// Lanes first, ..., first + part_lanes - 1.
[[gnu::always_inline]] inline LanePart part_of(const Lanes& x, int first)
{
  LanePart part;
  std::memcpy(&part, reinterpret_cast<const char*>(&x) + first * sizeof(Real), sizeof part);
  return part;
}

[[gnu::always_inline]] inline void set_part(Lanes& x, int first, const LanePart& part)
{
  std::memcpy(reinterpret_cast<char*>(&x) + first * sizeof(Real), &part, sizeof part);
}

/// Lets change(LanePart*) work on that part of `count` Lanes: in place where the part is the whole, so that what does not change is not written.
template <int count, class Change>
[[gnu::always_inline]] inline void with_parts(Lanes* x, int first, const Change& change)
{
  if constexpr (part_lanes == lanes) {
    change(x);
  } else {
    LanePart parts[count + 1];  // an array has at least one place
    for (int k = 0; k < count; ++k) parts[k] = part_of(x[k], first);
    change(parts);
    for (int k = 0; k < count; ++k) set_part(x[k], first, parts[k]);
  }
}

}  // namespace berm
