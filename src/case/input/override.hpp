// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "input/document.hpp"

namespace berm::input {

/// Replaces or adds one value of a document, given as `KEY=VALUE`. KEY is a dotted path, in which an item of an array of
/// tables has its `name` (stage.drag.until.displacement), and `*` stands for every table of its level
/// (contact.*.friction_angle, stage.*.damping). VALUE is TOML; anything else is taken as text, so that the shell may remove
/// the quotes of "40 mm". Throws InputError "--set KEY: ..." where there is no key, or the path goes through something that
/// does not exist or is not a table.
void apply_override(Document& document, const std::string& key_and_value);

/// Result of following the path of a key: "body.sand.material", "stage[2].until".
struct Found {
  const Node* node;  ///< the last node on the path that exists
  bool whole;        ///< whether that is the end of the path
  std::string path;  ///< with names for items of arrays
  std::string last;  ///< the last key of the path
};

/// Follows a path, dotted from the root of a document.
Found follow(const Node& root, std::string path);

/// "stage.drag" of the item of an array with that name, "stage[2]" of one without.
std::string item_path(const std::string& path, const Node& item, int k);

}  // namespace berm::input
