// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace berm::text {

/// A whole page without script, which needs no network: `title` is text, `content` HTML.
std::string plain_page(const std::string& title, const std::string& content);

/// A row of a table of such a page, its cells HTML; those from first_number to last_number are aligned to the right. `tag`: "td" or "th".
std::string plain_row(const std::vector<std::string>& cells, std::size_t first_number, std::size_t last_number, const char* tag);

}  // namespace berm::text
