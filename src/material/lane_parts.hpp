// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/lanes.hpp"
#include "core/tensor.hpp"

#include <cstring>
#include <type_traits>

namespace berm {

/// As many lanes as one register of the machine holds: 8, 4 or 2. Comparing and choosing are slow in the compiler for vectors wider than a register
/// (ten times in a return to the yield surface), so a law with many of them computes Lanes in such parts. On AVX-512 the part is the whole.
#if defined(__AVX512F__)
constexpr int part_lanes = 8;
#elif defined(__AVX__)
constexpr int part_lanes = 4;
#else
constexpr int part_lanes = 2;
#endif
using LanePart = Real __attribute__((vector_size(part_lanes * sizeof(Real))));
using LanePartMask = std::int64_t __attribute__((vector_size(part_lanes * sizeof(Real))));

template <class Mask>
requires(std::is_same_v<Mask, LanePartMask>&& part_lanes < lanes) [[gnu::always_inline]] inline bool any(Mask mask)
{
  std::int64_t found = 0;
  for (int l = 0; l < part_lanes; ++l) found |= mask[l];
  return found != 0;
}

template <class Part>
requires(std::is_same_v<Part, LanePart>&& part_lanes < lanes) [[gnu::always_inline]] inline Part square_root(Part x)
{
  Part root;
  for (int l = 0; l < part_lanes; ++l) root[l] = std::sqrt(x[l]);
  return root;
}

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

}  // namespace berm
