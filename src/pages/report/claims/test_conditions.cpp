// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/report/claims/claim_sheet_test.cpp
#include "report/claims/test_conditions.hpp"

#include "input/catalogue.hpp"
#include "input/message_text.hpp"
#include "input/value_reader.hpp"
#include "input/write_case.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::report {
namespace {

using input::Listed;
using input::Setting;
using input::SettingTable;

const Listed& parameters_of_cases()
{
  static const Listed all = input::catalogue_of<problem::Case>();
  return all;
}

/// "material", "*", "density".
std::vector<std::string> keys_of(const std::string& path)
{
  std::vector<std::string> keys = {""};
  for (const char c : path) c == '.' ? static_cast<void>(keys.emplace_back()) : static_cast<void>(keys.back() += c);
  return keys;
}

bool is_parameter(const Listed& entry)
{
  return entry.kind == Listed::Kind::value || entry.kind == Listed::Kind::word;
}

/// Follows a path through the declared parameters; null, and `known` are the keys that would do, where it leads nowhere.
const Listed* find_parameter(const std::string& path, std::vector<std::string>& known)
{
  std::vector<const Listed*> tables = {&parameters_of_cases()};  // several where alternatives have tables of one key
  const std::vector<std::string> keys = keys_of(path);
  for (std::size_t k = 0; k < keys.size(); ++k) {
    std::vector<const Listed*> next;
    known.clear();
    for (const Listed* table : tables)
      for (const Listed& entry : table->children) {
        known.push_back(entry.key);
        if (entry.key == keys[k]) next.push_back(&entry);
      }
    if (next.empty()) return nullptr;
    if (k + 1 == keys.size()) return is_parameter(*next.front()) ? next.front() : nullptr;
    const bool named = next.front()->kind == Listed::Kind::named_tables || next.front()->kind == Listed::Kind::array;
    if (named && ++k + 1 >= keys.size()) return nullptr;
    tables = next;
  }
  return nullptr;
}

const Listed& parameter_at(const input::Document& document, const input::Node& node, const std::string& at, const std::string& path)
{
  std::vector<std::string> known;
  const Listed* found = find_parameter(path, known);
  if (found == nullptr)
    refuse(document, node, at,
           fmt::format("{} is no parameter of a case, such as \"material.*.density\"{}", input::in_quotes(path),
                       input::suggestion(path.substr(path.find_last_of('.') + 1), known)));
  return *found;
}

TestCondition condition_of(const input::Document& document, input::Node& node, const std::string& at, const std::string& path)
{
  const Listed& parameter = parameter_at(document, node, at, path);
  TestCondition condition{path, {}, ""};
  if (parameter.type.ends_with("by name") || parameter.type == "list of texts")
    refuse(document, node, at, fmt::format("is a {}; only numbers, words and lists of numbers can be compared", parameter.type));
  if (parameter.kind == Listed::Kind::word || parameter.type == "text") {
    if (node.kind != input::Node::Kind::text) refuse(document, node, at, fmt::format("must be a word in quotes, not {}", kind_of(node)));
    if (!parameter.words.empty() && std::find(parameter.words.begin(), parameter.words.end(), node.text) == parameter.words.end())
      refuse(document, node, at,
             fmt::format("{} is not one of its words{}", input::in_quotes(node.text), input::suggestion(node.text, parameter.words)));
    condition.word = node.text;
    return condition;
  }
  if (node.kind == input::Node::Kind::boolean)
    condition.word = node.truth ? "true" : "false";
  else
    input::ValueReader(document, node, at, {.meaning = "", .unit = parameter.unit.c_str()})(&condition.number);
  return condition;
}

void take(const input::Document& document, input::Node& table, const std::string& at, const std::string& path,
          std::vector<TestCondition>& conditions)
{
  for (input::Node& item : table.items) {
    const std::string inner = path.empty() ? item.key : path + "." + item.key, place = at + "." + item.key;
    if (item.kind == input::Node::Kind::table)
      take(document, item, place, inner, conditions);
    else
      conditions.push_back(condition_of(document, item, place, inner));
  }
}

/// A table of a case, addressed with its name: an item of an array by its number, which * stands for as well.
struct PlacedTable {
  std::vector<std::string> keys;
  const SettingTable* table;
};

void place_tables(const SettingTable& table, std::vector<PlacedTable>& all)
{
  std::vector<std::string> keys = table.path.empty() ? std::vector<std::string>{} : keys_of(table.path);
  if (table.item) {
    const auto named = std::find_if(table.settings.begin(), table.settings.end(), [](const Setting& s) { return s.key == "name"; });
    const auto* name = named == table.settings.end() ? nullptr : std::get_if<std::string>(&named->value);
    keys.push_back(name == nullptr ? "" : *name);
  }
  all.push_back({keys, &table});
  for (const SettingTable& inner : table.tables) place_tables(inner, all);
}

bool fits(const std::vector<std::string>& pattern, const std::vector<std::string>& keys)
{
  return std::equal(pattern.begin(), pattern.end(), keys.begin(), keys.end(),
                    [](const std::string& wanted, const std::string& key) { return wanted == "*" || wanted == key; });
}

bool is_met(const TestCondition& condition, Real tolerance, const SettingTable& table)
{
  const std::string key = keys_of(condition.path).back();
  const auto setting = std::find_if(table.settings.begin(), table.settings.end(), [&](const Setting& s) { return s.key == key; });
  if (setting == table.settings.end()) return false;
  const input::SettingValue& value = setting->value;
  if (const auto* word = std::get_if<std::string>(&value)) return *word == condition.word;
  if (const auto* truth = std::get_if<bool>(&value)) return condition.word == (*truth ? "true" : "false");
  if (!condition.number) return false;
  Real number = nan;
  if (const auto* real = std::get_if<Real>(&value)) number = *real;
  if (const auto* whole = std::get_if<int>(&value)) number = *whole;
  if (const auto* list = std::get_if<std::vector<Real>>(&value)) {
    number = 0;
    for (const Real part : *list) number = std::hypot(number, part);
  }
  return std::abs(number - *condition.number) <= tolerance * std::abs(*condition.number);
}

std::vector<PlacedTable> tables_of(const SettingTable& root, const std::string& pattern)
{
  std::vector<PlacedTable> all, found;
  place_tables(root, all);
  std::vector<std::string> keys = keys_of(pattern);
  keys.pop_back();
  std::copy_if(all.begin(), all.end(), std::back_inserter(found), [&](const PlacedTable& placed) { return fits(keys, placed.keys); });
  return found;
}

}  // namespace

