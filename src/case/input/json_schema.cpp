// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/input/json_schema_test.cpp
#include "input/catalogue.hpp"

#include "input/message_text.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <nlohmann/json.hpp>

namespace berm::input {
namespace {

using Json = nlohmann::ordered_json;
using Chosen = std::map<std::string, std::string>;  // the words of selectors

Json schema_of(const Listed& entry);

std::string described(const Listed& entry)
{
  std::string text = entry.meaning;
  const auto add = [&](const std::string& what, const std::string& words) {
    if (!words.empty()) text += fmt::format("\n\n{}: {}", what, words);
  };
  add("unit", entry.unit);
  add("values", range_text(entry.range, entry.unit));
  add("default", entry.default_text);
  return text;
}

/// A number, or a text that is one with a unit behind it, if any, or a word.
Json number_schema(const Listed& entry)
{
  std::string pattern = R"(^\s*[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?(\s*[^\d\s.,].*|\s+1/.*|\s*)$)";
  for (const std::string& word : entry.number_words) pattern += "|^" + word + "$";
  Json number = Json::object({{"type", Json::array({"number", "string"})}, {"pattern", pattern}});
  const Range& range = entry.range;
  if (range.min > -infinity) number["minimum"] = range.min;
  if (range.min > -infinity && range.min_open) number["exclusiveMinimum"] = true;
  if (range.max < infinity) number["maximum"] = range.max;
  if (range.max < infinity && range.max_open) number["exclusiveMaximum"] = true;
  return number;
}

Json whole_number_schema(const Listed& entry)
{
  Json number = number_schema(entry);
  number["type"] = "integer";
  number.erase("pattern");
  return number;
}

Json by_name(Json of_each)
{
  return Json::object({{"type", "object"}, {"additionalProperties", std::move(of_each)}});
}

Json text_schema(bool empty_too)
{
  Json text = Json::object({{"type", "string"}});
  if (!empty_too) text["minLength"] = 1;
  return text;
}

Json list_schema(const Listed& entry, Json of_each)
{
  Json list = Json::object({{"type", "array"}, {"items", std::move(of_each)}});
  if (entry.required) list["minItems"] = 1;
  return list;
}

Json value_schema(const Listed& entry)
{
  switch (entry.type) {
  case Listed::Type::number:
    return number_schema(entry);
  case Listed::Type::whole_number:
    return whole_number_schema(entry);
  case Listed::Type::truth:
    return Json::object({{"type", "boolean"}});
  case Listed::Type::text:
    return text_schema(!entry.required);
  case Listed::Type::texts:
    return list_schema(entry, text_schema(false));
  case Listed::Type::numbers:
    return list_schema(entry, number_schema(entry));
  case Listed::Type::number_by_name:
    return by_name(number_schema(entry));
  case Listed::Type::whole_number_by_name:
    return by_name(whole_number_schema(entry));
  case Listed::Type::text_by_name:
    return by_name(text_schema(true));
  }
  return {};
}

bool applies(const Listed& entry, const Chosen& chosen)
{
  return std::ranges::all_of(entry.conditions, [&](const Condition& condition) {
    const auto found = chosen.find(condition.selector);
    return found != chosen.end() && found->second == condition.word;
  });
}

/// A key whose word selects others, and is not chosen yet; null where there is none.
const Listed* next_selector(const Listed& table, const Chosen& chosen)
{
  for (const Listed& entry : table.children)
    if (entry.kind == Listed::Kind::word && applies(entry, chosen) && !chosen.contains(entry.key))
      for (const Listed& other : table.children)
        if (std::ranges::find(other.conditions, entry.key, &Condition::selector) != other.conditions.end()) return &entry;
  return nullptr;
}

/// The keys that there are with these words. Of alternatives the words alone are required: what else an alternative needs may hang on values (a profile stands for a modulus),
/// which berm check knows.
Json keys_with(const Listed& table, const Chosen& chosen)
{
  Json keys = Json::object(), required = Json::array();
  std::string title;
  for (const Listed& entry : table.children) {
    if (!applies(entry, chosen)) continue;
    Json& schema = keys[entry.key] = schema_of(entry);
    bool is_required = entry.required && chosen.empty();
    if (const auto word = chosen.find(entry.key); word != chosen.end()) {
      title += fmt::format("{}{} = {}", title.empty() ? "" : ", ", word->first, in_quotes(word->second));
      schema["enum"] = Json::array({word->second});
      is_required = word->second != entry.default_text;
    }
    if (is_required) required.push_back(entry.key);
  }
  Json object = Json::object({{"type", "object"}});
  if (!title.empty()) object["title"] = title;
  if (!required.empty()) object["required"] = required;
  object["properties"] = std::move(keys);
  object["additionalProperties"] = false;
  return object;
}

void add_alternatives(const Listed& table, Chosen chosen, Json& all)
{
  const Listed* selector = next_selector(table, chosen);
  if (selector == nullptr) return all.push_back(keys_with(table, chosen));
  for (const std::string& word : selector->words) {
    chosen[selector->key] = word;
    add_alternatives(table, chosen, all);
  }
}

Json table_schema(const Listed& table)
{
  if (table.children.empty()) return by_name(text_schema(true));  // its keys are names
  Json all = Json::array();
  add_alternatives(table, {}, all);
  if (all.size() == 1) return all.front();
  return Json::object({{"type", "object"}, {"oneOf", std::move(all)}});
}

Json schema_of(const Listed& entry)
{
  Json schema;
  switch (entry.kind) {
  case Listed::Kind::value:
    schema = value_schema(entry);
    break;
  case Listed::Kind::word:
    schema = Json::object({{"type", "string"}, {"enum", entry.words}});
    break;
  case Listed::Kind::table:
    schema = table_schema(entry);
    break;
  case Listed::Kind::named_tables:
    schema = by_name(table_schema(entry));
    if (entry.required) schema["minProperties"] = 1;
    break;
  case Listed::Kind::array:
    schema = list_schema(entry, table_schema(entry));
    break;
  }
  if (const std::string text = described(entry); !text.empty()) schema["description"] = text;
  if (!entry.unit.empty()) schema["x-unit"] = entry.unit;
  std::visit(
      [&](const auto& value) {
        if constexpr (!std::is_same_v<std::decay_t<decltype(value)>, std::monostate>) schema["default"] = value;
      },
      entry.default_value);
  return schema;
}

}  // namespace

std::string json_schema(const Listed& of_input, const std::string& title)
{
  Json schema = Json::object({{"$schema", "http://json-schema.org/draft-04/schema#"}, {"title", title}});
  schema.update(table_schema(of_input));
  return schema.dump(1) + "\n";
}

}  // namespace berm::input
