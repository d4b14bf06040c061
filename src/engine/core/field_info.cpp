// SPDX-License-Identifier: BSD-3-Clause
#include "core/field_info.hpp"

namespace berm {

std::string component_name(const FieldInfo& field, int component, int dim)
{
  constexpr const char* directions[3] = {"x", "y", "z"};
  constexpr const char* pairs[6] = {"xx", "yy", "zz", "xy", "yz", "zx"};
  if (field.components == 1) return field.name;
  const bool vector = field.components == dim, tensor = field.components == (dim == 2 ? 4 : 6);
  return field.name + '_' + (vector ? directions[component] : tensor ? pairs[component] : std::to_string(component));
}

}  // namespace berm
