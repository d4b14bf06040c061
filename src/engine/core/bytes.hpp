// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstring>
#include <vector>

namespace berm {

/// Appends the bytes of `count` objects.
template <class T>
void put_bytes(std::vector<std::byte>& bytes, const T* from, std::size_t count = 1)
{
  const auto* first = reinterpret_cast<const std::byte*>(from);
  bytes.insert(bytes.end(), first, first + count * sizeof(T));
}

/// Reads the bytes of `count` objects, and gives the place behind them.
template <class T>
const std::byte* get_bytes(const std::byte* at, T* to, std::size_t count = 1)
{
  if (count > 0) std::memcpy(static_cast<void*>(to), at, count * sizeof(T));
  return at + count * sizeof(T);
}

}  // namespace berm
