// SPDX-License-Identifier: BSD-3-Clause
#include "input/override.hpp"

#include "core/error.hpp"
#include "input/wording.hpp"

#include <fmt/format.h>

namespace berm {
namespace {

[[noreturn]] void refuse_override(const std::string& key, const std::string& message)
{
  throw InputError(one_line(fmt::format("--set {}: {}", key, message)));
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
    if (part.empty()) refuse_override(key, "the key has an empty part; wanted is a path such as material.sand.friction_angle");
  if (inside) refuse_override(key, "a quote is not closed");
  constexpr std::size_t most_parts = 32;
  if (parts.size() > most_parts) refuse_override(key, "the key has too many parts");
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
  refuse_override(key, fmt::format("there is no {} named {}{}", path, in_quotes(part), suggestion(part, names)));
}

}  // namespace

void apply_override(Document& document, const std::string& key_and_value)
{
  const std::size_t equals = key_and_value.find('=');
  if (equals == std::string::npos || equals == 0)
    throw InputError(
        one_line(fmt::format("--set {}: wanted is KEY=VALUE, such as material.sand.friction_angle=\"40 deg\"", key_and_value)));
  const std::string key = key_and_value.substr(0, equals);
  const std::vector<std::string> parts = split(key);
  Node value = value_of(key, key_and_value.substr(equals + 1));
  mark(value, key);

  Node* at = &document.root;
  std::string path;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const bool last = k + 1 == parts.size();
    if (at->kind == Node::Kind::array && !at->items.empty() && at->items[0].kind == Node::Kind::table) {
      at = &item_named(*at, parts[k], path, key);
    } else if (at->kind != Node::Kind::table) {
      refuse_override(key, fmt::format("{} is {}, which has no {}", path, kind_of(*at), in_quotes(parts[k])));
    } else {
      Node* next = member(*at, parts[k]);
      if (next == nullptr) {
        next = &at->items.emplace_back();
        next->key = parts[k];
        next->override_key = key;
        next->implied = !last;
      }
      at = next;
    }
    path += (k == 0 ? "" : ".") + parts[k];
  }
  value.key = at->key;
  value.line = at->line;
  value.column = at->column;
  *at = std::move(value);
}

}  // namespace berm
