// SPDX-License-Identifier: BSD-3-Clause
#include "start/soils.hpp"

#include "input/message_text.hpp"
#include "os/error.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::start {

std::vector<std::string> soils_for(const Kind& kind)
{
  std::vector<std::string> names;
  for (const Soil& soil : soils())
    if (table_of(kind.text, soil.material).begin != std::string::npos) names.push_back(soil.name);
  return names;
}

std::string with_soil(const Kind& kind, const std::string& text, const std::string& soil)
{
  const std::vector<std::string> names = soils_for(kind);
  if (names.empty()) throw InputError(fmt::format("--soil: {} takes no soil by name; change its materials in the file", kind.name));
  for (const Soil& one : soils()) {
    if (one.name != soil || std::find(names.begin(), names.end(), soil) == names.end()) continue;
    const Table table = table_of(text, one.material);
    const std::string written =
        fmt::format("[material.{}]\n# {}\n# {}\n# {}\n{}", one.material, one.title, one.source, one.trust, one.keys);
    return text.substr(0, table.begin) + written + text.substr(table.end);
  }
  throw InputError(fmt::format("--soil: {} takes no soil {}{}", kind.name, input::in_quotes(soil), input::suggestion(soil, names)));
}

Table table_of(const std::string& text, const std::string& material)
{
  const std::size_t found = text.find(fmt::format("\n[material.{}]\n", material));
  if (found == std::string::npos) return {};
  return {found + 1, text.find("\n\n", found) + 1};
}

}  // namespace berm::start
