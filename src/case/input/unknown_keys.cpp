// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/input/read_case_wrong_inputs_test.cpp
#include "input/catalogue.hpp"

#include "input/message_text.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::input {
namespace {

std::string join(const std::string& path, const std::string& key)
{
  return path.empty() ? key : path + "." + key;
}

/// The word of a selector in this table, or "" where it has none of its words: then any alternative may be meant.
std::string chosen_word(const Node& table, const Listed& known, const std::string& selector)
{
  for (const Listed& entry : known.children)
    if (entry.key == selector && entry.kind == Listed::Kind::word) {
      const Node* node = member(table, selector);
      const std::string word = node == nullptr ? entry.default_text : node->text;
      return std::find(entry.words.begin(), entry.words.end(), word) != entry.words.end() ? word : "";
    }
  return "";
}

/// The condition of `entry` that this table does not satisfy, or null.
const Condition* unmet(const Node& table, const Listed& known, const Listed& entry)
{
  for (const Condition& condition : entry.conditions)
    if (const std::string word = chosen_word(table, known, condition.selector); !word.empty() && word != condition.word) return &condition;
  return nullptr;
}

class Search {
public:
  explicit Search(const Document& document) : document_(document) {}

  void table(const Node& node, const std::string& path, const Listed& known) const
  {
    for (const Node& item : node.items) {
      const Listed* match = nullptr;
      std::vector<const Condition*> missed;
      for (const Listed& entry : known.children) {
        if (entry.key != item.key) continue;
        const Condition* condition = unmet(node, known, entry);
        (condition == nullptr ? static_cast<void>(match = &entry) : missed.push_back(condition));
      }
      const std::string item_path = join(path, item.key);
      if (match == nullptr) refuse_key(node, item, item_path, known, missed);
      enter(item, item_path, *match);
    }
  }

private:
  void enter(const Node& item, const std::string& path, const Listed& known) const
  {
    if (known.kind == Listed::Kind::table && item.kind == Node::Kind::table) table(item, path, known);
    if (known.kind == Listed::Kind::named_tables && item.kind == Node::Kind::table) named_tables(item, path, known);
    if (known.kind == Listed::Kind::array && item.kind == Node::Kind::array)
      for (int k = 0; k < static_cast<int>(item.items.size()); ++k) {
        const std::string name = name_of(item.items[k]);
        if (item.items[k].kind == Node::Kind::table)
          table(item.items[k], name.empty() ? fmt::format("{}[{}]", path, k) : join(path, name), known);
      }
  }

  void named_tables(const Node& node, const std::string& path, const Listed& known) const
  {
    std::vector<std::string> names;
    for (const Node& item : node.items)
      if (!item.implied) names.push_back(item.key);
    for (const Node& item : node.items) {
      if (item.implied) refuse(document_, item, join(path, item.key), fmt::format("there is no [{}.{}]", path, item.key), item.key, names);
      if (item.kind == Node::Kind::table) table(item, join(path, item.key), known);
    }
  }

  [[noreturn]] void refuse_key(const Node& node, const Node& item, const std::string& path, const Listed& known,
                               const std::vector<const Condition*>& missed) const
  {
    std::vector<std::string> allowed;
    for (const Listed& entry : known.children)
      if (unmet(node, known, entry) == nullptr && std::find(allowed.begin(), allowed.end(), entry.key) == allowed.end())
        allowed.push_back(entry.key);
    if (!missed.empty()) {
      const std::string selector = missed.front()->selector;
      std::string words;
      for (const Condition* condition : missed)
        if (condition->selector == selector) words += (words.empty() ? "" : " or ") + in_quotes(condition->word);
      refuse(document_, item, path,
             fmt::format("applies with {0} = {1}, but here {0} = {2}", selector, words, in_quotes(chosen_word(node, known, selector))), "",
             allowed);
    }
    refuse(document_, item, path, item.kind == Node::Kind::table ? "unknown table" : "unknown key", item.key, allowed);
  }

  const Document& document_;
};

void refuse_unused(const Document& document, const Node& node, const std::string& path)
{
  const bool in_array = node.kind == Node::Kind::array;
  for (std::size_t k = 0; k < node.items.size(); ++k) {
    const Node& item = node.items[k];
    const std::string item_path = in_array ? fmt::format("{}[{}]", path, k) : join(path, item.key);
    if (!item.used) refuse(document, item, item_path, "unknown key");
    refuse_unused(document, item, item_path);
  }
}

}  // namespace

void refuse_unknown_keys(const Document& document, const Listed& catalogue)
{
  Search(document).table(document.root, "", catalogue);
}

void refuse_unused_keys(const Document& document)
{
  refuse_unused(document, document.root, "");
}

}  // namespace berm::input
