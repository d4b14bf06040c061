// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"
#include "os/lazy_memory.hpp"

#include <new>
#include <type_traits>
#include <vector>

namespace berm {

/// Allocator of zeroed memory whose pages are committed when first written: what stays zero takes no memory.
template <class T>
struct LazyZeroAllocator {
  using value_type = T;

  LazyZeroAllocator() = default;
  template <class Other>
  LazyZeroAllocator(const LazyZeroAllocator<Other>&)
  {
  }

  T* allocate(std::size_t count) { return static_cast<T*>(zero_memory(count * sizeof(T), alignof(T))); }
  void deallocate(T* memory, std::size_t count) { free_zero_memory(memory, count * sizeof(T)); }

  template <class Made, class... Arguments>
  void construct(Made* place, Arguments&&... arguments)
  {
    if constexpr (sizeof...(Arguments) > 0) ::new (static_cast<void*>(place)) Made(std::forward<Arguments>(arguments)...);
  }
  bool operator==(const LazyZeroAllocator&) const = default;
};

/// Values on one kind of mesh entity; fields on different entities are different types.
template <class Place, class T>
class Field {
public:
  Field() = default;
  explicit Field(Index size, const T& value = T{}) : values_(size, value) {}
  /// Zeros in memory that is committed when first written. T: numbers and fixed-size arrays of them, Eigen's included.
  static Field zeros(Index size) requires std::is_trivially_destructible_v<T>
  {
    Field field;
    field.values_ = std::vector<T, LazyZeroAllocator<T>>(size);
    return field;
  }

  T& operator[](Index i) { return values_[i]; }
  const T& operator[](Index i) const { return values_[i]; }
  Index size() const { return static_cast<Index>(values_.size()); }
  bool empty() const { return values_.empty(); }
  T* data() { return values_.data(); }
  const T* data() const { return values_.data(); }
  void assign(Index size, const T& value = T{}) { values_.assign(size, value); }
  void push_back(const T& value) { values_.push_back(value); }
  auto begin() { return values_.begin(); }
  auto end() { return values_.end(); }
  auto begin() const { return values_.begin(); }
  auto end() const { return values_.end(); }

private:
  std::vector<T, LazyZeroAllocator<T>> values_;
};

struct OnNodes;
struct OnCells;
template <class T>
using NodeField = Field<OnNodes, T>;
template <class T>
using CellField = Field<OnCells, T>;

}  // namespace berm
