// SPDX-License-Identifier: BSD-3-Clause
#include "site/sounding.hpp"

#include "core/error.hpp"
#include "core/read_file.hpp"
#include "input/message_text.hpp"
#include "input/units.hpp"
#include "site/table.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fmt/format.h>

namespace berm::site {
namespace {

constexpr std::array<const char*, 5> words = {"depth", "cone resistance q_c", "corrected cone resistance q_t", "sleeve friction f_s",
                                              "pore pressure u_2"};

/// The columns that are used, each with the factor to its SI unit; none where the file has no such column.
struct Used {
  std::optional<std::size_t> place;
  Real factor = 1;
};

Used find(const Table& table, Reading reading)
{
  Used used;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const Column& column = table.columns[i];
    if (column.reading != reading) continue;
    const char* word = words[static_cast<std::size_t>(reading)];
    if (used.place)
      throw InputError(fmt::format("{}column {} is the {}, as column {} is", at(table.file, column.line), input::in_quotes(column.name),
                                   word, input::in_quotes(table.columns[*used.place].name)));
    const std::string unit = reading == Reading::depth ? "m" : "Pa";
    try {
      used = {i, input::to_si("1 " + column.unit, unit)};
    } catch (const input::UnitError&) {
      throw InputError(fmt::format("{}column {}: {} is no unit of the {}, which is {}", at(table.file, column.line),
                                   input::in_quotes(column.name), input::in_quotes(column.unit), word,
                                   unit == "m" ? "a length, such as m" : "a pressure, such as MPa or kPa"));
    }
  }
  return used;
}

Real value(const Table& table, const Row& row, const Used& used)
{
  return used.factor *
         number_of(row.fields[*used.place], table.file, row.line, "column " + input::in_quotes(table.columns[*used.place].name));
}

Sounding sounding_of(const Table& table)
{
  const Used depth = find(table, Reading::depth), q_c = find(table, Reading::q_c), q_t = find(table, Reading::q_t),
             f_s = find(table, Reading::f_s), u_2 = find(table, Reading::u_2);
  if (!depth.place) throw InputError(fmt::format("{}: has no column of the depth", table.file));
  if (!q_t.place && !q_c.place) throw InputError(fmt::format("{}: has no column of the cone resistance, q_c or q_t", table.file));
  const Used& q = q_t.place ? q_t : q_c;
  const bool correct = !q_t.place && u_2.place && table.area_ratio;
  Sounding sounding;
  sounding.file = table.file;
  sounding.corrected =
      q_t.place ? "q_t as in the file"
      : correct ? fmt::format("q_t = q_c + (1 - {:.3g}) u_2", *table.area_ratio)
                : fmt::format("q_c for q_t: the file does not say {}", u_2.place          ? "the area ratio of the cone"
                                                                       : table.area_ratio ? "u_2"
                                                                                          : "u_2 and the area ratio of the cone");
  for (const Row& row : table.rows) {
    if (row.fields.size() != table.columns.size())
      throw InputError(
          fmt::format("{}has {} values, and {} columns were named", at(table.file, row.line), row.fields.size(), table.columns.size()));
    if (std::any_of(row.fields.begin(), row.fields.end(), [&](const std::string& field) {
          const auto place = static_cast<std::size_t>(&field - row.fields.data());
          return field.empty() && table.columns[place].reading != Reading::other;
        })) {
      ++sounding.left_out;
      continue;
    }
    const Real z = value(table, row, depth);
    if (z < 0)
      throw InputError(fmt::format("{}column {}: a depth of {} m lies above the seabed", at(table.file, row.line),
                                   input::in_quotes(table.columns[*depth.place].name), z));
    if (!sounding.depth.empty() && z <= sounding.depth.back())
      throw InputError(fmt::format("{}column {}: {} m comes after {} m, and depths ascend", at(table.file, row.line),
                                   input::in_quotes(table.columns[*depth.place].name), z, sounding.depth.back()));
    sounding.depth.push_back(z);
    const Real u = u_2.place ? value(table, row, u_2) : 0;
    sounding.q_t.push_back(value(table, row, q) + (correct ? (1 - *table.area_ratio) * u : 0));
    if (f_s.place) sounding.f_s.push_back(value(table, row, f_s));
    if (u_2.place) sounding.u_2.push_back(u);
  }
  if (sounding.depth.size() < 2)
    throw InputError(fmt::format("{}: has {} rows with all values, and two are needed at least", table.file, sounding.depth.size()));
  return sounding;
}

}  // namespace

Sounding read_sounding(const std::filesystem::path& file, const std::string& location)
{
  std::string kind = file.extension().string();
  std::transform(kind.begin(), kind.end(), kind.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (kind != ".ags" && kind != ".gef" && kind != ".csv")
    throw InputError(fmt::format("{}: a sounding is a file of AGS 4 (.ags), GEF (.gef) or a table (.csv)", file.string()));
  if (kind != ".ags" && !location.empty()) throw InputError(fmt::format("{}: only a file of AGS names its locations", file.string()));
  const auto [text, fault] = read_file(file, 100'000'000);
  if (!fault.empty()) throw InputError(fmt::format("{}: {}", file.string(), fault));
  return sounding_of(kind == ".ags"   ? read_ags(file.string(), text, location)
                     : kind == ".gef" ? read_gef(file.string(), text)
                                      : read_csv(file.string(), text));
}

Real friction_ratio(const Sounding& sounding, Real submerged_unit_weight)
{
  Real sum = 0;
  Index count = 0;
  for (std::size_t i = 0; i < sounding.f_s.size(); ++i) {
    const Real net = sounding.q_t[i] - (submerged_unit_weight + 9810) * sounding.depth[i];
    if (net <= 0) continue;
    sum += sounding.f_s[i] / net;
    ++count;
  }
  return count > 0 ? sum / static_cast<Real>(count) : 0;
}

std::vector<std::string> fields_of(std::string_view line, char separator)
{
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') quoted = !quoted;
    if (c == separator && !quoted)
      fields.emplace_back();
    else
      fields.back() += c;
  }
  for (std::string& field : fields) {
    const std::size_t begin = field.find_first_not_of(" \t\"\r"), end = field.find_last_not_of(" \t\"\r");
    field = begin == std::string::npos ? "" : field.substr(begin, end + 1 - begin);
  }
  return fields;
}

Real number_of(const std::string& text, const std::string& file, int line, const std::string& of)
{
  Real number = 0;
  const char *first = text.data() + (text.starts_with('+') ? 1 : 0), *last = text.data() + text.size();
  const auto [rest, error] = std::from_chars(first, last, number);
  if (error != std::errc() || rest != last || !std::isfinite(number))
    throw InputError(fmt::format("{}{}: {} is no number", at(file, line), of, input::in_quotes(text)));
  return number;
}

Real area_ratio_of(const std::string& text, const std::string& file, int line, const std::string& of)
{
  const Real ratio = number_of(text, file, line, of);
  if (!(ratio > 0 && ratio <= 1))
    throw InputError(fmt::format(
        "{}{}: the area ratio of a cone is above 0 and at most 1, such as 0.8, and this is {:g}; leave it out where it is not known",
        at(file, line), of, ratio));
  return ratio;
}

std::string at(const std::string& file, int line)
{
  return fmt::format("{}:{}: ", file, line);
}

}  // namespace berm::site
