// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/site/sounding_test.cpp
// GEF of a CPT: lines #KEY= VALUE, VALUE, ... to #EOH=, then rows of numbers. The number behind a column's name says what it holds.
#include "input/message_text.hpp"
#include "input/text_table.hpp"
#include "input/units.hpp"
#include "os/error.hpp"
#include "site/table.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <sstream>

namespace berm::site {
namespace {

/// By the number of the quantity: length of penetration, corrected depth, q_c, f_s, u_2, q_t.
const std::map<int, Reading> quantities = {
    {1, Reading::depth}, {11, Reading::corrected_depth}, {2, Reading::q_c}, {3, Reading::f_s}, {6, Reading::u_2}, {13, Reading::q_t}};

/// By the number of the variable of a measurement: area ratio of the cone, depth of a hole that was made before the test.
constexpr int area_ratio = 3, dug_to = 13;

/// The header, and how the rows below it are written.
struct Header {
  std::map<int, Column> columns;        ///< by their number from 1 on
  std::map<int, std::string> no_value;  ///< what stands there instead of one
  std::optional<Real> area_ratio;
  Real dug_to = 0;
  Index other_lines = 0;  ///< that are no #KEY= VALUE
  char separator = ' ', end_of_row = '\n';
};

std::string in_capitals(std::string text)
{
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

/// The fields of a variable: number, value, unit, ... A decimal comma parts its value: then digits stand where the unit does.
std::vector<std::string> with_whole_value(std::vector<std::string> fields)
{
  const auto digits = [](const std::string& text) { return !text.empty() && text.find_first_not_of("0123456789") == std::string::npos; };
  if (fields.size() > 2 && digits(fields[1]) && digits(fields[2])) {
    fields[1] += "." + fields[2];
    fields.erase(fields.begin() + 2);
  }
  return fields;
}

/// A depth in its unit, m where it says none.
Real depth_of(const std::vector<std::string>& fields, const std::string& file, int line)
{
  const std::string of = "#MEASUREMENTVAR 13", unit = fields.size() > 2 && fields[2] != "-" ? fields[2] : "";
  if (fields[1].empty()) return 0;
  try {
    return number_of(fields[1], file, line, of) * input::to_si("1 " + unit, "m");
  } catch (const input::UnitError&) {
    throw InputError(fmt::format("{}{}: {} is not a unit of a depth, such as m", at(file, line), of, input::in_quotes(unit)));
  }
}

void take(Header& header, const std::string& file, int line, const std::string& key, const std::string& value)
{
  std::vector<std::string> fields = input::fields_of(value, ',');
  const auto whole = [&](std::size_t i) { return static_cast<int>(number_of(fields[i], file, line, "#" + key)); };
  const std::size_t least = key == "COLUMNINFO" ? 4 : key == "COLUMNVOID" || key == "MEASUREMENTVAR" ? 2 : 0;
  if (fields.size() < least)
    throw InputError(fmt::format("{}#{} has {} values, and {} are needed", at(file, line), key, fields.size(), least));
  if (key == "COLUMNINFO") {
    const auto known = quantities.find(whole(3));
    const Column column = {known == quantities.end() ? Reading::other : known->second, fields[2], fields[1], line, ""};
    if (!header.columns.emplace(whole(0), column).second)
      throw InputError(fmt::format("{}#COLUMNINFO of column {} occurs twice in the file", at(file, line), whole(0)));
  } else if (key == "COLUMNVOID") {
    header.no_value[whole(0)] = fields[1];
  } else if (key == "MEASUREMENTVAR") {
    fields = with_whole_value(fields);
    if (whole(0) == area_ratio) header.area_ratio = area_ratio_of(fields[1], file, line, "#MEASUREMENTVAR 3");
    if (whole(0) == dug_to) header.dug_to = depth_of(fields, file, line);
  } else if ((key == "REPORTCODE" || key == "PROCEDURECODE") && in_capitals(value).find("GEF-CPT") == std::string::npos) {
    throw InputError(fmt::format("{}#{} is {}: a sounding has GEF-CPT-Report", at(file, line), key, input::in_quotes(fields[0])));
  } else if (key == "COLUMNSEPARATOR" && !fields[0].empty()) {
    header.separator = fields[0][0];
  } else if (key == "RECORDSEPARATOR" && !fields[0].empty()) {
    header.end_of_row = fields[0][0];
  }
}

/// Takes a line of the header; false where it ends it. A text may go on over lines without a key, which are not read.
bool take_line(Header& header, const std::string& file, int number, const std::string& line)
{
  const std::size_t equals = line.find('=');
  const std::string key = line[0] == '#' ? in_capitals(input::fields_of(line.substr(1, equals - 1), '=')[0]) : "";
  if (key == "EOH") return false;
  if (key.empty() || equals == std::string::npos)
    ++header.other_lines;
  else
    take(header, file, number, key, line.substr(equals + 1));
  return true;
}

std::vector<std::string> fields_of_row(const std::string& line, const Header& header)
{
  std::string row = input::with_plain_blanks(line.substr(0, line.find(header.end_of_row)));
  if (header.separator != ' ') {
    if (const std::size_t last = row.find_last_not_of(" \t\r"); last != std::string::npos && row[last] == header.separator)
      row.resize(last);
    return input::fields_of(row, header.separator);
  }
  std::vector<std::string> fields;
  std::istringstream words(row);
  for (std::string word; words >> word;) fields.push_back(word);
  return fields;
}

}  // namespace

Table read_gef(const std::string& file, const std::string& text)
{
  Header header;
  Table table;
  table.file = file;
  std::istringstream lines(text);
  int number = 0;
  bool in_header = true;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    if (in_header)
      in_header = take_line(header, file, number, line);
    else
      table.rows.push_back({number, fields_of_row(line, header)});
  }
  if (in_header) throw InputError(fmt::format("{}: has no line #EOH=, which ends the header", file));
  for (auto& [place, column] : header.columns) {
    if (place != static_cast<int>(table.columns.size()) + 1)
      throw InputError(fmt::format("{}column {} comes without column {}", at(file, column.line), place, table.columns.size() + 1));
    if (const auto no_value = header.no_value.find(place); no_value != header.no_value.end()) column.no_value = no_value->second;
    table.columns.push_back(column);
  }
  table.area_ratio = header.area_ratio;
  table.dug_to = std::max(header.dug_to, Real(0));
  if (header.other_lines > 0)
    table.notes.push_back(fmt::format("lines of the header that are no #KEY= VALUE are not read: {}", header.other_lines));
  return table;
}

}  // namespace berm::site
