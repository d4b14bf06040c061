// SPDX-License-Identifier: BSD-3-Clause
#include "workbook/workbook.hpp"

#include "input/units.hpp"
#include "io/atomic_file.hpp"
#include "io/scratch_folder.hpp"
#include "os/error.hpp"
#include "run_folder/csv_line.hpp"
#include "run_folder/summary_file.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <xlsxwriter.h>

namespace berm::workbook {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_rows = LXW_ROW_MAX;

/// A unit that numbers are written in, and what one of it is in SI.
struct OtherUnit {
  std::string name;
  double size;
};

/// One of a unit in SI; none where berm does not know its dimension.
std::optional<input::SiQuantity> one_of(const std::string& unit)
{
  try {
    return input::to_si("1 " + unit);
  } catch (const input::UnitError&) {
    return {};
  }
}

/// The imperial unit of a quantity of that unit; none of another dimension.
std::optional<OtherUnit> imperial_of(const std::string& unit)
{
  constexpr std::array units = {"ft", "lbf", "lbf/ft", "lbf/ft^2", "lbf/ft^3", "ft/s", "lb/ft", "lb/ft^3", "ft^2", "ft^3"};
  constexpr double small = 0.01;  // m, of a unit of length that becomes inches
  const std::optional<input::SiQuantity> one = one_of(unit);
  if (!one) return {};
  for (const char* other : units) {
    const std::optional<input::SiQuantity> of = one_of(other);
    if (!of || !input::same_dimension(one->unit, of->unit)) continue;
    const std::string name = std::string(other) == "ft" && one->value <= small ? "in" : other;
    return OtherUnit{name, one_of(name)->value / one->value};
  }
  return {};
}

/// A column whose name ends with a unit that has an imperial one: H_N_m is in N/m.
struct Named {
  std::string name, unit;
};

std::optional<Named> unit_in(const std::string& column)
{
  for (std::size_t at = column.find('_'); at != std::string::npos; at = column.find('_', at + 1)) {
    std::string unit = column.substr(at + 1);
    if (const std::size_t over = unit.find('_'); over != std::string::npos) unit[over] = '/';
    if (unit.find('_') == std::string::npos && imperial_of(unit)) return Named{column.substr(0, at), unit};
  }
  return {};
}

std::string file_name_of(std::string unit)
{
  std::replace(unit.begin(), unit.end(), '/', '_');
  std::erase(unit, ' '), std::erase(unit, '^');
  return unit;
}

Sheet::Cell cell_of(const std::string& text, double size)
{
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return text;
  return std::isfinite(number) ? Sheet::Cell(number / size) : Sheet::Cell("");
}

Sheet results_of(const run_folder::RunSummary& summary, Units units)
{
  Sheet sheet{.name = "results", .rows = {{"quantity", "value", "unit", "meaning"}}};
  for (const run_folder::Quantity& q : summary.quantities) {
    const std::optional<OtherUnit> other = units == Units::imperial ? imperial_of(q.unit) : std::nullopt;
    const Sheet::Cell value = std::isfinite(q.value) ? Sheet::Cell(q.value / (other ? other->size : 1)) : Sheet::Cell("");
    sheet.rows.push_back({q.name, value, other ? other->name : q.unit, q.meaning});
  }
  return sheet;
}

Sheet table_of(const fs::path& file, Units units)
{
  Sheet sheet{.name = file.stem().string(), .rows = {}};
  std::string text = io::read_text_file(file);
  if (!text.ends_with('\n')) text += '\n';
  std::vector<std::string> fields;
  std::vector<double> sizes;
  bool named = false;
  for (std::size_t at = 0; run_folder::next_csv_line(text, at, fields);) {
    std::vector<Sheet::Cell> row;
    if (!named && fields.front().starts_with('#')) {
      std::string note;
      for (const std::string& field : fields) note += (note.empty() ? "" : ",") + field;
      row.emplace_back(note);
    } else if (!named) {
      named = true;
      sheet.names_row = sheet.rows.size();
      for (std::string& name : fields) {
        const std::optional<Named> parts = units == Units::imperial ? unit_in(name) : std::nullopt;
        const std::optional<OtherUnit> other = parts ? imperial_of(parts->unit) : std::nullopt;
        sizes.push_back(other ? other->size : 1);
        row.emplace_back(other ? parts->name + '_' + file_name_of(other->name) : name);
      }
    } else {
      for (std::size_t k = 0; k < fields.size(); ++k) row.push_back(cell_of(fields[k], k < sizes.size() ? sizes[k] : 1));
    }
    sheet.rows.push_back(std::move(row));
  }
  if (sheet.rows.size() > most_rows)
    throw RunError(fmt::format("{} has {} rows, and a sheet holds {}", file.string(), sheet.rows.size(), most_rows));
  return sheet;
}

std::string in_lower_case(std::string text)
{
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

/// A name that a sheet may have, and no other of these has, whatever its case. Excel keeps "history" for itself.
std::string sheet_name(std::string name, std::vector<std::string>& taken)
{
  constexpr std::size_t longest = 31;
  if (in_lower_case(name) == "history") name = "rows of history";
  for (char& c : name)
    if (static_cast<unsigned char>(c) > 126) c = '_';
  for (char& c : name)
    if (std::string_view("[]:*?/\\'").find(c) != std::string_view::npos) c = '_';
  name.resize(std::min(name.size(), longest));
  std::string unique = name;
  for (int k = 2; std::find(taken.begin(), taken.end(), in_lower_case(unique)) != taken.end(); ++k) {
    const std::string end = fmt::format("_{}", k);
    unique = name.substr(0, longest - end.size()) + end;
  }
  taken.push_back(in_lower_case(unique));
  return unique;
}

}  // namespace

std::vector<Sheet> sheets_of(const fs::path& folder, Units units)
{
  std::vector<Sheet> sheets;
  if (const std::optional<run_folder::RunSummary> summary = run_folder::read_summary(folder)) sheets.push_back(results_of(*summary, units));
  std::vector<fs::path> tables;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.is_regular_file() && entry.path().extension() == ".csv") tables.push_back(entry.path());
  std::sort(tables.begin(), tables.end());
  for (const fs::path& table : tables) sheets.push_back(table_of(table, units));
  if (sheets.empty())
    throw InputError(fmt::format("{} has neither summary.json nor a .csv: --to xlsx takes a folder with results", folder.string()));
  return sheets;
}

