// SPDX-License-Identifier: BSD-3-Clause
#include "input/units.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace berm::input::this_file {
namespace {

struct Quantity {
  const char *text, *unit;
  Real value;
};

std::string message_of(const std::string& text, const std::string& unit)
{
  try {
    to_si(text, unit);
  } catch (const UnitError& error) {
    return error.what();
  }
  return "";
}

TEST(Units, become_SI)
{
  const Quantity quantities[] = {
      {"20 mm", "m", 0.02},
      {"2.5e-3 m", "m", 2.5e-3},
      {"  20mm ", "m", 0.02},
      {"+3 km", "m", 3000},
      {"1000", "m", 1000},
      {"5 µm", "m", 5e-6},
      {"35 deg", "rad", 35 * pi / 180},
      {"35°", "rad", 35 * pi / 180},
      {"1", "rad", 1},
      {"430 kN/m^3", "N/m^3", 430e3},
      {"18 kN/m3", "N/m^3", 18e3},
      {"18 kN m-3", "N/m^3", 18e3},
      {"18 kN.m^-3", "N/m^3", 18e3},
      {"50 gravity", "m/s^2", 50 * standard_gravity},
      {"-50 gravity", "m/s^2", -50 * standard_gravity},
      {"0.1 m/s", "m/s", 0.1},
      {"7 MPa", "Pa", 7e6},
      {"7 N/mm^2", "Pa", 7e6},
      {"7 N/mm2", "Pa", 7e6},
      {"1 ft", "m", 0.3048},
      {"50 %", "", 0.5},
      {"0.25", "", 0.25},
      {"2 1/m", "rad/m", 2},
      {"180 deg/m", "rad/m", pi},
      {"1.5 t", "kg", 1500},
      {"2 min", "s", 120},
  };
  // One rounding in the conversion factor and one in the product.
  for (const Quantity& q : quantities) EXPECT_NEAR(to_si(q.text, q.unit), q.value, 4e-16 * std::abs(q.value)) << q.text;
}

TEST(Units, of_decimal_factors_lose_nothing)
{
  EXPECT_EQ(to_si("2 g/cm^3", "kg/m^3"), 2000);
  EXPECT_EQ(to_si("1.8 t/m^3", "kg/m^3"), 1800);
  EXPECT_EQ(to_si("1 kN/cm^2", "Pa"), 1e7);
  EXPECT_EQ(to_si("1 ft", "m"), 0.3048);
}
TEST(Units, of_every_example_have_their_dimension)
{
  for (const char* unit : {"",     "m",      "s",  "kg",   "rad", "m/s", "m/s^2", "rad/m", "rad/s", "1/s",
                           "kg/m", "kg/m^3", "Pa", "Pa/m", "N",   "N/m", "N/m^3", "J",     "J/m",   "m^2"}) {
    std::string rest = wanted(unit);
    int examples = 0;
    for (std::size_t begin; (begin = rest.find('"')) != std::string::npos; ++examples) {
      const std::size_t end = rest.find('"', begin + 1);
      EXPECT_NO_THROW(to_si(rest.substr(begin + 1, end - begin - 1), unit)) << unit << ": " << rest;
      rest.erase(0, end + 1);
    }
    EXPECT_EQ(examples, 2) << unit;
  }
}

TEST(Units, of_another_dimension_are_refused_with_two_examples)
{
  const Quantity wrong[] = {{"3 kg", "m", 0},  {"20 m", "rad", 0},         {"50 %", "rad", 0}, {"35 deg", "", 0}, {"9.81 g", "m/s^2", 0},
                            {"3 m.s", "m", 0}, {"18 kN/m^3", "kg/m^3", 0}, {"1 N", "N/m", 0},  {"1 m", "", 0},    {"1 Pa", "N/m", 0}};
  for (const Quantity& q : wrong) {
    const std::string message = message_of(q.text, q.unit);
    EXPECT_NE(message.find("wrong dimension"), std::string::npos) << q.text << ": " << message;
    EXPECT_NE(message.find(wanted(q.unit)), std::string::npos) << message;
  }
}

TEST(Units, that_are_no_units_are_refused)
{
  for (const char* text : {"3 furlongs_",   "3 20 mm", "3 m 4", "3 4", "3 2m",    "3 m @ 5", "3 s since 2000-01-01",
                           "3 lg(re 1 mW)", "3 m;",    "3 ^",   "3 /", "3 ((m)",  "0x10 m",  "3 \"m\"",
                           "3 m - 4",       "3 \xff",  "3 m\n", "3 µ", "3 m\xff", "3 mé",    "3 m\xc3"})
    EXPECT_NE(message_of(text, "m").find("unknown unit"), std::string::npos) << text << ": " << message_of(text, "m");
}

TEST(Units, need_a_finite_number)
{
  for (const char* text : {"", "m", "mm 20", "deg", "- 3 m", "+-3 m", "--3 m", "nan", "inf m", "-infinity", "1e999 m", "1e300 Ym", "1,5 m"})
    EXPECT_FALSE(message_of(text, "m").empty()) << text;
}

TEST(Units, on_a_scale_that_does_not_begin_at_zero_are_refused)
{
  EXPECT_NE(message_of("20 degC", "K").find("is on a scale with an offset"), std::string::npos);
  EXPECT_NE(message_of("20 degF", "K").find("is on a scale with an offset"), std::string::npos);
  EXPECT_DOUBLE_EQ(to_si("20 K", "K"), 20);
}

TEST(Units, take_any_text_without_harm)
{
  rc::check([](const std::string& text) {
    try {
      RC_ASSERT(std::isfinite(to_si(text, "m")));
    } catch (const UnitError& error) {
      RC_ASSERT(std::string(error.what()).find('\n') == std::string::npos);
    }
    try {
      to_si("1 " + text, "Pa");
    } catch (const UnitError&) {
    }
  });
}

TEST(Units, keep_every_number_that_is_written_in_SI)
{
  rc::check([](double number) {
    RC_PRE(std::isfinite(number));
    RC_ASSERT(to_si(fmt::format("{}", number), "m") == number);
    RC_ASSERT(to_si(fmt::format("{} m", number), "m") == number);
  });
}

// UDUNITS-2 reads these as units of time.
TEST(Units, with_numbers_or_a_nul_in_them_are_none)
{
  EXPECT_TRUE(same_dimension("ms", "s"));
  EXPECT_TRUE(same_dimension("1", ""));
  EXPECT_FALSE(same_dimension("2s", "s"));
  EXPECT_FALSE(same_dimension(std::string("s\0", 2), "s"));
  EXPECT_FALSE(is_quantity(std::string("1 s\0", 4)));
}

}  // namespace
}  // namespace berm::input::this_file
