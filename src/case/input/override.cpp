// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/input/parameters_test.cpp
#include "input/override.hpp"

#include "input/message_text.hpp"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>

namespace berm::input {
namespace {

[[noreturn]] void refuse_override(const std::string& key, const std::string& message, const std::string& word = "",
                                  const std::vector<std::string>& allowed = {})
{
  throw LocatedError({.override_key = key, .key = key, .message = message, .word = word, .allowed = allowed});
}

/// The parts of a dotted path; a part in double quotes may hold dots.
std::vector<std::string> split(const std::string& key)
{
  std::vector<std::string> parts(1);
  bool inside = false;
  for (const char c : key) {
    if (c == '"')
      inside = !inside;
    else if (c == '.' && !inside)
      parts.emplace_back();
    else
      parts.back() += c;
  }
  for (const std::string& part : parts)
    if (part.empty()) refuse_override(key, "the key has an empty part; expected a path such as material.sand.friction_angle");
  if (inside) refuse_override(key, "a quote is not closed");
  constexpr std::size_t max_parts = 32;
  if (parts.size() > max_parts) refuse_override(key, "the key has too many parts");
  return parts;
}

Node value_of(const std::string& key, const std::string& text)
{
  if (std::optional<Node> value = parse_value(text)) return *value;
  if (!text.empty() && std::string("[{\"'").find(text[0]) != std::string::npos)
    refuse_override(key, in_quotes(text) + " is not valid TOML; is it in single quotes, to save its own quotes from the shell?");
  Node value;
  value.kind = Node::Kind::text;
  value.text = text;
  return value;
}

void mark(Node& node, const std::string& key)
{
  node.override_key = key;
  for (Node& item : node.items) mark(item, key);
}

/// The item of an array of tables whose name is `part`.
Node& item_named(Node& array, const std::string& part, const std::string& path, const std::string& key)
{
  std::vector<std::string> names;
  for (Node& item : array.items) {
    names.push_back(name_of(item));
    if (names.back() == part) return item;
  }
  refuse_override(key, fmt::format("there is no {} named {}", path, in_quotes(part)), part, names);
}

/// Puts one value into the tables of a document.
class Override {
public:
  Override(const std::string& key, const Node& value) : key_(key), parts_(split(key)), value_(value) { mark(value_, key); }

  void put_into(Node& root) const { put(root, 0, ""); }

private:
  void put(Node& at, std::size_t k, const std::string& path) const
  {
    if (k == parts_.size()) {
      Node value = value_;
      value.key = at.key;
      value.line = at.line;
      value.column = at.column;
      at = std::move(value);
      return;
    }
    const std::string& part = parts_[k];
    const std::string inner = path.empty() ? part : path + "." + part;
    const bool tables_in_a_row = at.kind == Node::Kind::array && !at.items.empty() && at.items[0].kind == Node::Kind::table;
    if (part == "*" && (tables_in_a_row || at.kind == Node::Kind::table)) return put_into_all(at, k, path);
    if (tables_in_a_row) return put(item_named(at, part, path, key_), k + 1, inner);
    if (at.kind != Node::Kind::table) refuse_override(key_, fmt::format("{} is {}, which has no {}", path, kind_of(at), in_quotes(part)));
    Node* next = member(at, part);
    if (next == nullptr) {
      next = &at.items.emplace_back();
      next->key = part;
      next->override_key = key_;
      next->implied = k + 1 < parts_.size();
    }
    put(*next, k + 1, inner);
  }

  /// For a part *: continues in every table of this one.
  void put_into_all(Node& tables, std::size_t k, const std::string& path) const
  {
    if (k + 1 == parts_.size()) refuse_override(key_, "* stands for names of tables; a key must follow it");
    bool found = false;
    for (Node& item : tables.items) {
      if (item.kind != Node::Kind::table) continue;
      const std::string name = tables.kind == Node::Kind::array ? name_of(item) : item.key;
      put(item, k + 1, path.empty() ? name : path + "." + name);
      found = true;
    }
    if (!found) refuse_override(key_, fmt::format("there is no table in {} that * could stand for", path.empty() ? "the file" : path));
  }

  const std::string& key_;
  std::vector<std::string> parts_;
  Node value_;
};

}  // namespace

void apply_override(Document& document, const std::string& key_and_value)
{
  const std::size_t equals = key_and_value.find('=');
  if (equals == std::string::npos || equals == 0)
    refuse_override(key_and_value, "expected KEY=VALUE, such as material.sand.friction_angle=\"40 deg\"");
  const std::string key = key_and_value.substr(0, equals);
  Override(key, value_of(key, key_and_value.substr(equals + 1))).put_into(document.root);
}

std::string item_path(const std::string& path, const Node& item, int k)
{
  const std::string name = name_of(item);
  return name.empty() ? fmt::format("{}[{}]", path, k) : path + "." + name;
}

Found follow(const Node& root, std::string rest)
{
  Found at{&root, true, "", rest.substr(rest.find_last_of('.') + 1)};
  while (!rest.empty()) {
    if (rest[0] == '[') {
      int k = -1;
      std::from_chars(rest.data() + 1, rest.data() + rest.size(), k);
      if (at.node->kind != Node::Kind::array || k < 0 || k >= static_cast<int>(at.node->items.size())) break;
      at.node = &at.node->items[k];
      at.path = item_path(at.path, *at.node, k);
      rest.erase(0, std::min(rest.size(), rest.find(']') + 1));
    } else {
      const std::string key_and_more = rest.substr(rest[0] == '.' ? 1 : 0);
      const Node* next = nullptr;  // the longest key that fits, since a key may hold dots
      if (at.node->kind == Node::Kind::table)
        for (const Node& item : at.node->items)
          if (key_and_more.starts_with(item.key) && (next == nullptr || item.key.size() > next->key.size()) &&
              (key_and_more.size() == item.key.size() || key_and_more[item.key.size()] == '.' || key_and_more[item.key.size()] == '['))
            next = &item;
      if (next == nullptr) break;
      at.node = next;
      at.path += (at.path.empty() ? "" : ".") + next->key;
      at.last = next->key;
      rest = key_and_more.substr(next->key.size());
    }
  }
  at.whole = rest.empty();
  if (!at.whole) at.path += (at.path.empty() || rest[0] == '.' || rest[0] == '[' ? "" : ".") + rest;
  return at;
}

}  // namespace berm::input
