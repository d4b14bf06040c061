// SPDX-License-Identifier: BSD-3-Clause
#include "input/write_case.hpp"

#include "input/document.hpp"
#include "input/units.hpp"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>

namespace berm::input {
namespace {

std::string toml_text(const std::string& text)
{
  std::string escaped = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\')
      escaped += std::string("\\") + c;
    else if (byte < 0x20 || byte == 0x7F)
      escaped += fmt::format("\\u{:04X}", byte);
    else
      escaped += c;
  }
  return escaped + "\"";
}

std::string toml_key(const std::string& key)
{
  const auto bare = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-'; };
  return !key.empty() && std::all_of(key.begin(), key.end(), bare) ? key : toml_text(key);
}

/// The shortest decimal number that reads back as the same double.
std::string toml_number(Real value)
{
  return value == 0 && std::signbit(value) ? "-0.0" : fmt::format("{}", value);
}

template <class Items, class ToText>
std::string enclosed(const char* begin, const Items& items, const char* end, const ToText& to_text)
{
  std::string text = begin;
  for (const auto& item : items) text += (text.size() == 1 ? "" : ", ") + to_text(item);
  return text + end;
}

/// The TOML of a value; "" for one that is left out.
struct ToToml {
  std::string operator()(std::monostate) const { return ""; }
  std::string operator()(Real v) const { return toml_number(v); }
  std::string operator()(int v) const { return std::to_string(v); }
  std::string operator()(bool v) const { return v ? "true" : "false"; }
  std::string operator()(const std::string& v) const { return toml_text(v); }
  std::string operator()(const std::vector<std::string>& v) const { return enclosed("[", v, "]", toml_text); }
  std::string operator()(const std::vector<Real>& v) const { return enclosed("[", v, "]", toml_number); }
  std::string operator()(const std::map<std::string, Real>& v) const
  {
    return enclosed("{", v, "}", [](const auto& e) { return toml_key(e.first) + " = " + toml_number(e.second); });
  }
  std::string operator()(const std::map<std::string, int>& v) const
  {
    return enclosed("{", v, "}", [](const auto& e) { return toml_key(e.first) + " = " + std::to_string(e.second); });
  }
  std::string operator()(const std::map<std::string, std::string>& v) const
  {
    return enclosed("{", v, "}", [](const auto& e) { return toml_key(e.first) + " = " + toml_text(e.second); });
  }
};

/// The value of a variable; nothing where it is not set.
struct ToSetting {
  SettingValue operator()(const Real* v) const { return std::isfinite(*v) ? SettingValue(*v) : SettingValue(); }
  SettingValue operator()(const std::optional<Real>* v) const { return *v ? SettingValue(**v) : SettingValue(); }
  SettingValue operator()(const int* v) const { return *v; }
  SettingValue operator()(const bool* v) const { return *v; }
  template <class T>
  SettingValue operator()(const T* v) const
  {
    return v->empty() ? SettingValue() : SettingValue(*v);
  }
};

void write(const SettingTable& table, std::string& text)
{
  struct Line {
    std::string setting, comment;
  };
  std::vector<Line> lines;
  for (const auto& [key, value, unit, meaning] : table.settings) {
    const std::string toml = std::visit(ToToml{}, value);
    lines.push_back({toml.empty() ? fmt::format("# {} is not set", key) : fmt::format("{} = {}", key, toml),
                     unit.empty() ? meaning : fmt::format("[{}] {}", unit, meaning)});
  }
  if (!table.path.empty()) text += table.item ? fmt::format("\n[[{}]]\n", table.path) : fmt::format("\n[{}]\n", table.path);
  std::size_t width = 0;
  constexpr std::size_t widest = 60;
  for (const Line& line : lines) width = std::max(width, std::min(line.setting.size(), widest));
  for (const Line& line : lines) text += fmt::format("{:<{}}  # {}\n", line.setting, width, line.comment);
  for (const SettingTable& inner : table.tables) write(inner, text);
}

}  // namespace

void SettingVisitor::leaf(const char* key, Leaf variable, const Parameter& parameter)
{
  const char* unit = whole_ ? unit_of_whole(parameter.unit) : parameter.unit;
  SettingValue value = std::visit(ToSetting{}, variable);
  if (const auto* number = std::get_if<Real*>(&variable))
    for (const NumberWord& word : parameter.words)
      if (**number == word.value) value = std::string(word.word);
  open_.back()->settings.push_back({key, value, unit, parameter.meaning});
}

int SettingVisitor::choose(const char* key, const std::vector<const char*>& names, int current, const Parameter& parameter)
{
  open_.back()->settings.push_back({key, std::string(names.at(current)), "", parameter.meaning});
  return current;
}

SettingTable& SettingVisitor::open(const std::string& key)
{
  SettingTable& outer = *open_.back();
  SettingTable& table = outer.tables.emplace_back();
  table.path = (outer.path.empty() ? "" : outer.path + ".") + key;
  open_.push_back(&table);
  return table;
}

void SettingVisitor::enter(const char* key, const Parameter&)
{
  open(toml_key(key));
}

void SettingVisitor::enter_named(const char* key, const std::string& name)
{
  open(toml_key(key) + "." + toml_key(name));
}

void SettingVisitor::enter_item(const char* key, int)
{
  open(toml_key(key)).item = true;
}

std::string toml_of(const SettingTable& table)
{
  std::string text;
  write(table, text);
  return text;
}

SettingTable all_settings(const settings::Case& settings)
{
  settings::Case copy = settings;
  SettingVisitor visitor(settings.force_dimension() == 3);
  describe(visitor, copy);
  return visitor.root();
}

std::string resolved_toml(const settings::Case& settings)
{
  return std::string(resolved_heading) + toml_of(all_settings(settings));
}

std::string_view without_report(std::string_view resolved)
{
  return resolved.substr(0, resolved.find("\n[report]\n"));
}

}  // namespace berm::input
