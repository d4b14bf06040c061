// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/soil_fit/measured_test.cpp
#include "soil_fit/laboratory_table.hpp"

#include "input/message_text.hpp"
#include "input/text_table.hpp"
#include "input/units.hpp"
#include "os/text_file.hpp"
#include "soil_fit/laboratory_ags.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <sstream>

namespace berm::soil_fit {
namespace {

struct ReadingWord {
  const char *word, *unit, *meaning;
};
constexpr ReadingWord words[reading_count] = {{"axial_strain", "1", "axial strain"},
                                              {"shear_strain", "1", "engineering shear strain"},
                                              {"volumetric_strain", "1", "volumetric strain"},
                                              {"void_ratio", "1", "void ratio"},
                                              {"q", "Pa", "vertical less lateral stress"},
                                              {"stress_ratio", "1", "vertical divided by lateral effective stress"},
                                              {"p", "Pa", "mean effective stress"},
                                              {"vertical_stress", "Pa", "vertical effective stress"},
                                              {"lateral_stress", "Pa", "lateral effective stress"},
                                              {"tau", "Pa", "shear stress"},
                                              {"excess_pore_pressure", "Pa", "excess pore pressure"},
                                              {"depth", "m", "depth below the seabed"},
                                              {"resistance", "Pa", "resistance of the tool, down positive"},
                                              {"force", "N", "force on the tool, down positive"}};

/// Units that such a column may have, for messages: the usual one first.
std::pair<const char*, const char*> usual_units(const std::string& si)
{
  if (si == "1") return {"%", "% or 1"};
  if (si == "m") return {"m", "m, cm or mm"};
  if (si == "N") return {"kN", "N or kN"};
  return {"kPa", "Pa, kPa or MPa"};
}

std::size_t index_of(Reading reading)
{
  return static_cast<std::size_t>(reading);
}

/// Strains are written in % or as bare numbers, so that one without a unit may be either.
bool needs_unit(Reading reading)
{
  return reading != Reading::void_ratio && reading != Reading::stress_ratio;
}

/// "q (kPa)" and "q [kPa]" as q and kPa.
std::pair<std::string, std::string> split_heading(const std::string& heading)
{
  const std::size_t open = heading.find_last_of("(["), close = heading.find_last_of(")]");
  if (open == std::string::npos || close == std::string::npos || close < open) return {heading, ""};
  const std::size_t end = heading.find_last_not_of(" _", open == 0 ? 0 : open - 1);
  return {open == 0 || end == std::string::npos ? "" : heading.substr(0, end + 1), heading.substr(open + 1, close - open - 1)};
}

/// How often a unit has the SI one; NaN where it is none of that dimension.
Real size_of_unit(const std::string& unit, const std::string& si)
{
  if (unit == "1" || unit == "-") return si == "1" ? 1 : nan;
  if (unit == "percent") return si == "1" ? 0.01 : nan;
  try {
    return input::to_si("1 " + unit, si == "1" ? "" : si);
  } catch (const input::UnitError&) {
    return nan;
  }
}

/// A table below a line of headings; lines that begin with # do not count.
Sheet sheet_of_csv(const std::string& file, const std::string& bytes)
{
  Sheet sheet;
  std::istringstream text(bytes);
  char separator = ',';
  input::DecimalCommas commas;
  int number = 0;
  for (std::string line; std::getline(text, line);) {
    ++number;
    if (!line.empty() && line.back() == '\r') line.pop_back();
    line = input::with_plain_blanks(line);
    if (line.find_first_not_of(" \t,;") == std::string::npos || line.front() == '#' || input::says_separator(line)) continue;
    if (sheet.headings.empty()) {
      separator = input::separator_of(line);
      sheet.headings = input::fields_of(line, separator);
      continue;
    }
    std::vector<std::string> fields = input::fields_of(line, separator);
    const std::size_t count = sheet.headings.size();
    if (fields.size() > count && std::any_of(fields.begin() + static_cast<std::ptrdiff_t>(count), fields.end(),
                                             [](const std::string& field) { return !field.empty(); }))
      throw InputError(fmt::format("{}:{}: has {} values, and the first line {} headings", file, number, fields.size(), count));
    fields.resize(count);
    for (const std::string& field : fields) commas.see(field);
    sheet.fields.push_back(std::move(fields));
    sheet.lines.push_back(number);
  }
  for (std::vector<std::string>& fields : sheet.fields)
    for (std::string& field : fields) field = commas.with_point(field);
  return sheet;
}

}  // namespace

std::vector<std::string> reading_words()
{
  std::vector<std::string> all;
  for (const ReadingWord& word : words) all.emplace_back(word.word);
  return all;
}

LaboratoryTable::LaboratoryTable(std::filesystem::path file, const MeasuredFile& settings)
    : file_(std::move(file)),
      test_column_(settings.test),
      name_(settings.name)
{
  place_.fill(absent);
  read_rows(settings.kind);
  find_columns(settings);
}

void LaboratoryTable::read_rows(const MeasuredKind& kind)
{
  constexpr std::uintmax_t most_bytes = 20'000'000;
  const FileBytes bytes = read_text(file_, most_bytes);
  if (!bytes.fault.empty()) throw InputError(fmt::format("{}: measured.{}.file: {}", file_.string(), name_, bytes.fault));
  const bool is_ags = file_.extension() == ".ags" || file_.extension() == ".AGS";
  Sheet sheet = is_ags ? sheet_of_ags(file_.string(), bytes.bytes, kind) : sheet_of_csv(file_.string(), bytes.bytes);
  if (sheet.fields.empty()) throw InputError(fmt::format("{}: has no rows below a line of headings", file_.string()));
  if (is_ags) test_column_ = "test";
  for (const std::string& heading : sheet.headings) {
    const auto [name, unit] = split_heading(heading);
    columns_.push_back({heading, name, unit});
  }
  fields_ = std::move(sheet.fields);
  lines_ = std::move(sheet.lines);
}

/// By the whole heading, by the heading without its unit, or by "HEADING (UNIT)" of a heading without one, whose unit is then given.
std::size_t LaboratoryTable::column_named(const std::string& heading, std::string* unit) const
{
  const auto [name, given] = split_heading(heading);
  for (const bool whole : {true, false})
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      const Column& column = columns_[k];
      if (whole ? column.heading != heading : column.name != name || (!given.empty() && !column.unit.empty() && column.unit != given))
        continue;
      if (unit != nullptr) *unit = column.unit.empty() ? given : column.unit;
      return k;
    }
  std::vector<std::string> headings;
  for (const Column& column : columns_) headings.push_back(column.heading);
  throw InputError(fmt::format("{}: there is no column {}, which measured.{} names{}", file_.string(), input::in_quotes(heading), name_,
                               input::suggestion(name, headings)));
}

