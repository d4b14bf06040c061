// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/site/sounding_test.cpp
// GEF of a CPT: lines #KEY= VALUE, VALUE, ... to #EOH=, then rows of numbers. The number behind a column's name says what it holds.
#include "core/error.hpp"
#include "input/message_text.hpp"
#include "site/table.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <sstream>

namespace berm::site {
namespace {

/// By the number of the quantity: length of penetration, corrected depth, q_c, f_s, u_2, q_t.
const std::map<int, Reading> quantities = {{1, Reading::depth}, {11, Reading::depth}, {2, Reading::q_c},
                                           {3, Reading::f_s},   {6, Reading::u_2},    {13, Reading::q_t}};

/// The header, and how the rows below it are written.
struct Header {
  std::map<int, Column> columns;        ///< by their number from 1 on
  std::map<int, int> quantity;          ///< of each
  std::map<int, std::string> no_value;  ///< what stands there instead of one
  std::optional<Real> area_ratio;
  char separator = ' ', end_of_row = '\n';
};

void take(Header& header, const std::string& file, int line, const std::string& key, const std::string& value)
{
  const std::vector<std::string> fields = fields_of(value, ',');
  const auto whole = [&](std::size_t i) { return static_cast<int>(number_of(fields[i], file, line, "#" + key)); };
  const std::size_t least = key == "COLUMNINFO" ? 4 : key == "COLUMNVOID" || key == "MEASUREMENTVAR" ? 2 : 0;
  if (fields.size() < least)
    throw InputError(fmt::format("{}#{} has {} values, and {} are needed", at(file, line), key, fields.size(), least));
  if (key == "COLUMNINFO") {
    const auto known = quantities.find(whole(3));
    header.columns[whole(0)] = {known == quantities.end() ? Reading::other : known->second, fields[2], fields[1], line};
    header.quantity[whole(0)] = whole(3);
  } else if (key == "COLUMNVOID") {
    header.no_value[whole(0)] = fields[1];
  } else if (key == "MEASUREMENTVAR" && whole(0) == 3) {
    header.area_ratio = area_ratio_of(fields[1], file, line, "#MEASUREMENTVAR 3");
  } else if ((key == "REPORTCODE" || key == "PROCEDURECODE") && value.find("GEF-CPT") == std::string::npos) {
    throw InputError(fmt::format("{}#{} is {}: a sounding has GEF-CPT-Report", at(file, line), key, input::in_quotes(fields[0])));
  } else if (key == "COLUMNSEPARATOR" && !fields[0].empty()) {
    header.separator = fields[0][0];
  } else if (key == "RECORDSEPARATOR" && !fields[0].empty()) {
    header.end_of_row = fields[0][0];
  }
}

/// The corrected depth counts where there is one.
void prefer_corrected_depth(Header& header)
{
  const auto is = [&](int quantity) {
    return std::any_of(header.quantity.begin(), header.quantity.end(), [&](const auto& one) { return one.second == quantity; });
  };
  if (!is(11)) return;
  for (const auto& [number, quantity] : header.quantity)
    if (quantity == 1) header.columns[number].reading = Reading::other;
}

std::vector<std::string> fields_of_row(const std::string& line, const Header& header)
{
  std::string row = line.substr(0, line.find(header.end_of_row));
  if (header.separator != ' ') {
    if (const std::size_t last = row.find_last_not_of(" \t\r"); last != std::string::npos && row[last] == header.separator)
      row.resize(last);
    return fields_of(row, header.separator);
  }
  std::vector<std::string> fields;
  std::istringstream words(row);
  for (std::string word; words >> word;) fields.push_back(word);
  return fields;
}

bool same_number(const std::string& a, const std::string& b, const std::string& file, int line)
{
  return a == b || number_of(a, file, line, "a value") == number_of(b, file, line, "#COLUMNVOID");
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
    if (!in_header) {
      Row row{number, fields_of_row(line, header)};
      for (std::size_t i = 0; i < row.fields.size(); ++i)
        if (const auto no_value = header.no_value.find(static_cast<int>(i) + 1);
            no_value != header.no_value.end() && same_number(row.fields[i], no_value->second, file, number))
          row.fields[i].clear();
      table.rows.push_back(row);
      continue;
    }
    const std::size_t equals = line.find('=');
    if (line[0] != '#' || equals == std::string::npos)
      throw InputError(fmt::format("{}a line of the header is #KEY= VALUE, to #EOH=", at(file, number)));
    const std::string key = fields_of(line.substr(1, equals - 1), '=')[0];
    in_header = key != "EOH";
    take(header, file, number, key, line.substr(equals + 1));
  }
  if (in_header) throw InputError(fmt::format("{}: has no line #EOH=, which ends the header", file));
  prefer_corrected_depth(header);
  for (const auto& [place, column] : header.columns) {
    if (place != static_cast<int>(table.columns.size()) + 1)
      throw InputError(fmt::format("{}column {} comes without column {}", at(file, column.line), place, table.columns.size() + 1));
    table.columns.push_back(column);
  }
  table.area_ratio = header.area_ratio;
  return table;
}

}  // namespace berm::site