std::string xlsx_of(const std::vector<Sheet>& sheets)
{
  const io::ScratchFolder scratch;
  const fs::path file = scratch.path() / "tables.xlsx";
  lxw_workbook_options options{};
  options.constant_memory = LXW_TRUE;
  std::string temporary = scratch.path().string();
  options.tmpdir = temporary.data();
  lxw_workbook* book = workbook_new_opt(file.c_str(), &options);
  if (book == nullptr) throw RunError("a workbook cannot be made");
  lxw_format* bold = workbook_add_format(book);
  format_set_bold(bold);
  std::vector<std::string> taken;
  for (const Sheet& sheet : sheets) {
    lxw_worksheet* page = workbook_add_worksheet(book, sheet_name(sheet.name, taken).c_str());
    if (page == nullptr) throw RunError(fmt::format("a workbook cannot have a sheet for {}", sheet.name));
    worksheet_freeze_panes(page, static_cast<lxw_row_t>(sheet.names_row + 1), 0);
    for (std::size_t row = 0; row < sheet.rows.size(); ++row)
      for (std::size_t column = 0; column < sheet.rows[row].size(); ++column) {
        const auto at = std::pair{static_cast<lxw_row_t>(row), static_cast<lxw_col_t>(column)};
        const auto* text = std::get_if<std::string>(&sheet.rows[row][column]);
        const lxw_error error =
            text != nullptr ? worksheet_write_string(page, at.first, at.second, text->c_str(), row == sheet.names_row ? bold : nullptr)
                            : worksheet_write_number(page, at.first, at.second, std::get<double>(sheet.rows[row][column]), nullptr);
        if (error != LXW_NO_ERROR)
          throw RunError(fmt::format("{} does not go into a workbook: row {}: {}", sheet.name, row + 1, lxw_strerror(error)));
      }
  }
  if (const lxw_error error = workbook_close(book); error != LXW_NO_ERROR)
    throw RunError(fmt::format("a workbook cannot be made: {}", lxw_strerror(error)));
  return io::read_text_file(file);
}

}  // namespace berm::workbook