void LaboratoryTable::find_columns(const MeasuredFile& settings)
{
  for (int r = 0; r < reading_count; ++r) {
    const ReadingWord& word = words[r];
    std::size_t& place = place_[static_cast<std::size_t>(r)];
    std::string& unit = unit_[static_cast<std::size_t>(r)];
    if (const auto named = settings.columns.find(word.word); named != settings.columns.end()) {
      place = column_named(named->second, &unit);
    } else {
      for (std::size_t k = 0; k < columns_.size() && place == absent; ++k) {
        const Column& column = columns_[k];
        const std::string rest =
            column.name.starts_with(std::string(word.word) + "_") ? column.name.substr(std::string(word.word).size() + 1) : "";
        if (column.name == word.word)
          place = k, unit = column.unit;
        else if (!rest.empty() && std::isfinite(size_of_unit(rest, word.unit)))
          place = k, unit = rest;
      }
    }
    if (place == absent) continue;
    const std::string heading = columns_[place].heading, behind = heading.substr(heading.rfind('_') + 1);
    if (unit.empty() && std::isfinite(size_of_unit(behind, word.unit)) && behind != heading) unit = behind;
    if (unit.empty() && needs_unit(static_cast<Reading>(r)))
      throw InputError(fmt::format("{}: the column {} has no unit: measured.{}.columns = {{{} = \"{} ({})\"}}", file_.string(),
                                   input::in_quotes(heading), name_, word.word, heading, usual_units(word.unit).first));
    if (!unit.empty() && !std::isfinite(size_of_unit(unit, word.unit)))
      throw InputError(fmt::format("{}: the column {} is {}, and {} is not a unit of it: {}", file_.string(), input::in_quotes(heading),
                                   word.meaning, input::in_quotes(unit), usual_units(word.unit).second));
  }
  if (!test_column_.empty()) column_named(test_column_, nullptr);
}

