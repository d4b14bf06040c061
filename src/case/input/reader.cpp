// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/input/read_case_wrong_inputs_test.cpp
#include "input/reader.hpp"

#include "input/message_text.hpp"
#include "input/override.hpp"
#include "input/units.hpp"
#include "input/value_reader.hpp"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>

namespace berm::input {
namespace {

void use(Node& node)
{
  node.used = true;
  for (Node& item : node.items) use(item);
}

constexpr std::size_t max_in_name = 100;  // bytes

/// Names become parts of paths and columns of files.
bool is_name(const std::string& name)
{
  const auto fits = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || (c & 0x80) != 0; };
  return !name.empty() && name.size() <= max_in_name && std::all_of(name.begin(), name.end(), fits);
}

/// The expected value, after its meaning.
std::string hint(const Describe::Leaf& variable, const Parameter& parameter)
{
  const bool number = std::holds_alternative<Real*>(variable) || std::holds_alternative<std::optional<Real>*>(variable);
  const bool numbers = std::holds_alternative<std::vector<Real>*>(variable);
  if (!number && !numbers) return parameter.meaning;
  return fmt::format("{}: {}{}", parameter.meaning, numbers ? "a list of numbers, each " : "", wanted(parameter.unit));
}

/// The word in a value, or in its list, that is not allowed; else the last key of the path.
std::string wrong_word(const Found& found, const std::vector<std::string>& allowed)
{
  if (!found.whole) return "";
  if (found.node->kind == Node::Kind::text) return found.node->text;
  for (const Node& item : found.node->items)
    if (item.kind == Node::Kind::text && std::find(allowed.begin(), allowed.end(), item.text) == allowed.end()) return item.text;
  return found.last;
}

}  // namespace

Reader::Reader(Document& document) : document_(document)
{
  document.root.used = true;
  const Node* geometry = member(document.root, "geometry");
  whole_ = geometry != nullptr && geometry->kind == Node::Kind::text && (geometry->text == "space" || geometry->text == "axisymmetric");
  levels_.push_back({&document.root, &document.root, ""});
}

void Reader::check(bool valid, const std::string& path, const std::string& message, const std::vector<std::string>& allowed)
{
  if (valid) return;
  const Found found = follow(document_.root, path);
  refuse(document_, *found.node, found.path, message, wrong_word(found, allowed), allowed);
}

Node* Reader::find(const char* key)
{
  return levels_.back().table == nullptr ? nullptr : member(*levels_.back().table, key);
}

std::string Reader::path_of(const std::string& key) const
{
  const std::string& path = levels_.back().path;
  return path.empty() ? key : path + "." + key;
}

void Reader::refuse_missing(const char* key, const std::string& what, const std::vector<std::string>& words) const
{
  const Level& level = levels_.back();
  const std::string where = level.path.empty() ? "at the top of the file" : fmt::format("in [{}]", level.path);
  refuse(document_, *level.nearest, path_of(key), fmt::format("is missing {}: {}", where, what), "", words);
}

void Reader::leaf(const char* key, Leaf variable, const Parameter& declared)
{
  Parameter parameter = declared;
  if (whole_) parameter.unit = unit_of_whole(declared.unit);
  Node* node = find(key);
  if (node == nullptr) {
    if (parameter.required) refuse_missing(key, hint(variable, parameter));
    return;
  }
  use(*node);
  std::visit(ValueReader(document_, *node, path_of(key), parameter), variable);
}

int Reader::choose(const char* key, const std::vector<const char*>& names, int current, const Parameter& parameter)
{
  const std::vector<std::string> words(names.begin(), names.end());
  Node* node = find(key);
  if (node == nullptr) {
    if (parameter.required) refuse_missing(key, parameter.meaning, words);
    return current;
  }
  use(*node);
  if (node->kind != Node::Kind::text)
    refuse(document_, *node, path_of(key), fmt::format("must be a word in quotes, not {}", kind_of(*node)), "", words);
  const auto found = std::find(words.begin(), words.end(), node->text);
  if (found == words.end())
    refuse(document_, *node, path_of(key), fmt::format("{} is not one of its words", in_quotes(node->text)), node->text, words);
  return static_cast<int>(found - words.begin());
}

void Reader::step_into(Node* table, const std::string& path)
{
  const Node* nearest = table == nullptr ? levels_.back().nearest : table;
  if (table != nullptr) table->used = true;
  levels_.push_back({table, nearest, path});
}

void Reader::enter(const char* key, const Parameter& parameter)
{
  Node* node = find(key);
  const std::string path = path_of(key);
  if (node == nullptr && parameter.required)
    refuse(document_, *levels_.back().nearest, path, fmt::format("the table [{}] is missing: {}", path, parameter.meaning));
  if (node != nullptr && node->kind != Node::Kind::table)
    refuse(document_, *node, path, fmt::format("must be a table, [{}], not {}", path, kind_of(*node)));
  step_into(node, path);
}

bool Reader::has_table(const char* key, bool present)
{
  return present || find(key) != nullptr;
}

std::vector<std::string> Reader::names_in(const char* key, const std::vector<std::string>& present, const Parameter& parameter)
{
  Node* node = find(key);
  const std::string path = path_of(key);
  std::vector<std::string> names = present;
  if (node != nullptr) {
    if (node->kind != Node::Kind::table)
      refuse(document_, *node, path, fmt::format("must be tables with names, [{}.NAME], not {}", path, kind_of(*node)));
    node->used = true;
    for (const Node& item : node->items) {
      if (item.kind != Node::Kind::table)
        refuse(document_, item, path + "." + item.key, fmt::format("must be in a table with a name, [{}.NAME]", path));
      if (!is_name(item.key))
        refuse(document_, item, path + "." + item.key,
               fmt::format("{} is not a valid name; allowed are letters, digits, _ and -, from one to {} of them", in_quotes(item.key),
                           max_in_name));
      if (std::find(names.begin(), names.end(), item.key) == names.end()) names.push_back(item.key);
    }
  }
  if (names.empty() && parameter.required)
    refuse(document_, *levels_.back().nearest, path, fmt::format("at least one table [{}.NAME] is needed: {}", path, parameter.meaning));
  return names;
}

void Reader::enter_named(const char* key, const std::string& name)
{
  Node* tables = find(key);
  step_into(tables == nullptr ? nullptr : member(*tables, name), path_of(key) + "." + name);
}

int Reader::count_in(const char* key, int present, const Parameter& parameter)
{
  Node* node = find(key);
  const std::string path = path_of(key);
  if (node != nullptr) {
    const auto is_table = [](const Node& item) { return item.kind == Node::Kind::table; };
    if (node->kind != Node::Kind::array || !std::all_of(node->items.begin(), node->items.end(), is_table))
      refuse(document_, *node, path, fmt::format("must be an array of tables, [[{}]], not {}", path, kind_of(*node)));
    node->used = true;
    present = static_cast<int>(node->items.size());
  }
  if (present == 0 && parameter.required)
    refuse(document_, node == nullptr ? *levels_.back().nearest : *node, path,
           fmt::format("at least one [[{}]] is needed: {}", path, parameter.meaning));
  return present;
}

void Reader::enter_item(const char* key, int item)
{
  Node* array = find(key);
  if (array == nullptr) return step_into(nullptr, fmt::format("{}[{}]", path_of(key), item));
  step_into(&array->items[item], item_path(path_of(key), array->items[item], item));
}

}  // namespace berm::input
