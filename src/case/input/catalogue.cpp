// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/input/parameters_test.cpp
#include "input/catalogue.hpp"

#include "input/message_text.hpp"

#include <fmt/format.h>

namespace berm::input {
namespace {

struct TypeAndDefault {
  const std::string& unit;

  using Pair = std::pair<std::string, std::string>;
  Pair operator()(const Real* v) const { return {"number", quantity(*v, unit)}; }
  Pair operator()(const std::optional<Real>* v) const { return {"number", *v ? quantity(**v, unit) : ""}; }
  Pair operator()(const int* v) const { return {"whole number", std::to_string(*v)}; }
  Pair operator()(const bool* v) const { return {"true or false", *v ? "true" : "false"}; }
  Pair operator()(const std::string* v) const { return {"text", v->empty() ? "" : in_quotes(*v)}; }
  Pair operator()(const std::vector<std::string>* v) const
  {
    std::string all;
    for (const std::string& text : *v) all += (all.empty() ? "" : ", ") + in_quotes(text);
    return {"list of texts", all.empty() ? "" : "[" + all + "]"};
  }
  Pair operator()(const std::vector<Real>* v) const
  {
    std::string all;
    for (const Real number : *v) all += (all.empty() ? "" : ", ") + quantity(number, unit);
    return {"list of numbers", all.empty() ? "" : "[" + all + "]"};
  }
  Pair operator()(const std::map<std::string, Real>*) const { return {"number by name", ""}; }
  Pair operator()(const std::map<std::string, int>*) const { return {"whole number by name", ""}; }
  Pair operator()(const std::map<std::string, std::string>*) const { return {"text by name", ""}; }
};

}  // namespace

Listed& Lister::add(Listed::Kind kind, const char* key, const Parameter& parameter)
{
  Listed& entry = levels_.back().table->children.emplace_back();
  entry.kind = kind;
  entry.key = key;
  entry.formerly = parameter.formerly;
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
  std::tie(entry.type, entry.default_text) = std::visit(TypeAndDefault{entry.unit}, variable);
  for (const NumberWord& word : parameter.words) {
    entry.type += fmt::format(" or {}", in_quotes(word.word));
    if (const auto* number = std::get_if<Real*>(&variable); number != nullptr && **number == word.value)
      entry.default_text = in_quotes(word.word);
  }
  if (parameter.required) entry.default_text.clear();
}

int Lister::choose(const char* key, const std::vector<const char*>& names, int current, const Parameter& parameter)
{
  Listed& entry = add(Listed::Kind::word, key, parameter);
  entry.type = "word";
  entry.words.assign(names.begin(), names.end());
  if (!parameter.required) entry.default_text = entry.words.at(current);
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
