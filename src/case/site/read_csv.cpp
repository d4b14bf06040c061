// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/site/sounding_test.cpp
// A table: names with units in the first line, depth_m,q_c_MPa,f_s_kPa,u_2_kPa, or with the unit in brackets, and rows of numbers. A line
// # area_ratio = 0.8 gives the area ratio of the cone; other lines that begin with # are not read.
#include "core/error.hpp"
#include "input/message_text.hpp"
#include "site/table.hpp"

#include <fmt/format.h>
#include <map>
#include <sstream>

namespace berm::site {
namespace {

const std::map<std::string, Reading> names = {{"depth", Reading::depth}, {"z", Reading::depth}, {"qc", Reading::q_c},
                                              {"qt", Reading::q_t},      {"fs", Reading::f_s},  {"u2", Reading::u_2}};

/// The letters of a name in lower case, without blanks and underlines.
std::string letters_of(const std::string& name)
{
  std::string letters;
  for (const char c : name)
    if (c != '_' && c != ' ') letters += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return letters;
}

Column column_of(const std::string& field, const std::string& file, int line)
{
  const std::size_t bracket = field.find_first_of("([");
  const std::size_t split = bracket != std::string::npos ? bracket : field.rfind('_');
  if (split == std::string::npos)
    throw InputError(
        fmt::format("{}column {} says no unit: name it as in depth_m,q_c_MPa,f_s_kPa,u_2_kPa", at(file, line), input::in_quotes(field)));
  std::string unit = field.substr(split + 1);
  if (bracket != std::string::npos) unit = unit.substr(0, unit.find_first_of(")]"));
  const auto known = names.find(letters_of(field.substr(0, split)));
  return {known == names.end() ? Reading::other : known->second, field, unit, line};
}

/// What a comment says of the cone.
void take_comment(Table& table, const std::string& line, int number)
{
  const std::size_t equals = line.find_first_of("=:");
  if (equals == std::string::npos || letters_of(fields_of(line.substr(1, equals - 1), ',')[0]) != "arearatio") return;
  if (table.area_ratio) throw InputError(fmt::format("{}area_ratio stands in the file twice", at(table.file, number)));
  // Behind the number a program that writes tables may leave separators, one for each column.
  std::string value = line.substr(equals + 1);
  value.resize(value.find_last_not_of(",;\t \r") + 1);
  table.area_ratio = area_ratio_of(fields_of(value, '\t')[0], table.file, number, "area_ratio");
}

}  // namespace

Table read_csv(const std::string& file, const std::string& text)
{
  Table table;
  table.file = file;
  std::istringstream lines(text.starts_with("\xEF\xBB\xBF") ? text.substr(3) : text);
  int number = 0;
  char separator = ',';
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    if (line.starts_with('#')) {
      take_comment(table, line, number);
      continue;
    }
    if (!table.columns.empty()) {
      table.rows.push_back({number, fields_of(line, separator)});
      continue;
    }
    for (const char one : {';', '\t'})
      if (line.find(one) != std::string::npos) separator = one;
    for (const std::string& field : fields_of(line, separator)) table.columns.push_back(column_of(field, file, number));
  }
  return table;
}

}  // namespace berm::site
