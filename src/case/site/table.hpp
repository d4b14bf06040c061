// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/site/sounding_test.cpp
#pragma once

#include "site/sounding.hpp"

#include <optional>
#include <string_view>

namespace berm::site {

/// What a column of a sounding holds.
enum class Reading { depth, q_c, q_t, f_s, u_2, other };

/// A column of a file, its name and unit as it stands there, and the line that says so.
struct Column {
  Reading reading = Reading::other;
  std::string name, unit;
  int line = 0;
};

/// A row of the file, with a field for each column; "" where it has no value.
struct Row {
  int line = 0;
  std::vector<std::string> fields;
};

/// A sounding as the file has it.
struct Table {
  std::string file;
  std::vector<Column> columns;
  std::vector<Row> rows;
  std::optional<Real> area_ratio;  ///< of the cone
};

Table read_ags(const std::string& file, const std::string& text, const std::string& location);
Table read_gef(const std::string& file, const std::string& text);
Table read_csv(const std::string& file, const std::string& text);

/// The fields of a line between separators, without blanks and quotation marks around them. Separators between quotation marks are text.
std::vector<std::string> fields_of(std::string_view line, char separator);

/// The number that a text is. Throws InputError, with file, line and what it is of.
Real number_of(const std::string& text, const std::string& file, int line, const std::string& of);

/// The area ratio of a cone, above 0 and at most 1, that a text is. Throws InputError, too.
Real area_ratio_of(const std::string& text, const std::string& file, int line, const std::string& of);

/// "FILE:LINE: " of a message.
std::string at(const std::string& file, int line);

}  // namespace berm::site
