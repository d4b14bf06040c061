// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace berm::run_folder {

/// A text as a field of a .csv file (RFC 4180): quoted only where it holds a comma, a quote or the end of a line.
std::string csv_field(const std::string& text);

/// Takes the fields of the next line from the text of a .csv file (RFC 4180) and moves `at` past it; false where no whole line is left.
bool next_csv_line(const std::string& text, std::size_t& at, std::vector<std::string>& fields, char separator = ',');

}  // namespace berm::run_folder
