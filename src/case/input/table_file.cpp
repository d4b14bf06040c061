// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/input/load_history_test.cpp
#include "input/table_file.hpp"

#include "input/message_text.hpp"
#include "input/text_table.hpp"
#include "input/units.hpp"
#include "os/error.hpp"
#include "os/text_file.hpp"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <sstream>

namespace berm::input {
namespace {

std::string without_capitals(std::string text)
{
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

/// Whether the first field of a line is that of a row of numbers, right or wrong, and not of a header.
bool begins_row(const std::string& field)
{
  const std::string word = without_capitals(field);
  return !field.empty() && (is_digit(field[0]) || std::string_view("+-.").find(field[0]) != std::string_view::npos || word == "nan" ||
                            word == "inf" || word == "infinity");
}

/// "N_m" of a header is the unit N/m, "Nm_m" N m/m.
std::string unit_in(const std::string& written)
{
  std::string unit = written;
  if (const std::size_t line = unit.find('_'); line != std::string::npos) unit[line] = '/';
  if (const std::size_t moment = unit.find("Nm"); moment != std::string::npos) unit.insert(moment + 1, " ");
  return unit;
}

/// "H [N/m]" and "H (N/m)" of a header as "H_N/m".
std::string without_brackets(const std::string& header)
{
  const std::size_t open = header.find_first_of("[("), name = header.find_last_not_of(" _", open - 1);
  if (open == std::string::npos || open == 0 || name == std::string::npos || name >= open) return header;
  return header.substr(0, name + 1) + "_" + header.substr(open + 1, header.find_first_of("])", open) - open - 1);
}

/// How a unit is written in a header.
std::string unit_in_header(const char* unit)
{
  std::string written;
  for (const char* c = unit; *c != '\0'; ++c)
    if (*c != ' ') written += *c == '/' ? '_' : *c;
  return written;
}

/// Reads one file.
class TableFile {
public:
  TableFile(const std::filesystem::path& file, const std::string& text, const TableForm& form, const TakeRow& take_row)
      : file_(file.string()),
        text_(text),
        form_(form),
        take_row_(take_row)
  {
  }

  void read()
  {
    for_each_line([&](const std::vector<std::string>& fields) {
      for (const std::string& field : fields) commas_.see(field);
    });
    for_each_line([&](std::vector<std::string> fields) {
      for (std::string& field : fields) field = commas_.with_point(field);
      const bool header = !begun_ && !begins_row(fields.front());
      if (header) index_ = fields.front().empty();
      if (index_) fields.erase(fields.begin());
      const std::size_t least = header ? 1 : headers_.size();
      while (fields.size() > least && least > 0 && fields.back().empty()) fields.pop_back();
      if (header)
        read_header(fields);
      else
        read_row(fields);
      begun_ = true;
    });
    if (rows_ < 2)
      throw InputError(fmt::format("{}: has {} of numbers: it needs two at least", file_, rows_ == 0 ? "no line" : "one line"));
  }

private:
  /// Gives the fields of each line that counts.
  template <class Take>
  void for_each_line(const Take& take)
  {
    std::istringstream lines(text_);
    std::string line;
    bool first = true;
    for (number_ = 1; std::getline(lines, line); ++number_) {
      if (line.find_first_not_of(" \t\r,;\"") == std::string::npos || line[0] == '#' || (first && says_separator(line))) continue;
      if (first) separator_ = separator_of(line);
      first = false;
      if (!closes_its_quotes(line)) refuse("a quotation mark is not closed");
      take(fields_of(line, separator_));
    }
  }

  [[noreturn]] void refuse(const std::string& why) const { throw InputError(fmt::format("{}:{}: {}", file_, number_, why)); }

  const std::string& name_of(std::size_t k) const { return form_.columns[k].name; }
  const std::string& unit_of(std::size_t k) const { return form_.columns[k].unit; }

  /// How a column is written in SI; of a bare number its name alone.
  static std::string header_of(const TableColumn& column)
  {
    return column.unit.empty() ? column.name : column.name + "_" + unit_in_header(column.unit.c_str());
  }

  /// Whether a header is that of a column: its name and a unit, or of a bare number its name alone.
  bool is_of(const std::string& header, std::size_t k) const
  {
    return header.starts_with(name_of(k) + "_") || (unit_of(k).empty() && header == name_of(k));
  }

  /// Factor from the unit in a header to that of the engine.
  Real scale_of(const std::string& header, const std::string& written, const std::string& si_unit) const
  {
    if (written.empty() && si_unit.empty()) return 1;
    const std::string unit = unit_in(written);
    // A moment per metre run, N m/m, is N.
    if (!unit.empty() && same_dimension(unit, si_unit.empty() ? "1" : si_unit)) try {
        return to_si("1 " + unit, si_unit);
      } catch (const UnitError&) {  // such as "s@2", a scale with an offset
      }
    refuse(fmt::format("{} has no unit of {}: write {}", in_quotes(header), wanted(si_unit),
                       in_quotes(header.substr(0, header.size() - written.size()) + (unit.empty() && !header.ends_with('_') ? "_" : "") +
                                 unit_in_header(si_unit.c_str()))));
  }

  void read_header(std::vector<std::string> names)
  {
    for (std::string& written : names) written = without_brackets(written);
    const std::string &first = names.front(), &name = form_.first.name;
    if (first != name && !first.starts_with(name + "_"))
      refuse(fmt::format("the first column is {}, {}, and not {}", form_.over, in_quotes(header_of(form_.first)), in_quotes(first)));
    const bool factors = form_.factors && names.size() == 2 && names.back() == "factor";
    if (first != name || !factors) scales_.push_back(scale_of(first, first == name ? "" : first.substr(name.size() + 1), form_.first.unit));
    headers_ = names;
    if (factors) return scales_.resize(1, 1);
    if (names.size() < 2) refuse(fmt::format("names no column after {}, such as {}", form_.over, form_.header));
    for (std::size_t n = 1; n < names.size(); ++n) read_name(names[n]);
  }

  /// The known header that was probably meant: of the column whose name it begins with but for capitals, the longest; else the nearest.
  std::string meant_by(const std::string& header, const std::vector<std::string>& known) const
  {
    std::optional<std::size_t> found;
    const auto size = [&](std::size_t k) { return name_of(k).size(); };
    const auto fits = [&](std::size_t k) { return same_dimension(unit_in(header.substr(size(k) + 1)), unit_of(k)); };
    for (std::size_t k = 0; k < form_.columns.size(); ++k)
      if (without_capitals(header).starts_with(without_capitals(name_of(k)) + "_") &&
          (!found || size(k) > size(*found) || (size(k) == size(*found) && !fits(*found) && fits(k))))
        found = k;
    return found ? header_of(form_.columns[*found]) : nearest(header, known);
  }

  [[noreturn]] void refuse_name(const std::string& header) const
  {
    if (form_.factors && header == "factor")
      refuse("\"factor\" must be the only column after the time, since it multiplies what the stage drives: leave out \"factor\", or the "
             "other columns");
    std::vector<std::string> known;
    if (form_.factors) known.emplace_back("factor");
    for (const TableColumn& column : form_.columns) known.push_back(header_of(column));
    const std::string meant = meant_by(header, known);
    refuse(fmt::format("{} is not a column of {}{} (allowed: {}); other units are written likewise, as in {}", in_quotes(header), form_.of,
                       meant.empty() ? "" : fmt::format("; did you mean {}?", in_quotes(meant)), listed(known),
                       form_.factors ? "kN_m" : "cm_s"));
  }

  /// Finds what a column is; the longest name that the header begins with, since "rotation" begins "rotation_z".
  void read_name(const std::string& header)
  {
    std::vector<std::size_t> named;
    for (std::size_t k = 0; k < form_.columns.size(); ++k) {
      const std::string& name = name_of(k);
      if (!is_of(header, k)) continue;
      if (!named.empty() && name.size() > name_of(named.front()).size()) named.clear();
      if (named.empty() || name == name_of(named.front())) named.push_back(k);
    }
    if (named.empty()) refuse_name(header);
    const std::size_t end = name_of(named.front()).size();
    const std::string written = header.size() > end ? header.substr(end + 1) : "";
    const auto fits = [&](std::size_t k) { return same_dimension(unit_in(written), unit_of(k)); };
    const auto found = std::find_if(named.begin(), named.end(), fits);
    const std::size_t k = found == named.end() ? named.front() : *found;
    if (std::find(columns_.begin(), columns_.end(), k) != columns_.end())
      refuse(fmt::format("{} repeats another column", in_quotes(header)));
    scales_.push_back(scale_of(header, written, unit_of(k)));
    columns_.push_back(k);
  }

  std::vector<Real> numbers_of(const std::vector<std::string>& fields) const
  {
    const std::size_t count = columns_.empty() ? 2 : 1 + columns_.size();
    if (columns_.empty() && !form_.factors) refuse("the first line must name the columns: " + form_.header);
    if (fields.size() != count)
      refuse((columns_.empty()
                  ? "a line of a load history is two numbers, time in s and factor: 0.5, 1.2; of more columns the first line is their "
                    "names: time_s,H_N_m,V_N_m"
                  : fmt::format("needs {} numbers, one for each column, and has {}", count, fields.size())) +
             (separator_ == ',' && fields.size() > count ? "; a comma separates numbers: write decimals with a point" : ""));
    std::vector<Real> numbers;
    for (std::size_t n = 0; n < count; ++n) {
      const std::optional<Real> number = number_in(fields[n]);
      const std::string column = headers_.empty() ? fmt::format("{}", n + 1) : in_quotes(headers_[n]);
      if (const std::string fault = fault_of_commas(fields[n]); !number && !fault.empty())
        refuse(fmt::format("{} in column {} {}", in_quotes(fields[n]), column, fault));
      if (!number) refuse(fmt::format("{} in column {} is not a finite number", in_quotes(fields[n]), column));
      numbers.push_back(*number);
    }
    return numbers;
  }

  void read_row(const std::vector<std::string>& fields)
  {
    const std::vector<Real> numbers = numbers_of(fields);
    std::vector<Real> values;
    for (std::size_t n = 1; n < numbers.size(); ++n) values.push_back((columns_.empty() ? 1 : scales_[n]) * numbers[n]);
    ++rows_;
    if (const std::string fault = take_row_(numbers.front() * (scales_.empty() ? 1 : scales_.front()), columns_, values); !fault.empty())
      refuse(fault);
  }

  std::string file_;
  const std::string& text_;
  const TableForm& form_;
  const TakeRow& take_row_;
  std::vector<std::string> headers_;  ///< as they are written; empty where the file has none
  std::vector<std::size_t> columns_;  ///< in the order of the file, without the first
  std::vector<Real> scales_;          ///< to SI: of the first column, then of each other
  DecimalCommas commas_;
  char separator_ = ',';
  int number_ = 0, rows_ = 0;
  bool begun_ = false, index_ = false;  ///< of rows, in a first column without a name
};

}  // namespace

void read_table(const std::string& key, const std::filesystem::path& file, const TableForm& form, const TakeRow& take_row)
{
  constexpr std::uintmax_t max_bytes = 100'000'000;
  const FileBytes found = read_text(file, max_bytes);
  if (!found.fault.empty()) throw KeyError(fmt::format("{}: {}: {}", key, file.string(), found.fault));
  TableFile(file, found.bytes, form, take_row).read();
}

}  // namespace berm::input
