// SPDX-License-Identifier: BSD-3-Clause
// toml++ checks its own steps with assertions, which malformed input such as "[&" reaches: here they throw, in every build.
#undef NDEBUG
#undef TOML_SHARED_LIB
#undef TOML_HEADER_ONLY
#define TOML_HEADER_ONLY 1
#define TOML_MAX_NESTED_VALUES 32
#define TOML_ASSERT(condition) ((condition) ? void() : berm::toml_stumbles())
namespace berm {
namespace {
struct TomlStumbled {};
[[noreturn]] inline void toml_stumbles()
{
  throw TomlStumbled();
}
} // namespace
} // namespace berm
#include <toml++/toml.h>

#include "core/error.hpp"
#include "input/document.hpp"
#include "input/wording.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fstream>

namespace berm {
namespace {

constexpr std::size_t most_bytes = 1'000'000;
constexpr int most_dots = 32;

Node convert(const toml::node& from);

void convert_table(const toml::table& table, Node& node)
{
  for (const auto& [key, value] : table) {
    Node& item = node.items.emplace_back(convert(value));
    item.key = key.str();
    if (const toml::source_position begin = key.source().begin; begin.line > 0) {
      item.line = static_cast<int>(begin.line);
      item.column = static_cast<int>(begin.column);
    }
  }
  std::stable_sort(node.items.begin(), node.items.end(),
                   [](const Node& a, const Node& b) { return a.line != b.line ? a.line < b.line : a.column < b.column; });
}

Node convert(const toml::node& from)
{
  Node node;
  node.line = static_cast<int>(from.source().begin.line);
  node.column = static_cast<int>(from.source().begin.column);
  if (const toml::table* table = from.as_table()) {
    convert_table(*table, node);
  } else if (const toml::array* array = from.as_array()) {
    node.kind = Node::Kind::array;
    for (const toml::node& item : *array) node.items.push_back(convert(item));
  } else if (const auto* truth = from.as_boolean()) {
    node.kind = Node::Kind::boolean;
    node.truth = truth->get();
  } else if (const auto* whole = from.as_integer()) {
    node.kind = Node::Kind::whole;
    node.whole = whole->get();
  } else if (const auto* number = from.as_floating_point()) {
    node.kind = Node::Kind::number;
    node.number = number->get();
  } else if (const auto* text = from.as_string()) {
    node.kind = Node::Kind::text;
    node.text = text->get();
  } else {
    node.kind = Node::Kind::date;
  }
  return node;
}

/// The first line that has a key of more parts than most_dots, or 0: a.a.a.a... makes tables deeper than a call stack.
int line_of_too_deep_key(const std::string& text)
{
  int line = 1, dots = 0;
  for (std::size_t k = 0; k < text.size(); ++k) {
    const char c = text[k];
    if (c == '"' || c == '\'') {
      const std::size_t end = text.find_first_of(std::string{c, '\n'}, k + 1);
      if (end != std::string::npos && text[end] == c) k = end;
    } else if (c == '\n') {
      ++line, dots = 0;
    } else if (c == ',' || c == '=' || c == '#' || c == '[' || c == '{') {
      dots = 0;
    } else if (c == '.' && ++dots > most_dots) {
      return line;
    }
  }
  return 0;
}

/// What toml++ says without its first words, and what is behind the two slips that are made most.
std::string advised(std::string description)
{
  if (const std::string words = "Error while parsing "; description.starts_with(words)) description.erase(0, words.size());
  if (description.find("unescaped control characters") != std::string::npos) return description + "; is a quote left open?";
  if (description.find("expected a comment or whitespace") != std::string::npos)
    return description + "; texts and quantities with units stand in quotes: \"20 mm\"";
  return description;
}

[[noreturn]] void refuse_line(const std::string& file, std::size_t line, const std::string& message)
{
  throw InputError(one_line(fmt::format("{}:{}: {}", file, std::max<std::size_t>(line, 1), message)));
}

} // namespace

Document parse_file(const std::filesystem::path& file)
{
  std::error_code problem;
  const auto refuse_file = [&](const char* why) { throw InputError(one_line(fmt::format("{}: {}", file.string(), why))); };
  if (!std::filesystem::exists(file, problem)) refuse_file("there is no such file");
  if (std::filesystem::is_directory(file, problem)) refuse_file("is a folder; wanted is a TOML file, such as case.toml");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) refuse_file("cannot be opened");
  std::string text(most_bytes + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (stream.bad()) refuse_file("cannot be read");
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return parse_text(file.string(), text);
}

Document parse_text(const std::string& file, const std::string& text)
{
  if (text.size() > most_bytes)
    throw InputError(one_line(fmt::format("{}: is longer than {} bytes, the most for a case", file, most_bytes)));
  if (const int line = line_of_too_deep_key(text)) refuse_line(file, line, fmt::format("a key has more than {} dots", most_dots));
  if (const std::size_t nul = text.find('\0'); nul != std::string::npos)
    refuse_line(file, 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(nul), '\n'),
                "a NUL byte: this is not a text file");
  try {
    Document document{file, convert(toml::parse(text, file))};
    document.root.line = 1;
    return document;
  } catch (const toml::parse_error& error) {
    refuse_line(file, error.source().begin.line, "not valid TOML, " + advised(std::string(error.description())));
  } catch (const TomlStumbled&) {
    throw InputError(one_line(fmt::format("{}:1: not valid TOML, a bracket, a quote or a key is wrong", file)));
  }
}

std::optional<Node> parse_value(const std::string& text)
{
  try {
    Document document = parse_text("", "value = " + text);
    if (document.root.items.size() == 1 && document.root.items[0].key == "value") return document.root.items[0];
  } catch (const InputError&) {
    return std::nullopt;
  }
  return std::nullopt;
}

const Node* member(const Node& table, const std::string& key)
{
  if (table.kind != Node::Kind::table) return nullptr;
  for (const Node& item : table.items)
    if (item.key == key) return &item;
  return nullptr;
}

Node* member(Node& table, const std::string& key)
{
  return const_cast<Node*>(member(static_cast<const Node&>(table), key));
}

std::string name_of(const Node& item)
{
  const Node* name = member(item, "name");
  return name != nullptr && name->kind == Node::Kind::text ? name->text : "";
}

std::string kind_of(const Node& node)
{
  switch (node.kind) {
  case Node::Kind::boolean:
    return node.truth ? "true" : "false";
  case Node::Kind::whole:
    return fmt::format("the number {}", node.whole);
  case Node::Kind::number:
    return fmt::format("the number {}", node.number);
  case Node::Kind::text:
    return "the text " + in_quotes(node.text);
  case Node::Kind::date:
    return "a date or time";
  case Node::Kind::array:
    return "an array";
  case Node::Kind::table:
    return "a table";
  }
  return "";
}

void refuse(const Document& document, const Node& node, const std::string& path, const std::string& message)
{
  const bool by_override = !node.override_key.empty();
  const std::string place = by_override ? "--set " + node.override_key : fmt::format("{}:{}", document.file, node.line);
  const bool repeats = by_override && node.override_key == path;
  throw InputError(one_line(place + ": " + (path.empty() || repeats ? "" : path + ": ") + message));
}

} // namespace berm
