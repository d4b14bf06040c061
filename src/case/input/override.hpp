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

}  // namespace berm::input
