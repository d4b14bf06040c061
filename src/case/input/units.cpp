// SPDX-License-Identifier: BSD-3-Clause
#include "input/units.hpp"

#include "input/message_text.hpp"
#include "input/text_table.hpp"
#include "os/error.hpp"

#include <charconv>
#include <cstring>
#include <fmt/format.h>
#include <limits>
#include <locale.h>
#include <memory>
#include <udunits2.h>

namespace berm::input {
namespace {

struct Dimension {
  const char *si_unit, *what, *example, *other_example;
};
constexpr Dimension dimensions[] = {
    {"", "a dimensionless number", "0.3", "30 %"},
    {"m", "a length", "20 mm", "0.8 m"},
    {"s", "a time", "0.5 s", "20 ms"},
    {"kg", "a mass", "100 kg", "1.5 t"},
    {"rad", "an angle", "35 deg", "0.6 rad"},
    {"m/s", "a velocity", "0.1 m/s", "20 mm/s"},
    {"m/s^2", "an acceleration", "-9.81 m/s^2", "-50 gravity"},
    {"rad/m", "a wave number", "3.14 rad/m", "180 deg/m"},
    {"rad/s", "an angular velocity", "0.1 rad/s", "5 deg/s"},
    {"rad/s^2", "an angular acceleration", "2 rad/s^2", "90 deg/s^2"},
    {"1/s", "a rate", "0.1 1/s", "5 Hz"},
    {"kg/m", "a mass per length", "100 kg/m", "0.1 t/m"},
    {"kg/m^3", "a density", "1800 kg/m^3", "1.8 g/cm^3"},
    {"Pa", "a pressure or stress", "7 MPa", "20 kPa"},
    {"Pa/m", "a stress per length", "2 kPa/m", "2000 Pa/m"},
    {"N", "a force", "500 N", "2 kN"},
    {"N/m", "a force per length", "500 N/m", "2 kN/m"},
    {"N s", "an impulse", "2 N s", "0.5 kN s"},
    {"N m s", "an angular momentum", "2 N m s", "0.5 kN m s"},
    {"N/m^3", "a weight per volume", "18 kN/m^3", "8000 N/m^3"},
    {"J", "an energy", "5 J", "2 kJ"},
    {"J/m", "an energy per length", "5 J/m", "2 kJ/m"},
};

struct Free {
  void operator()(ut_unit* unit) const { ut_free(unit); }
  void operator()(cv_converter* converter) const { cv_free(converter); }
};
using Unit = std::unique_ptr<ut_unit, Free>;

/// UDUNITS-2 reads numbers, those of its own table too, with the decimal sign of the locale: of a program that loads berm this may be a comma.
class WithDecimalPoint {
public:
  WithDecimalPoint() : plain_(::newlocale(LC_ALL_MASK, "C", nullptr)), before_(::uselocale(plain_)) {}
  ~WithDecimalPoint()
  {
    ::uselocale(before_);
    ::freelocale(plain_);
  }
  WithDecimalPoint(const WithDecimalPoint&) = delete;
  WithDecimalPoint& operator=(const WithDecimalPoint&) = delete;

private:
  locale_t plain_, before_;
};

ut_system* unit_system()
{
  static ut_system* const system = [] {
    const WithDecimalPoint here;
    ut_set_error_message_handler(ut_ignore);
    ut_system* read = ut_read_xml(nullptr);
    if (read == nullptr) throw RunError("the table of units of UDUNITS-2 cannot be read; is the package libudunits2-data installed?");
    const Unit degree(ut_get_unit_by_name(read, "degree"));
    ut_map_symbol_to_unit("deg", UT_ASCII, degree.get());
    return read;
  }();
  return system;
}

Unit parse_unit(const std::string& text)
{
  bool ascii = true;
  for (const char c : text) ascii = ascii && static_cast<unsigned char>(c) < 0x80;
  const WithDecimalPoint here;
  return Unit(ut_parse(unit_system(), text.c_str(), ascii ? UT_ASCII : UT_UTF8));
}

bool is_radian(const ut_unit* basic)
{
  const char* symbol = ut_get_symbol(basic, UT_ASCII);
  return symbol != nullptr && std::strcmp(symbol, "rad") == 0;
}

/// The exponent of the radian in a unit, which UDUNITS-2 takes for a dimensionless number.
int power_of_radian(const ut_unit* unit)
{
  ut_visitor visitor{};
  visitor.visit_basic = [](const ut_unit* basic, void* power) {
    *static_cast<int*>(power) += is_radian(basic) ? 1 : 0;
    return UT_SUCCESS;
  };
  visitor.visit_product = [](const ut_unit*, int count, const ut_unit* const* basic, const int* powers, void* power) {
    for (int k = 0; k < count; ++k) *static_cast<int*>(power) += is_radian(basic[k]) ? powers[k] : 0;
    return UT_SUCCESS;
  };
  visitor.visit_galilean = [](const ut_unit*, double, const ut_unit* underlying, double, void* power) {
    *static_cast<int*>(power) += power_of_radian(underlying);
    return UT_SUCCESS;
  };
  visitor.visit_timestamp = [](const ut_unit*, const ut_unit*, double, void*) { return UT_SUCCESS; };
  visitor.visit_logarithmic = [](const ut_unit*, double, const ut_unit*, void*) { return UT_SUCCESS; };
  int power = 0;
  ut_accept_visitor(unit, &visitor, &power);
  return power;
}

/// The same without letters outside ASCII that occur in units.
std::string without_letters_of_units(std::string text)
{
  for (const char* letter : {"µ", "μ", "°", "·", "²", "³"})
    for (std::size_t at; (at = text.find(letter)) != std::string::npos;) text.erase(at, std::strlen(letter));
  return text;
}

/// UDUNITS-2 multiplies, it would read "3 20 mm" as 60 mm, and it overlooks letters that it does not know. Here the only numbers in a unit are
/// exponents, and the 1 of "1/s".
bool spelled_as_unit(const std::string& unit)
{
  const std::string text = without_letters_of_units(unit);
  const auto digit = [&](std::size_t k) { return text[k] >= '0' && text[k] <= '9'; };
  const auto letter = [&](std::size_t k) { return (text[k] >= 'a' && text[k] <= 'z') || (text[k] >= 'A' && text[k] <= 'Z'); };
  const auto carries_exponent = [&](std::size_t k) {
    return letter(k) || text[k] == '^' || (k > 0 && text[k] == '*' && text[k - 1] == '*');
  };
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (!digit(k) && !letter(k) && std::string_view("_%^*/.-+() ").find(text[k]) == std::string_view::npos) return false;
    const bool begins_number = digit(k) && (k == 0 || !digit(k - 1));
    if (!begins_number || (k == 0 && text.starts_with("1/"))) continue;
    const std::size_t before = k > 0 && (text[k - 1] == '-' || text[k - 1] == '+') ? k - 1 : k;
    if (before == 0 || !carries_exponent(before - 1)) return false;
  }
  return true;
}

std::string trimmed(const std::string& text)
{
  const std::size_t first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t");
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

/// A text split into the number as it is written and the name of its unit ("" = none).
struct Written {
  Real number;
  std::string unit;
};

/// The digits that a quantity begins with, with commas, points and blanks between them.
std::string digits_of(const std::string& quantity)
{
  const std::string begin = quantity.substr(0, quantity.find_first_not_of("+-0123456789., "));
  return begin.substr(0, begin.find_last_not_of("., ") + 1);
}

[[noreturn]] void refuse_text(const std::string& text, const std::string& why, const std::string& wanted_words)
{
  throw UnitError(fmt::format("{} {}; expected {}", in_quotes(text), why, wanted_words));
}

Written taken_apart(const std::string& text, const std::string& wanted_words)
{
  const std::string whole = trimmed(with_plain_blanks(text));
  const char *first = whole.data() + (whole.starts_with("+") ? 1 : 0), *last = whole.data() + whole.size();
  Real number = 0;
  const auto [end, problem] = std::from_chars(first, last, number);
  if (problem == std::errc::invalid_argument || (first != whole.data() && whole[1] == '-'))
    refuse_text(text, "does not begin with a number", wanted_words);
  if (problem != std::errc{} || !std::isfinite(number)) refuse_text(text, "is not a finite number", wanted_words);
  const std::string name = trimmed(std::string(end, last));
  if (const std::string fault = fault_of_commas(digits_of(whole)); !fault.empty()) refuse_text(text, fault, wanted_words);
  if (name.starts_with(",")) refuse_text(text, "has a comma where a point should be", wanted_words);
  return {number, name};
}

Unit known_unit(const std::string& text, const std::string& name, const std::string& wanted_words)
{
  Unit unit = spelled_as_unit(name) ? parse_unit(name) : Unit();
  if (!unit) refuse_text(text, fmt::format("has the unknown unit {}", in_quotes(name)), wanted_words);
  return unit;
}

Unit si_unit_of(const std::string& name)
{
  Unit unit = parse_unit(name);
  if (!unit) throw std::logic_error("the unit of a parameter is not one of UDUNITS-2: " + name);
  return unit;
}

/// Whether two units are convertible. For UDUNITS-2 an angle is a dimensionless number.
bool convertible(const ut_unit* unit, const ut_unit* si, bool bare)
{
  return ut_are_convertible(unit, si) != 0 && (!bare || power_of_radian(unit) == power_of_radian(si));
}

/// UDUNITS-2 multiplies prefixes and exponents one by one: a g/cm^3 comes out as 999.9999999999999 kg/m^3. A factor within 8 epsilon of a number of twelve digits is that number.
Real without_rounding(Real factor)
{
  const std::string digits = fmt::format("{:.11e}", factor);
  Real decimal = factor;
  std::from_chars(digits.data(), digits.data() + digits.size(), decimal);  // leaves it where it is too small for a number
  return std::abs(decimal - factor) <= 8 * std::numeric_limits<Real>::epsilon() * std::abs(factor) ? decimal : factor;
}

bool is_bare(const std::string& si_unit)
{
  return si_unit.empty() || si_unit == "1" || si_unit == "rad";
}

}  // namespace

const char* unit_of_whole(const char* si_unit)
{
  constexpr const char* pairs[][2] = {{"N/m", "N"}, {"kg/m", "kg"},   {"kg m", "kg m^2"},
                                      {"N", "N m"}, {"N/m^2", "N/m"}, {"N/rad", "N m/rad"}};
  for (const auto& [per_metre, in_space] : pairs)
    if (std::strcmp(si_unit, per_metre) == 0) return in_space;
  return si_unit;
}

std::string wanted(const std::string& si_unit)
{
  for (const Dimension& d : dimensions)
    if (si_unit == d.si_unit) return fmt::format("{}, such as \"{}\" or \"{}\"", d.what, d.example, d.other_example);
  return fmt::format("a quantity in {0}, such as \"1 {0}\" or \"2.5 {0}\"", si_unit);
}

Real to_si(const std::string& text, const std::string& si_unit)
{
  const std::string words = wanted(si_unit);
  const Written written = taken_apart(text, words);
  if (written.unit.empty()) return written.number;
  const Unit unit = known_unit(text, written.unit, words), si = si_unit_of(si_unit);
  if (!convertible(unit.get(), si.get(), is_bare(si_unit))) refuse_text(text, "has the wrong dimension", words);
  const std::unique_ptr<cv_converter, Free> converter(ut_get_converter(unit.get(), si.get()));
  if (!converter || cv_convert_double(converter.get(), 0) != 0) refuse_text(text, "is on a scale with an offset", words);
  const Real value = written.number * without_rounding(cv_convert_double(converter.get(), 1));
  if (!std::isfinite(value)) refuse_text(text, "is not a finite number", words);
  return value;
}

SiQuantity to_si(const std::string& text)
{
  const std::string words = "a number with its unit, such as \"20 mm\" or \"35 deg\"";
  const Written written = taken_apart(text, words);
  if (written.unit.empty()) return {written.number, "1"};
  const Unit unit = known_unit(text, written.unit, words);
  for (const Dimension& d : dimensions)
    if (convertible(unit.get(), si_unit_of(d.si_unit).get(), true)) return {to_si(text, d.si_unit), *d.si_unit == '\0' ? "1" : d.si_unit};
  refuse_text(text, "has a unit of unknown dimension", words);
}

bool is_quantity(const std::string& text)
{
  try {
    to_si(text);
    return true;
  } catch (const UnitError&) {
    return false;
  }
}

bool same_dimension(const std::string& unit, const std::string& other)
{
  const auto parsed = [](const std::string& text) { return text == "1" || spelled_as_unit(text) ? parse_unit(text) : Unit(); };
  const Unit one = parsed(unit), two = parsed(other);
  return one && two && convertible(one.get(), two.get(), true);
}

}  // namespace berm::input
