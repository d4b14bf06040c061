// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/site/sounding_test.cpp
// A table: names with units in the first line, depth_m,q_c_MPa,f_s_kPa,u_2_kPa, or with the unit in brackets or on the line below, and rows of numbers. A line
// # area_ratio = 0.8 gives the area ratio of the cone; other lines that begin with # are not read.
#include "input/message_text.hpp"
#include "input/text_table.hpp"
#include "os/error.hpp"
#include "site/table.hpp"

#include <algorithm>
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

Column column_of(const std::string& field, int line)
{
  const auto known = [](const std::string& name) {
    const auto found = names.find(letters_of(name));
    return found == names.end() ? Reading::other : found->second;
  };
  if (const Reading reading = known(field); reading != Reading::other) return {reading, field, "", line, ""};
  const std::size_t bracket = field.find_first_of("([");
  const std::size_t split = bracket != std::string::npos ? bracket : field.rfind('_');
  if (split == std::string::npos) return {Reading::other, field, "", line, ""};
  std::string unit = field.substr(split + 1);
  if (bracket != std::string::npos) unit = unit.substr(0, unit.find_first_of(")]"));
  return {known(field.substr(0, split)), field, unit, line, ""};
}

/// What a comment says of the cone.
void take_comment(Table& table, const std::string& line, int number)
{
  const std::size_t equals = line.find_first_of("=:");
  if (equals == std::string::npos || letters_of(input::fields_of(line.substr(1, equals - 1), ',')[0]) != "arearatio") return;
  if (table.area_ratio) throw InputError(fmt::format("{}area_ratio occurs twice in the file", at(table.file, number)));
  // Behind the number a program that writes tables may leave separators, one for each column.
  std::string value = line.substr(equals + 1);
  value.resize(value.find_last_not_of(",;\t \r") + 1);
  input::DecimalCommas commas;
  value = input::fields_of(value, '\t')[0];
  commas.see(value);
  table.area_ratio = area_ratio_of(commas.with_point(value), table.file, number, "area_ratio");
}

/// Whether columns have no unit yet and a line holds words instead of numbers, which are then the units.
bool are_units(const Table& table, const std::vector<std::string>& fields)
{
  const auto unknown = [](const Column& column) { return column.reading != Reading::other && column.unit.empty(); };
  return table.rows.empty() && std::any_of(table.columns.begin(), table.columns.end(), unknown) &&
         std::none_of(fields.begin(), fields.end(), [](const std::string& field) { return input::number_in(field).has_value(); });
}

void take_units(Table& table, const std::vector<std::string>& fields, int line)
{
  for (std::size_t i = 0; i < std::min(fields.size(), table.columns.size()); ++i) {
    Column& column = table.columns[i];
    const std::size_t begin = fields[i].find_first_not_of("([ "), end = fields[i].find_last_not_of(")] ");
    if (!column.unit.empty() || begin == std::string::npos) continue;
    column.unit = fields[i].substr(begin, end + 1 - begin);
    column.line = line;
  }
}

}  // namespace

Table read_csv(const std::string& file, const std::string& text)
{
  Table table;
  table.file = file;
  std::istringstream lines(text);
  int number = 0;
  char separator = ',';
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (line.find_first_not_of(" \t\r,;\"") == std::string::npos) continue;
    if (line.starts_with('#')) {
      take_comment(table, line, number);
      continue;
    }
    if (table.columns.empty()) {
      if (input::says_separator(line)) continue;
      separator = input::separator_of(line);
      for (const std::string& field : input::fields_of(line, separator)) table.columns.push_back(column_of(field, number));
      continue;
    }
    std::vector<std::string> fields = input::fields_of(line, separator);
    while (fields.size() > table.columns.size() && fields.back().empty()) fields.pop_back();
    if (are_units(table, fields))
      take_units(table, fields, number);
    else if (fields.size() > table.columns.size() && separator == ',')
      throw InputError(fmt::format("{}has {} values, and {} columns were named; a comma separates columns: write decimals with a point, or "
                                   "separate columns by semicolons",
                                   at(file, number), fields.size(), table.columns.size()));
    else
      table.rows.push_back({number, fields});
  }
  return table;
}

}  // namespace berm::site
