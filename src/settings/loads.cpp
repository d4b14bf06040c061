// SPDX-License-Identifier: BSD-3-Clause
#include "settings/loads.hpp"

#include <algorithm>
#include <stdexcept>
#include <string_view>

namespace berm::settings {
namespace {

std::size_t index_of_key(std::string_view key)
{
  for (std::size_t k = 0; k < load_columns.size(); ++k)
    if (load_columns[k].key == key) return k;
  throw std::out_of_range("no column of a load history");
}

}  // namespace

bool is_driven_by(LoadAlong along, LoadAlong column)
{
  return column == along || (column == LoadAlong::water && (along == LoadAlong::horizontal || along == LoadAlong::downwards));
}

bool LoadSettings::empty() const
{
  return std::all_of(columns.begin(), columns.end(), [](const auto& column) { return column.empty(); });
}

bool LoadSettings::has_force() const
{
  for (std::size_t k = 0; k < columns.size(); ++k)
    if (const LoadQuantity of = load_columns[k].quantity; (of == LoadQuantity::force || of == LoadQuantity::water) && !columns[k].empty())
      return true;
  return false;
}

bool LoadSettings::drives(LoadAlong along) const
{
  for (std::size_t k = 0; k < columns.size(); ++k)
    if (is_driven_by(along, load_columns[k].along) && !columns[k].empty()) return true;
  return false;
}

const std::vector<Real>& LoadSettings::of(const char* key) const
{
  return columns[index_of_key(key)];
}

std::vector<Real>& LoadSettings::of(const char* key)
{
  return columns[index_of_key(key)];
}

void describe(Describe& d, LoadSettings& loads)
{
  for (std::size_t k = 0; k < load_columns.size(); ++k)
    d.value(load_columns[k].key, loads.columns[k], {.meaning = load_columns[k].meaning, .unit = load_columns[k].unit});
}

}  // namespace berm::settings
