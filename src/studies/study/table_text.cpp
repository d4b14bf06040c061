// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/study/study_test.cpp
#include "study/table_text.hpp"

#include "run_folder/csv_line.hpp"

namespace berm::study {

std::string csv_line(const std::vector<std::string>& fields)
{
  std::string line;
  for (const std::string& field : fields) {
    line += run_folder::csv_field(field);
    line += ',';
  }
  line.back() = '\n';
  return line;
}

std::string markdown_line(const std::vector<std::string>& cells)
{
  std::string line = "|";
  for (const std::string& cell : cells) {
    line += ' ';
    for (const char c : cell) line += c == '|' ? std::string("\\|") : std::string(1, c);
    line += " |";
  }
  return line + '\n';
}

std::string markdown_rule(std::size_t columns, std::size_t columns_of_text)
{
  std::string line = "|";
  for (std::size_t k = 0; k < columns; ++k) line += k < columns_of_text ? "---|" : "---:|";
  return line + '\n';
}

}  // namespace berm::study
