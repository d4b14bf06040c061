// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/site/sounding_test.cpp
#pragma once

#include "site/sounding.hpp"

#include <optional>

namespace berm::site {

/// What a column of a sounding holds. The depth along the rods counts where that corrected for their inclination is void.
enum class Reading { depth, corrected_depth, q_c, q_t, f_s, u_2, other };

/// A column of a file, its name and unit as it stands there, the number that stands for no value, and the line that says so.
struct Column {
  Reading reading = Reading::other;
  std::string name, unit;
  int line = 0;
  std::string no_value;
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
  Real dug_to = 0;                 ///< depth of a hole that was made before the test, m
  std::vector<std::string> notes;  ///< what of the file is not read
};

Table read_ags(const std::string& file, const std::string& text, const std::string& location);
Table read_gef(const std::string& file, const std::string& text);
Table read_csv(const std::string& file, const std::string& text);

/// The readings of a table, in SI units. Throws InputError with file, line, column and unit where it is wrong.
Sounding sounding_of(Table table);

/// The number that a text is. Throws InputError, with file, line and what it is of.
Real number_of(const std::string& text, const std::string& file, int line, const std::string& of);

/// The area ratio of a cone, above 0 and at most 1, that a text is; none where the text is empty, 0 or negative, as files have it that do not know it. Throws InputError, too.
std::optional<Real> area_ratio_of(const std::string& text, const std::string& file, int line, const std::string& of);

/// "FILE:LINE: " of a message.
std::string at(const std::string& file, int line);

}  // namespace berm::site