void refuse_unknown_parameter(const input::Document& document, const input::Node& node, const std::string& at, const std::string& path)
{
  parameter_at(document, node, at, path);
}

std::vector<TestCondition> take_conditions(const input::Document& document, input::Node& table, const std::string& path,
                                           const std::vector<std::string>& kept)
{
  input::Node taken = table;
  const auto stays = [&](const input::Node& item) { return std::find(kept.begin(), kept.end(), item.key) != kept.end(); };
  std::erase_if(taken.items, stays);
  std::erase_if(table.items, [&](const input::Node& item) { return !stays(item); });
  std::vector<TestCondition> conditions;
  take(document, taken, path, "", conditions);
  return conditions;
}

bool meets(const problem::Case& settings, const TestConditions& conditions)
{
  const SettingTable root = input::all_settings(settings);
  return std::all_of(conditions.all.begin(), conditions.all.end(), [&](const TestCondition& first) {
    // All conditions on the same kind of table, for one table of it.
    const std::string of = first.path.substr(0, first.path.find_last_of('.') + 1);
    const auto same_kind = [&](const TestCondition& c) { return c.path.substr(0, c.path.find_last_of('.') + 1) == of; };
    const std::vector<PlacedTable> tables = tables_of(root, first.path);
    return std::any_of(tables.begin(), tables.end(), [&](const PlacedTable& placed) {
      return std::all_of(conditions.all.begin(), conditions.all.end(),
                         [&](const TestCondition& c) { return !same_kind(c) || is_met(c, conditions.tolerance, *placed.table); });
    });
  });
}

std::string values_of(const problem::Case& settings, const std::string& path)
{
  const SettingTable root = input::all_settings(settings);
  std::string text;
  for (const PlacedTable& placed : tables_of(root, path)) {
    SettingTable one;
    for (const Setting& setting : placed.table->settings)
      if (setting.key == keys_of(path).back()) one.settings.push_back(setting);
    text += toml_of(one);
  }
  return text;
}

}  // namespace berm::report
