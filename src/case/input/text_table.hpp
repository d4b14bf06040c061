// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/input/text_table_test.cpp
#pragma once

#include "core/types.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace berm::input {

bool is_digit(char c);

/// A text with a common blank for each blank that does not break, is thin or is as wide as a figure, and with "-" for the minus sign of typesetting.
std::string with_plain_blanks(std::string text);

/// The fields of a line between separators, without blanks and quotation marks around them. Separators between quotation marks are text.
std::vector<std::string> fields_of(std::string_view line, char separator);

/// Whether each quotation mark of a line is closed on it.
bool closes_its_quotes(std::string_view line);

/// What stands between the columns of a table, by its first line: a semicolon, else a tab, where one stands outside quotation marks; else a comma.
char separator_of(std::string_view line);

/// Whether a line tells a spreadsheet what separates columns, as in "sep=;".
bool says_separator(std::string_view line);

/// The finite number that a text is, such as "-1.5e3" or "+2".
std::optional<Real> number_in(const std::string& text);

/// What is wrong with a text that is no number since it has commas or blanks between its digits, and what to write: "has a decimal comma: write 0.5"; "" where that is not it.
std::string fault_of_commas(const std::string& text);

/// Whether the numbers of a table have decimal commas, known once all of them were seen: one cannot have its comma between thousands, and none has a point.
class DecimalCommas {
public:
  void see(const std::string& field);
  /// The field with a point for the comma, if commas are that in this table and the field is a number then.
  std::string with_point(const std::string& field) const;

private:
  bool comma_ = false, point_ = false;
};

}  // namespace berm::input
