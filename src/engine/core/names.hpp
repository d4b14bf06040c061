// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/describe.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <string>
#include <vector>

namespace berm {

/// The names of tables, in their order.
template <class T>
std::vector<std::string> names_of(const std::vector<std::pair<std::string, T>>& tables)
{
  std::vector<std::string> names;
  for (const auto& entry : tables) names.push_back(entry.first);
  return names;
}

inline bool among(const std::string& word, const std::vector<std::string>& words)
{
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// Whether what names these stages acts in a stage: none named are all.
inline bool acts_in(const std::vector<std::string>& stages, const std::string& stage)
{
  return stages.empty() || among(stage, stages);
}

/// Refuses the name of a table that there is not.
inline void check_name(Describe& d, const std::string& path, const std::string& word, const char* table,
                       const std::vector<std::string>& known)
{
  d.check(among(word, known), path, fmt::format("there is no [{}.{}]", table, word), known);
}

/// The index of the table of that name, or none.
template <class T>
Index index_of(const std::vector<std::pair<std::string, T>>& tables, const std::string& name)
{
  for (Index k = 0; k < static_cast<Index>(tables.size()); ++k)
    if (tables[k].first == name) return k;
  return none;
}

}  // namespace berm
