// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace berm {

/// Whether a text (UTF-8) holds a control character: it would move a terminal's cursor, or end a line of a table, a deck or a script.
bool has_control_character(const std::string& text);

/// A text on one line: each byte of a control character becomes a space.
std::string one_line(std::string text);

}  // namespace berm
