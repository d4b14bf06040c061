// SPDX-License-Identifier: BSD-3-Clause
#include "study/table_axis.hpp"

#include "input/message_text.hpp"
#include "input/text_table.hpp"
#include "input/units.hpp"
#include "os/control_characters.hpp"
#include "os/error.hpp"
#include "os/text_file.hpp"
#include "run_folder/csv_line.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <set>

namespace berm::study {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

constexpr const char* name_column = "name";

std::string trimmed(const std::string& text)
{
  const std::size_t first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t");
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

/// The lines of a table that count, each with its number.
class TableLines {
public:
  explicit TableLines(const fs::path& file) : file_(file)
  {
    constexpr std::uintmax_t max_bytes = 10'000'000;
    FileBytes found = read_text(file, max_bytes);
    if (!found.fault.empty()) throw InputError(one_line(fmt::format("{}: {}", file.string(), found.fault)));
    text_ = std::move(found.bytes);
    if (!text_.empty() && text_.back() != '\n') text_ += '\n';
    std::size_t begin = 0;
    while (begin < text_.size() && text_[begin] == '#') begin = text_.find('\n', begin) + 1;
    const std::string first = text_.substr(begin, text_.find('\n', begin) - begin);
    if (first.find(',') == std::string::npos && first.find(';') != std::string::npos) separator_ = ';';
  }

  bool next(Words& fields)
  {
    while (at_ < text_.size()) {
      line_ += std::count(text_.begin() + counted_, text_.begin() + static_cast<std::ptrdiff_t>(at_), '\n');
      counted_ = static_cast<std::ptrdiff_t>(at_);
      const bool comment = text_[at_] == '#';
      if (comment) {
        at_ = text_.find('\n', at_) + 1;
        continue;
      }
      if (!run_folder::next_csv_line(text_, at_, fields, separator_)) refuse("a quote is not closed");
      for (std::string& field : fields) {
        field = trimmed(input::with_plain_blanks(field));
        if (has_control_character(field))
          refuse(
              fmt::format("{} holds a control character; fields are separated by commas, or all by semicolons", input::in_quotes(field)));
      }
      if (std::any_of(fields.begin(), fields.end(), [](const std::string& field) { return !field.empty(); })) return true;
    }
    return false;
  }

  std::string place() const { return fmt::format("{}:{}", file_.string(), line_); }
  [[noreturn]] void refuse(const std::string& why) const { throw InputError(one_line(fmt::format("{}: {}", place(), why))); }

private:
  fs::path file_;
  std::string text_;
  std::size_t at_ = 0;
  std::ptrdiff_t line_ = 1, counted_ = 0;  ///< of the line that was read last, and where it begins
  char separator_ = ',';
};

struct TableColumn {
  std::string key, unit;
};

/// "KEY" or "KEY (UNIT)".
TableColumn column_of(const std::string& field)
{
  const std::size_t open = field.rfind('(');
  if (open == std::string::npos || field.back() != ')') return {field, ""};
  return {trimmed(field.substr(0, open)), trimmed(field.substr(open + 1, field.size() - open - 2))};
}

std::vector<TableColumn> columns_of(const TableLines& lines, const Words& fields)
{
  std::vector<TableColumn> columns;
  for (const std::string& field : fields) {
    const TableColumn column = column_of(field);
    const bool key = !column.key.empty() && column.key.find('=') == std::string::npos &&
                     std::string("0123456789+-.").find(column.key[0]) == std::string::npos;
    if (!key)
      lines.refuse(fmt::format("{} is not a key; the first line holds keys such as material.sand.friction_angle", input::in_quotes(field)));
    if (std::any_of(columns.begin(), columns.end(), [&](const TableColumn& other) { return other.key == column.key; }))
      lines.refuse(fmt::format("{} heads two columns", input::in_quotes(column.key)));
    columns.push_back(column);
  }
  if (columns.size() == 1 && columns[0].key == name_column) lines.refuse("has no column but `name`");
  return columns;
}

/// The number in a field, in the SI unit of its own; NaN where it is a word or a list.
input::SiQuantity quantity_of(const std::string& field)
{
  return input::is_quantity(field) ? input::to_si(field) : input::SiQuantity{nan, "1"};
}

/// Rows without a name are counted from 1. A parameter has the unit of the first row that says one.
void add_row(const TableLines& lines, const std::vector<TableColumn>& columns, const Words& fields, StudyAxis& axis)
{
  if (fields.size() != columns.size()) lines.refuse(fmt::format("{} fields for {} columns", fields.size(), columns.size()));
  const bool first = axis.value.empty();
  StudyValue value{fmt::format("{}", axis.value.size() + 1), {}, lines.place(), {}};
  for (std::size_t k = 0; k < fields.size(); ++k) {
    const auto& [key, unit] = columns[k];
    if (fields[k].empty()) lines.refuse(fmt::format("{} is empty", key));
    if (key == name_column) {
      if (const std::string fault = fault_of_name(fields[k]); !fault.empty()) lines.refuse(fmt::format("name: {}", fault));
      value.name = fields[k];
      continue;
    }
    const std::string text = unit.empty() ? fields[k] : fields[k] + " " + unit;
    const input::SiQuantity quantity = quantity_of(text);
    value.set.push_back(key + "=" + text);
    value.number.push_back(quantity.value);
    const std::string si_unit = quantity.unit == "1" ? "" : quantity.unit;
    if (first) axis.parameter.push_back({key, si_unit});
    std::string& known = axis.parameter[value.number.size() - 1].unit;
    if (known.empty()) known = si_unit;
  }
  axis.value.push_back(std::move(value));
}

}  // namespace

StudyAxis read_table(const fs::path& file, const std::string& name)
{
  TableLines lines(file);
  Words fields;
  if (!lines.next(fields)) lines.refuse("is empty; the first line holds keys such as material.sand.friction_angle");
  const std::vector<TableColumn> columns = columns_of(lines, fields);
  StudyAxis axis{name, {}, {}, {}};
  std::set<std::string> names;
  while (lines.next(fields)) {
    add_row(lines, columns, fields, axis);
    if (const std::string& row = axis.value.back().name; !names.insert(as_file_name(row)).second)
      lines.refuse(fmt::format("{} is the name, or as a file the name, of a row before it", input::in_quotes(row)));
  }
  if (axis.value.empty()) lines.refuse("there is no row below the keys");
  if (std::none_of(columns.begin(), columns.end(), [](const TableColumn& column) { return column.key == name_column; }))
    axis.sample_from = 0;
  return axis;
}

}  // namespace berm::study