Real LaboratoryTable::number(std::size_t column, std::size_t row) const
{
  const std::string& field = fields_[row][column];
  if (field.empty() || field == "nan" || field == "NaN") return nan;
  const std::optional<Real> number = input::number_in(field);
  if (!number)
    refuse(row, fmt::format("{} in the column {} is not a number", input::in_quotes(field), input::in_quotes(columns_[column].heading)));
  return *number;
}

Real LaboratoryTable::value(Reading reading, std::size_t row) const
{
  const std::size_t r = index_of(reading);
  const Real factor = unit_[r].empty() ? 1 : size_of_unit(unit_[r], words[r].unit);
  return factor * number(place_[r], row);
}

Real LaboratoryTable::first_of(const std::string& heading, std::size_t row) const
{
  std::string unit;
  const std::size_t column = column_named(heading, &unit);
  const Real size = unit.empty() || unit == "1" ? 1 : unit == "percent" ? 0.01 : input::to_si("1 " + unit).value;
  const Real found = size * number(column, row);
  if (!std::isfinite(found)) refuse(row, fmt::format("the first row of a test needs a number in the column {}", input::in_quotes(heading)));
  return found;
}

std::string LaboratoryTable::heading_of(Reading reading) const
{
  return has(reading) ? columns_[place_[index_of(reading)]].heading : "";
}

std::string LaboratoryTable::changed_name(std::size_t row) const
{
  for (std::size_t k = 0; row > 0 && k < columns_.size(); ++k)
    if (fields_[row][k] != fields_[row - 1][k] && !fields_[row][k].empty() && !input::number_in(fields_[row][k]))
      return columns_[k].heading;
  return "";
}

bool LaboratoryTable::has_column(const std::string& name) const
{
  return std::any_of(columns_.begin(), columns_.end(), [&](const Column& column) { return column.name == name; });
}

std::vector<std::pair<std::string, std::vector<std::size_t>>> LaboratoryTable::tests() const
{
  std::vector<std::pair<std::string, std::vector<std::size_t>>> all;
  const std::size_t column = test_column_.empty() ? absent : column_named(test_column_, nullptr);
  for (std::size_t row = 0; row < fields_.size(); ++row) {
    const std::string name = column == absent ? name_ : fields_[row][column];
    auto test = std::find_if(all.begin(), all.end(), [&](const auto& other) { return other.first == name; });
    if (test == all.end()) test = all.insert(all.end(), {name, {}});
    test->second.push_back(row);
  }
  return all;
}

void LaboratoryTable::need(const std::vector<Reading>& alternatives) const
{
  if (std::any_of(alternatives.begin(), alternatives.end(), [&](Reading reading) { return has(reading); })) return;
  std::string wanted;
  for (const Reading reading : alternatives)
    wanted += fmt::format("{}{} ({})", wanted.empty() ? "" : ", or ", words[index_of(reading)].word, words[index_of(reading)].meaning);
  std::vector<std::string> headings;
  for (const Column& column : columns_) headings.push_back(column.heading);
  throw InputError(fmt::format("{}: no column is {}: name it, measured.{}.columns = {{{} = \"HEADING (UNIT)\"}}; its headings are {}",
                               file_.string(), wanted, name_, words[index_of(alternatives.front())].word, input::listed(headings)));
}

void LaboratoryTable::need_test(const std::string& name) const
{
  std::vector<std::string> names;
  for (const auto& test : tests()) names.push_back(test.first);
  if (std::find(names.begin(), names.end(), name) == names.end())
    throw InputError(fmt::format("{}: measured.{}: there is no test {}{}", file_.string(), name_, input::in_quotes(name),
                                 input::suggestion(name, names)));
}

std::string LaboratoryTable::words_of(Reading reading) const
{
  return fmt::format("{} in the column {}", words[index_of(reading)].word, input::in_quotes(columns_[place_[index_of(reading)]].heading));
}

void LaboratoryTable::refuse(std::size_t row, const std::string& what) const
{
  throw InputError(fmt::format("{}:{}: {}", file_.string(), lines_[row], what));
}

}  // namespace berm::soil_fit
