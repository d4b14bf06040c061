// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/driven/known_names.hpp"
#include "structures/structures.hpp"

#include <algorithm>

namespace berm {

/// Whether its structure knows, before a run, that a case may have a key result of this name.
inline bool knows(const settings::Case& c, const std::string& name)
{
  const std::vector<std::string> names = structures::structure_of(c).quantity_names(c);
  return std::find(names.begin(), names.end(), driven::without_number(name)) != names.end();
}

/// The key results of a run that its structure did not know before it.
inline std::vector<std::string> surprises_of(const record::RunRecord& run)
{
  std::vector<std::string> surprises;
  for (const run_folder::Quantity& q : run.quantities)
    if (!knows(run.settings, q.name)) surprises.push_back(q.name);
  return surprises;
}

}  // namespace berm
