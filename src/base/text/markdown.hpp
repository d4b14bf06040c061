// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

namespace berm::text {

/// Markdown with tables and with formulas between $ or $$ (see html_math), as HTML. HTML within the text is left out. `link`
/// returns the address to write for each link and picture of the text.
std::string html_of_markdown(const std::string& text, const std::function<std::string(const std::string& address)>& link);

}  // namespace berm::text
