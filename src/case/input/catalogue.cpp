// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/input/parameters_test.cpp
#include "input/catalogue.hpp"

#include "input/message_text.hpp"

#include <algorithm>

namespace berm::input {
namespace {

/// Fills in what depends on the type of a value.
struct TypeAndDefault {
  Listed& entry;

  using Type = Listed::Type;
  void number(Real value) const
  {
    entry.default_text = quantity(value, entry.unit);
    if (entry.unit.empty())
      entry.default_value = value;
    else
      entry.default_value = entry.default_text;
  }
  template <class T, class Words>
  void list(Type type, const std::vector<T>& values, const Words& words) const
  {
    entry.type = type;
    if (values.empty()) return;
    for (const T& value : values) entry.default_text += (entry.default_text.empty() ? "[" : ", ") + words(value);
    entry.default_text += "]";
    entry.default_value = values;
  }
  void operator()(const Real* v) const
  {
    entry.type = Type::number;
    number(*v);
  }
  void operator()(const std::optional<Real>* v) const
  {
    entry.type = Type::number;
    if (*v) number(**v);
  }
  void operator()(const int* v) const
  {
    entry.type = Type::whole_number;
    entry.default_value = *v;
    entry.default_text = std::to_string(*v);
  }
  void operator()(const bool* v) const
  {
    entry.type = Type::truth;
    entry.default_value = *v;
    entry.default_text = *v ? "true" : "false";
  }
  void operator()(const std::string* v) const
  {
    entry.type = Type::text;
    if (v->empty()) return;
    entry.default_value = *v;
    entry.default_text = in_quotes(*v);
  }
  void operator()(const std::vector<std::string>* v) const { list(Type::texts, *v, in_quotes); }
  void operator()(const std::vector<Real>* v) const
  {
    list(Type::numbers, *v, [&](Real value) { return quantity(value, entry.unit); });
  }
  void operator()(const std::map<std::string, Real>*) const { entry.type = Type::number_by_name; }
  void operator()(const std::map<std::string, int>*) const { entry.type = Type::whole_number_by_name; }
  void operator()(const std::map<std::string, std::string>*) const { entry.type = Type::text_by_name; }
};

const char* words_of(Listed::Type type)
{
  switch (type) {
  case Listed::Type::number:
    return "number";
  case Listed::Type::whole_number:
    return "whole number";
  case Listed::Type::truth:
    return "true or false";
  case Listed::Type::text:
    return "text";
  case Listed::Type::texts:
    return "list of texts";
  case Listed::Type::numbers:
    return "list of numbers";
  case Listed::Type::number_by_name:
    return "number by name";
  case Listed::Type::whole_number_by_name:
    return "whole number by name";
  case Listed::Type::text_by_name:
    return "text by name";
  }
  return "";
}

}  // namespace

std::string type_words(const Listed& entry)
{
  if (entry.kind == Listed::Kind::word) return "word";
  std::string words = words_of(entry.type);
  for (const std::string& word : entry.number_words) words += " or " + in_quotes(word);
  return words;
}

Listed& Lister::add(Listed::Kind kind, const char* key, const Parameter& parameter)
{
  Listed& entry = levels_.back().table->children.emplace_back();
  entry.kind = kind;
  entry.key = key;
  entry.meaning = parameter.meaning;
  entry.unit = parameter.unit;
  entry.range = parameter.range;
  entry.required = parameter.required;
  entry.conditions = levels_.back().conditions;
  return entry;
}

void Lister::leaf(const char* key, Leaf variable, const Parameter& parameter)
{
  Listed& entry = add(Listed::Kind::value, key, parameter);
  std::visit(TypeAndDefault{entry}, variable);
  for (const NumberWord& word : parameter.words) {
    entry.number_words.emplace_back(word.word);
    if (const auto* number = std::get_if<Real*>(&variable); number == nullptr || **number != word.value) continue;
    entry.default_text = in_quotes(word.word);
    entry.default_value = std::string(word.word);
  }
  if (!parameter.required) return;
  entry.default_text.clear();
  entry.default_value = std::monostate();
}

void Lister::usual(const UsualNumber& number)
{
  Listed* table = levels_.back().table;
  std::string_view key = number.key;
  for (std::size_t dot = key.find('.'); table != nullptr; dot = key.find('.')) {
    const std::string_view part = key.substr(0, dot);
    const auto entry = std::find_if(table->children.rbegin(), table->children.rend(), [&](const Listed& one) { return one.key == part; });
    if (entry == table->children.rend()) return;
    if (dot == std::string_view::npos) entry->usual = number.size;
    table = dot == std::string_view::npos ? nullptr : &*entry;
    key.remove_prefix(dot == std::string_view::npos ? key.size() : dot + 1);
  }
}

int Lister::choose(const char* key, const std::vector<const char*>& names, int current, const Parameter& parameter)
{
  Listed& entry = add(Listed::Kind::word, key, parameter);
  entry.words.assign(names.begin(), names.end());
  if (parameter.required) return current;
  entry.default_text = entry.words.at(current);
  entry.default_value = entry.default_text;
  return current;
}

void Lister::enter(const char* key, const Parameter& parameter)
{
  Listed& entry = add(Listed::Kind::table, key, parameter);
  levels_.push_back({&entry, {}});
}

std::vector<std::string> Lister::names_in(const char* key, const std::vector<std::string>&, const Parameter& parameter)
{
  add(Listed::Kind::named_tables, key, parameter);
  return {"NAME"};
}

void Lister::enter_named(const char*, const std::string&)
{
  levels_.push_back({&levels_.back().table->children.back(), {}});
}

int Lister::count_in(const char* key, int, const Parameter& parameter)
{
  add(Listed::Kind::array, key, parameter);
  return 1;
}

void Lister::enter_item(const char*, int)
{
  levels_.push_back({&levels_.back().table->children.back(), {}});
}

}  // namespace berm::input
