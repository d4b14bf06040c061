// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/site/sounding_test.cpp
// AGS 4: lines of texts between quotation marks. A group has the lines GROUP, HEADING, UNIT, TYPE and one DATA for each row, and may come several times in files that
// were put together, each time with headings and units of its own.
#include "site/ags_groups.hpp"

#include "input/message_text.hpp"
#include "input/text_table.hpp"
#include "os/error.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <sstream>

namespace berm::site {

std::size_t AgsGroup::place_of(const std::string& heading) const
{
  return static_cast<std::size_t>(std::find(headings.begin(), headings.end(), heading) - headings.begin());
}

std::string AgsGroup::of(const Row& row, const std::string& heading) const
{
  const std::size_t place = place_of(heading);
  return place < headings.size() ? row.fields[place] : "";
}

namespace {

constexpr std::array<std::string_view, 5> words = {"GROUP", "HEADING", "UNIT", "TYPE", "DATA"};

bool begins_line(const std::string& line)
{
  const std::string word = input::fields_of(line, ',')[0];
  return line.starts_with('"') && std::find(words.begin(), words.end(), word) != words.end();
}

/// Takes the next line, with those that go on with its last text; `number` becomes that of the first.
bool next_line(std::istringstream& lines, int& number, int& taken, const std::string& file, std::string& line)
{
  if (!std::getline(lines, line)) return false;
  number = ++taken;
  while (!input::closes_its_quotes(line)) {
    std::string more;
    if (!std::getline(lines, more) || begins_line(more)) throw InputError(at(file, number) + "a quotation mark is not closed");
    ++taken;
    line += ' ' + more;
  }
  return true;
}

void take(AgsGroup& group, const std::string& word, const std::vector<std::string>& fields, const std::string& file, int line)
{
  if (std::find(words.begin(), words.end(), word) == words.end())
    throw InputError(fmt::format("{}{} is none of GROUP, HEADING, UNIT, TYPE and DATA", at(file, line), input::in_quotes(word)));
  if ((word == "HEADING" && !group.headings.empty()) || (word == "UNIT" && !group.units.empty()))
    throw InputError(
        fmt::format("{}a second line {} in the group {}: a line GROUP is missing before it", at(file, line), word, group.name));
  if (word == "HEADING") {
    group.headings = fields;
    return;
  }
  if (fields.size() != group.headings.size())
    throw InputError(fmt::format("{}has {} values, and the group {} headings", at(file, line), fields.size(), group.headings.size()));
  if (word == "UNIT") {
    group.units = fields;
    group.line_of_units = line;
  } else if (word == "DATA") {
    group.rows.push_back({line, fields});
  }
}

}  // namespace

std::vector<AgsGroup> read_ags_groups(const std::string& file, const std::string& text)
{
  std::vector<AgsGroup> groups;
  std::istringstream lines(text);
  int number = 0, taken = 0;
  for (std::string line; next_line(lines, number, taken, file, line);) {
    std::vector<std::string> fields = input::fields_of(line, ',');
    const std::string word = fields[0];
    if (word.empty() && fields.size() == 1) continue;
    fields.erase(fields.begin());
    if (groups.empty() && word.starts_with("**"))
      throw InputError(at(file, number) + "is of AGS 3, which has other groups and units: have it exported as AGS 4");
    if (word == "GROUP" && !fields.empty())
      groups.push_back({fields[0], number, number, {}, {}, {}});
    else if (groups.empty())
      throw InputError(fmt::format("{}begins with {}: a file of AGS 4 begins with \"GROUP\"", at(file, number), input::in_quotes(word)));
    else
      take(groups.back(), word, fields, file, number);
  }
  return groups;
}

}  // namespace berm::site
