// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/field_info.hpp"

#include <algorithm>
#include <vector>

namespace berm::run_folder {

/// A field of points, with what is said of it: `info.components` numbers of each point, one point after the other.
template <class Number>
struct FieldValues {
  FieldInfo info;
  std::vector<Number> values;

  std::size_t place(std::size_t point, int component = 0) const { return point * static_cast<std::size_t>(info.components) + component; }
  Number& at(std::size_t point, int component = 0) { return values[place(point, component)]; }
  const Number& at(std::size_t point, int component = 0) const { return values[place(point, component)]; }
};

/// The field of that name; null where there is none.
template <class Number>
const FieldValues<Number>* find_field(const std::vector<FieldValues<Number>>& fields, const std::string& name)
{
  const auto found = std::find_if(fields.begin(), fields.end(), [&](const FieldValues<Number>& field) { return field.info.name == name; });
  return found == fields.end() ? nullptr : &*found;
}

}  // namespace berm::run_folder
