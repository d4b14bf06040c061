// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/numbers.hpp"

#include <vector>

namespace berm {

/// Values that live on one kind of thing; fields on different things are different types.
template <class Place, class T>
class Field {
public:
  Field() = default;
  explicit Field(Index size, const T& value = T{}) : values_(size, value) {}

  T& operator[](Index i) { return values_[i]; }
  const T& operator[](Index i) const { return values_[i]; }
  Index size() const { return static_cast<Index>(values_.size()); }
  T* data() { return values_.data(); }
  const T* data() const { return values_.data(); }
  void assign(Index size, const T& value = T{}) { values_.assign(size, value); }
  void push_back(const T& value) { values_.push_back(value); }
  auto begin() { return values_.begin(); }
  auto end() { return values_.end(); }
  auto begin() const { return values_.begin(); }
  auto end() const { return values_.end(); }

private:
  std::vector<T> values_;
};

struct OnNodes;
struct OnCells;
template <class T>
using NodeField = Field<OnNodes, T>;
template <class T>
using CellField = Field<OnCells, T>;

}  // namespace berm
