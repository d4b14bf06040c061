// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/run_folder/history_test.cpp
#include "run_folder/csv_line.hpp"

namespace berm::run_folder {

std::string csv_field(const std::string& text)
{
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

bool next_csv_line(const std::string& text, std::size_t& at, std::vector<std::string>& fields, char separator)
{
  fields.assign(1, "");
  bool quoted = false;
  for (std::size_t k = at; k < text.size(); ++k) {
    const char c = text[k];
    if (quoted && c == '"' && k + 1 < text.size() && text[k + 1] == '"') {
      fields.back() += text[++k];
    } else if (c == '"') {
      quoted = !quoted;
    } else if (c == separator && !quoted) {
      fields.emplace_back();
    } else if (c == '\n' && !quoted) {
      if (!fields.back().empty() && fields.back().back() == '\r') fields.back().pop_back();
      at = k + 1;
      return true;
    } else {
      fields.back() += c;
    }
  }
  return false;
}

}  // namespace berm::run_folder
