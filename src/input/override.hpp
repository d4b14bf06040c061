// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "input/document.hpp"

namespace berm::input {

/// Replaces or adds one value of a document, given as `KEY=VALUE`. KEY is a dotted path, in which an array of tables is entered by the `name` of
/// its item (stage.drag.until.displacement), and `*` stands for every table of its place (contact.*.friction_angle, stage.*.damping). VALUE is TOML; what is no TOML is taken as text, so that a shell may eat the quotes of "40 mm".
/// Throws InputError "--set KEY: ..." where there is no key, or the path goes through something that is not there or is no table.
void apply_override(Document& document, const std::string& key_and_value);

}  // namespace berm::input
