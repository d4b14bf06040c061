// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace berm::input {

/// All parameters of a case as aligned plain text, for `berm params`.
std::string parameter_table();

/// All parameters of a case as Markdown: docs/parameters.md, for `berm params --markdown`.
std::string parameter_page();

}  // namespace berm::input
