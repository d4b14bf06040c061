// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "site/table.hpp"

namespace berm::site {

/// A group of a file of AGS 4, once: its headings, their units, and its rows of data, without the first word of each line.
struct AgsGroup {
  std::string name;
  int line = 0, line_of_units = 0;
  std::vector<std::string> headings, units;
  std::vector<Row> rows;

  /// headings.size() where there is no such heading.
  std::size_t place_of(const std::string& heading) const;
  /// "" where there is no such heading.
  std::string of(const Row& row, const std::string& heading) const;
};

/// Throws InputError with file and line where the text is not of AGS 4.
std::vector<AgsGroup> read_ags_groups(const std::string& file, const std::string& text);

}  // namespace berm::site
