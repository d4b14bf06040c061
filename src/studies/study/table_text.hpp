// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace berm::study {

/// One line of a .csv file.
std::string csv_line(const std::vector<std::string>& fields);

/// One line of a table in Markdown, and the line below its headings: text to the left in the first columns, numbers to the right in the others.
std::string markdown_line(const std::vector<std::string>& cells);
std::string markdown_rule(std::size_t columns, std::size_t columns_of_text);

}  // namespace berm::study
