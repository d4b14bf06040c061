// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/site/sounding_test.cpp
#include "input/message_text.hpp"
#include "input/text_table.hpp"
#include "input/units.hpp"
#include "os/error.hpp"
#include "site/pore_pressure.hpp"
#include "site/table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace berm::site {
namespace {

/// Cones are made for 50 to 100 MPa (ISO 22476-1), and pushed to some 150 m; beyond it is a unit that is wrong.
constexpr Real most_cone_resistance = 100e6, most_depth = 200;

constexpr std::array<const char*, 6> words_of_reading = {
    "depth", "corrected depth", "cone resistance q_c", "corrected cone resistance q_t", "sleeve friction f_s", "pore pressure u_2"};

/// What loggers and spreadsheets write where there is no value, besides what a file declares.
constexpr std::array<const char*, 8> void_words = {"nan", "na", "n/a", "#n/a", "null", "none", "-", "--"};
constexpr std::array<Real, 4> void_numbers = {-999, -999.25, -9999, -99999};

bool is_depth(Reading reading)
{
  return reading == Reading::depth || reading == Reading::corrected_depth;
}

/// A column that is used: its values in SI units, NaN where a row has none; empty where the file has no such column, or one without a value.
using Values = std::vector<Real>;

bool is_void(const std::string& field, const Column& column)
{
  std::string word = field;
  for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (field.empty() || field == column.no_value || std::find(void_words.begin(), void_words.end(), word) != void_words.end()) return true;
  const std::optional<Real> number = input::number_in(field);
  return number && (std::find(void_numbers.begin(), void_numbers.end(), *number) != void_numbers.end() ||
                    number == input::number_in(column.no_value));
}

Real factor_of(const Table& table, const Column& column)
{
  const char* word = words_of_reading[static_cast<std::size_t>(column.reading)];
  const std::string where = fmt::format("{}column {}", at(table.file, column.line), input::in_quotes(column.name)),
                    unit = is_depth(column.reading) ? "m" : "Pa",
                    what = is_depth(column.reading) ? "a length, such as m" : "a pressure, such as MPa or kPa";
  if (column.unit.empty())
    throw InputError(fmt::format("{} gives no unit of the {}, which is {}; a table has it in the name: depth_m,q_c_MPa,f_s_kPa,u_2_kPa",
                                 where, word, what));
  try {
    return input::to_si("1 " + column.unit, unit);
  } catch (const input::UnitError&) {
    throw InputError(fmt::format("{}: {} is not a unit of the {}, which is {}", where, input::in_quotes(column.unit), word, what));
  }
}

/// The column of a reading in SI units; what is wholly empty is noted, and done without.
Values values_of(Table& table, Reading reading)
{
  const Column* found = nullptr;
  for (const Column& column : table.columns) {
    if (column.reading != reading) continue;
    if (found != nullptr)
      throw InputError(fmt::format("{}column {} is the {}, as column {} is", at(table.file, column.line), input::in_quotes(column.name),
                                   words_of_reading[static_cast<std::size_t>(reading)], input::in_quotes(found->name)));
    found = &column;
  }
  if (found == nullptr) return {};
  const auto place = static_cast<std::size_t>(found - table.columns.data());
  const Real factor = factor_of(table, *found);
  Values values;
  for (const Row& row : table.rows)
    values.push_back(is_void(row.fields[place], *found)
                         ? nan
                         : factor * number_of(row.fields[place], table.file, row.line, "column " + input::in_quotes(found->name)));
  if (std::any_of(values.begin(), values.end(), [](Real value) { return !std::isnan(value); })) return values;
  table.notes.push_back(
      fmt::format("column {}, the {}, is empty", input::in_quotes(found->name), words_of_reading[static_cast<std::size_t>(reading)]));
  return {};
}

bool has(const Values& values, std::size_t row)
{
  return !values.empty() && !std::isnan(values[row]);
}

/// Rows whose fields are those of the columns, with points for decimal commas.
void take_apart(Table& table)
{
  input::DecimalCommas commas;
  for (const Row& row : table.rows) {
    if (row.fields.size() != table.columns.size())
      throw InputError(
          fmt::format("{}has {} values, and {} columns were named", at(table.file, row.line), row.fields.size(), table.columns.size()));
    for (std::size_t i = 0; i < row.fields.size(); ++i)
      if (table.columns[i].reading != Reading::other) commas.see(row.fields[i]);
  }
  for (Row& row : table.rows)
    for (std::string& field : row.fields) field = commas.with_point(field);
  for (Column& column : table.columns) column.no_value = commas.with_point(column.no_value);
}

void leave_out(Sounding& sounding, const std::string& why)
{
  for (LeftOut& one : sounding.left_out)
    if (one.why == why) return static_cast<void>(++one.rows);
  sounding.left_out.push_back({why, 1});
}

/// Why a row does not count; "" where it does.
std::string why_left_out(const Sounding& sounding, Real depth, Real resistance, Real dug_to)
{
  if (std::isnan(depth)) return "without a depth";
  if (std::isnan(resistance)) return "without a cone resistance";
  if (depth < 0) return "above the seabed";
  if (depth < dug_to) return fmt::format("in the predrilled hole, to {:.2f} m", dug_to);
  if (!sounding.depth.empty() && depth <= sounding.depth.back()) return "not deeper than the row before";
  return "";
}

/// The columns of a table that are used.
struct Readings {
  Values length, corrected, q_c, q_t, f_s, u_2;

