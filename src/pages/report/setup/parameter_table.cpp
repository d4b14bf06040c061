// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/report/setup/setup_section_test.cpp
#include "report/setup/setup_section.hpp"

#include "input/write_case.hpp"
#include "text/run_columns.hpp"

#include <fmt/format.h>

namespace berm::report {
namespace {

/// A value as people read it.
struct ToWords {
  bool angle;

  std::string operator()(std::monostate) const { return "not set"; }
  std::string operator()(Real v) const { return angle ? fmt::format("{:.9g} ({:.9g}°)", v, v * 180 / pi) : fmt::format("{:.9g}", v); }
  std::string operator()(int v) const { return fmt::format("{}", v); }
  std::string operator()(bool v) const { return v ? "yes" : "no"; }
  std::string operator()(const std::string& v) const { return v; }
  template <class T>
  std::string operator()(const std::vector<T>& v) const
  {
    std::string text;
    for (const T& item : v) text += (text.empty() ? "" : ", ") + (*this)(item);
    return text;
  }
  template <class T>
  std::string operator()(const std::map<std::string, T>& v) const
  {
    std::string text;
    for (const auto& [key, item] : v) text += (text.empty() ? "" : ", ") + key + " = " + (*this)(item);
    return text;
  }
};

/// The name that an item of an array has among its own settings.
std::string name_in(const input::SettingTable& table)
{
  for (const input::Setting& setting : table.settings)
    if (const auto* name = std::get_if<std::string>(&setting.value); name != nullptr && setting.key == "name") return *name;
  return "";
}

void collect(const input::SettingTable& table, const std::string& path, std::vector<ParameterEntry>& entries)
{
  const std::string before = path.empty() ? "" : path + ".";
  for (const input::Setting& setting : table.settings)
    entries.push_back({before + setting.key, std::visit(ToWords{setting.unit == "rad"}, setting.value), setting.unit, setting.meaning});
  std::map<std::string, int> items;  // of each array
  for (const input::SettingTable& inner : table.tables) {
    const std::string key = table.path.empty() ? inner.path : inner.path.substr(table.path.size() + 1);
    const std::string name = name_in(inner);
    collect(inner, before + key + (!inner.item ? "" : name.empty() ? fmt::format("[{}]", items[key]) : "." + name), entries);
    if (inner.item) ++items[key];
  }
}

}  // namespace

std::vector<ParameterEntry> parameters_of(const settings::Case& settings)
{
  std::vector<ParameterEntry> entries;
  collect(input::all_settings(settings), "", entries);
  return entries;
}

text::HtmlTable parameter_columns(const std::vector<record::RunRecord>& runs)
{
  text::RunColumns columns("key", "unit", "meaning");
  for (const record::RunRecord& run : runs) {
    std::vector<text::RunEntry> entries;
    for (const ParameterEntry& parameter : parameters_of(run.settings))
      entries.push_back({parameter.path, fmt::format("<code>{}</code>", text::html_text(parameter.path)), text::html_text(parameter.value),
                         true, text::html_text(parameter.unit), text::html_text(parameter.meaning)});
    columns.run(run.name, entries);
  }
  return columns.table("parameters", "Every parameter, defaults included");
}

}  // namespace berm::report
