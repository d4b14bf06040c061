// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/input/read_case_wrong_inputs_test.cpp
#include "input/follow.hpp"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>

namespace berm::input {

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