  explicit Readings(Table& table)
      : length(values_of(table, Reading::depth)),
        corrected(values_of(table, Reading::corrected_depth)),
        q_c(values_of(table, Reading::q_c)),
        q_t(values_of(table, Reading::q_t)),
        f_s(values_of(table, Reading::f_s)),
        u_2(values_of(table, Reading::u_2))
  {
    if (length.empty() && corrected.empty())
      throw InputError(fmt::format("{}: has no column of the depth with a value: a table names it depth_m", table.file));
    if (q_t.empty() && q_c.empty())
      throw InputError(
          fmt::format("{}: has no column of the cone resistance, q_c or q_t, with a value: a table names it q_c_MPa", table.file));
  }
  Real depth(std::size_t row) const { return has(corrected, row) ? corrected[row] : has(length, row) ? length[row] : nan; }
  Real resistance(std::size_t row) const { return has(q_t, row) ? q_t[row] : has(q_c, row) ? q_c[row] : nan; }
};

/// Rows that count, by what their values come from.
struct Origins {
  Index given = 0, corrected = 0, as_measured = 0, by_length = 0, without_friction = 0;
};

/// Says how q_t came about, and what single rows were done without.
void say_origins(Sounding& sounding, const Origins& rows, const Table& table, bool has_u_2)
{
  const std::string correction = fmt::format("q_c + (1 - {:.3g}) u_2", table.area_ratio.value_or(1));
  const char* missing = has_u_2 ? "the area ratio of the cone" : table.area_ratio ? "u_2" : "u_2 and the area ratio of the cone";
  sounding.corrected = rows.given > 0       ? "q_t as in the file"
                       : rows.corrected > 0 ? "q_t = " + correction
                                            : fmt::format("q_c for q_t: the file does not say {}", missing);
  const auto note = [&](Index count, const std::string& what) {
    if (count > 0) sounding.notes.push_back(fmt::format("{} {} {}", count, count == 1 ? "row has" : "rows have", what));
  };
  if (rows.given > 0) note(rows.corrected, "no q_t: it is " + correction + " there");
  if (rows.given + rows.corrected > 0) note(rows.as_measured, rows.given > 0 ? "no q_t: it is q_c there" : "no u_2: q_t is q_c there");
  note(rows.without_friction, "no f_s: the mean friction ratio is without them");
  note(rows.by_length, "no corrected depth: it is the length of penetration there");
}

void refuse_unit(const Sounding& sounding, const Readings& all)
{
  for (std::size_t row = 0; row < static_cast<std::size_t>(sounding.rows); ++row) {
    if (all.resistance(row) > most_cone_resistance)
      throw InputError(
          fmt::format("{}: the cone resistance is {:.4g} MPa at {:.2f} m, and no cone withstands more than {:g} MPa: is its unit right? "
                      "Values in kPa have the unit kPa",
                      sounding.file, all.resistance(row) / 1e6, all.depth(row), most_cone_resistance / 1e6));
    if (all.depth(row) > most_depth)
      throw InputError(
          fmt::format("{}: the depth is {:.4g} m, and no cone is pushed to {:g} m: is its unit right? Values in cm have the unit cm",
                      sounding.file, all.depth(row), most_depth));
  }
}

[[noreturn]] void refuse_few(const Sounding& sounding)
{
  Index above = 0;
  for (const LeftOut& one : sounding.left_out)
    if (one.why == "above the seabed") above = one.rows;
  throw InputError(fmt::format("{}, and two are needed at least{}", rows_of(sounding),
                               above > 0           ? ": depths are positive below the seabed"
                               : sounding.rows > 2 ? ": depths ascend, and each row has a cone resistance"
                                                   : ""));
}

}  // namespace

Sounding sounding_of(Table table)
{
  take_apart(table);
  Readings all(table);
  Sounding sounding;
  sounding.file = table.file;
  sounding.rows = static_cast<Index>(table.rows.size());
  refuse_unit(sounding, all);
  const bool correct = table.area_ratio && !all.u_2.empty() && !all.q_c.empty();
  std::vector<Real> depth(table.rows.size());
  for (std::size_t row = 0; row < depth.size(); ++row) depth[row] = all.depth(row);
  if (correct) make_plausible(table.file, depth, all.q_c, *table.area_ratio, all.u_2, table.notes);
  if (!all.q_t.empty() && !all.q_c.empty() && !all.u_2.empty())
    if (const std::string doubt = doubt_of_given(depth, all.q_c, all.q_t, all.u_2); !doubt.empty()) table.notes.push_back(doubt);
  Origins origins;
  for (std::size_t row = 0; row < depth.size(); ++row) {
    if (const std::string why = why_left_out(sounding, depth[row], all.resistance(row), table.dug_to); !why.empty()) {
      leave_out(sounding, why);
      continue;
    }
    const bool with_u = !has(all.q_t, row) && correct && has(all.u_2, row);
    ++(has(all.q_t, row) ? origins.given : with_u ? origins.corrected : origins.as_measured);
    origins.by_length += all.corrected.empty() || has(all.corrected, row) ? 0 : 1;
    origins.without_friction += !all.f_s.empty() && !has(all.f_s, row) ? 1 : 0;
    sounding.depth.push_back(depth[row]);
    sounding.q_t.push_back(all.resistance(row) + (with_u ? (1 - *table.area_ratio) * all.u_2[row] : 0));
    if (!all.f_s.empty()) sounding.f_s.push_back(all.f_s[row]);
    if (!all.u_2.empty()) sounding.u_2.push_back(all.u_2[row]);
  }
  if (sounding.depth.size() < 2) refuse_few(sounding);
  sounding.notes = table.notes;
  say_origins(sounding, origins, table, !all.u_2.empty());
  return sounding;
}

}  // namespace berm::site
