// SPDX-License-Identifier: BSD-3-Clause
#include "input/text_table.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fmt/format.h>

namespace berm::input {
namespace {

/// Whether `mark` stands in a number as it does between thousands: behind one to three digits that do not begin with 0, before each further three.
bool groups_thousands(std::string_view number, char mark)
{
  if (!number.empty() && (number[0] == '-' || number[0] == '+')) number.remove_prefix(1);
  std::size_t at = number.find(mark);
  if (at == 0 || at > 3 || number[0] == '0') return false;
  for (; at < number.size() && number[at] == mark; at += 4)
    if (number.size() < at + 4 || !is_digit(number[at + 1]) || !is_digit(number[at + 2]) || !is_digit(number[at + 3])) return false;
  return at == number.size() || (!is_digit(number[at]) && number[at] != mark);
}

std::string without(std::string text, char mark)
{
  text.erase(std::remove(text.begin(), text.end(), mark), text.end());
  return text;
}

/// The number with a point for its only comma; "" where that is none.
std::string pointed(std::string text)
{
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos) return "";
  text[comma] = '.';
  return number_in(text) ? text : "";
}

}  // namespace

bool is_digit(char c)
{
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

std::string with_plain_blanks(std::string text)
{
  constexpr std::array<std::pair<std::string_view, char>, 8> signs = {{{"\u00A0", ' '},
                                                                       {"\u2007", ' '},
                                                                       {"\u2008", ' '},
                                                                       {"\u2009", ' '},
                                                                       {"\u200A", ' '},
                                                                       {"\u202F", ' '},
                                                                       {"\u205F", ' '},
                                                                       {"\u2212", '-'}}};
  if (std::all_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80; })) return text;
  for (const auto& [sign, plain] : signs)
    for (std::size_t at = 0; (at = text.find(sign, at)) != std::string::npos;) text.replace(at, sign.size(), 1, plain);
  return text;
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
    field = with_plain_blanks(std::move(field));
    const std::size_t begin = field.find_first_not_of(" \t\"\r"), end = field.find_last_not_of(" \t\"\r");
    field = begin == std::string::npos ? "" : field.substr(begin, end + 1 - begin);
  }
  return fields;
}

bool closes_its_quotes(std::string_view line)
{
  return std::count(line.begin(), line.end(), '"') % 2 == 0;
}

char separator_of(std::string_view line)
{
  for (const char one : {';', '\t'})
    if (fields_of(line, one).size() > 1) return one;
  return ',';
}

bool says_separator(std::string_view line)
{
  return line.starts_with("sep=") || line.starts_with("\"sep=");
}

std::optional<Real> number_in(const std::string& text)
{
  const bool plus = text.size() > 1 && text[0] == '+' && (is_digit(text[1]) || text[1] == '.');
  const char *first = text.data() + (plus ? 1 : 0), *last = text.data() + text.size();
  Real number = 0;
  const auto [rest, error] = std::from_chars(first, last, number);
  if (error != std::errc() || rest != last || !std::isfinite(number)) return std::nullopt;
  return number;
}

std::string fault_of_commas(const std::string& text)
{
  if (text.find_first_not_of("+-0123456789., eE") != std::string::npos) return "";
  const auto write = [](std::string number, const char* what) {
    return number_in(number) ? fmt::format("has {}: write {}", what, number) : "";
  };
  const bool commas = groups_thousands(text, ',');
  if (const std::string decimal = pointed(text); !decimal.empty() && commas)
    return fmt::format("is {} if its comma separates thousands, and {} if it is a decimal comma: write one of them", without(text, ','),
                       decimal);
  else if (!decimal.empty())
    return fmt::format("has a decimal comma: write {}", decimal);
  if (commas) return write(without(text, ','), "commas between thousands");
  if (groups_thousands(text, ' ')) return write(without(text, ' '), "blanks between thousands");
  if (groups_thousands(text, '.')) return write(pointed(without(text, '.')), "points between thousands and a decimal comma");
  return "";
}

void DecimalCommas::see(const std::string& field)
{
  if (field.find(',') != std::string::npos)
    comma_ |= !pointed(field).empty() && !groups_thousands(field, ',');
  else
    point_ |= field.find('.') != std::string::npos && number_in(field).has_value();
}

std::string DecimalCommas::with_point(const std::string& field) const
{
  const std::string point = comma_ && !point_ ? pointed(field) : "";
  return point.empty() ? field : point;
}

}  // namespace berm::input
