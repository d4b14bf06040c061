// SPDX-License-Identifier: BSD-3-Clause
// Numbers and fields as spreadsheets, word processors and people write them.
#include "input/text_table.hpp"

#include "input/units.hpp"
#include "os/error.hpp"
#include "samples/error_of.hpp"

#include <gtest/gtest.h>

namespace berm::input::this_file {
namespace {

using Words = std::vector<std::string>;

TEST(TextTable, has_fields_without_blanks_of_any_kind_and_quotation_marks)
{
  EXPECT_EQ(fields_of(" a ;\"b;c\";\u00A01\u202F;\u22122", ';'), (Words{"a", "b;c", "1", "-2"}));
  EXPECT_EQ(separator_of("\"a;b\",c"), ',');
  EXPECT_EQ(separator_of("a;b,c"), ';');
  EXPECT_EQ(separator_of("a\tb,c"), '\t');
  EXPECT_FALSE(closes_its_quotes("a,\"b"));
}

TEST(TextTable, numbers_with_commas_say_what_to_write)
{
  const std::pair<const char*, const char*> faults[] = {
      {"0,5", "has a decimal comma: write 0.5"},
      {"-12,34e3", "has a decimal comma: write -12.34e3"},
      {"0,125", "has a decimal comma: write 0.125"},
      {"1234,567", "has a decimal comma: write 1234.567"},
      {"1,000", "is 1000 if its comma separates thousands, and 1.000 if it is a decimal comma: write one of them"},
      {"-12,345", "is -12345 if its comma separates thousands, and -12.345 if it is a decimal comma: write one of them"},
      {"1,000.5", "has commas between thousands: write 1000.5"},
      {"1,000,000", "has commas between thousands: write 1000000"},
      {"1.000,5", "has points between thousands and a decimal comma: write 1000.5"},
      {"12 000", "has blanks between thousands: write 12000"},
      {"1.5", ""},
      {"1,5,3", ""},
      {"x,y", ""},
  };
  for (const auto& [text, fault] : faults) EXPECT_EQ(fault_of_commas(text), fault) << text;
}

TEST(TextTable, commas_are_decimal_where_one_number_shows_it_and_none_has_a_point)
{
  const auto read = [](const Words& fields) {
    DecimalCommas commas;
    for (const std::string& field : fields) commas.see(field);
    return commas.with_point(fields[0]);
  };
  EXPECT_EQ(read({"1,000", "0,5"}), "1.000");
  EXPECT_EQ(read({"1,000", "2,000"}), "1,000") << "it may be a thousand";
  EXPECT_EQ(read({"0,5", "1.5"}), "0,5") << "points, too";
  EXPECT_EQ(read({"soft, brown", "0,5"}), "soft, brown");
}

TEST(TextTable, quantities_take_blanks_that_do_not_break_and_doubt_commas)
{
  for (const char* blank : {"\u00A0", "\u202F", "\u2009"}) EXPECT_EQ(to_si(std::string("5") + blank + "kPa", "Pa"), 5000);
  EXPECT_EQ(to_si("\u22125 kPa", "Pa"), -5000);
  const auto fault = [](const std::string& text) { return test::error_of<UnitError>([&] { to_si(text, "Pa"); }); };
  EXPECT_NE(fault("4,000 Pa").find("is 4000 if its comma separates thousands, and 4.000 if it is a decimal comma"), std::string::npos);
  EXPECT_NE(fault("0,5 kPa").find("has a decimal comma: write 0.5"), std::string::npos);
  EXPECT_NE(fault("12\u202F000 Pa").find("has blanks between thousands: write 12000"), std::string::npos);
  EXPECT_NE(fault("1,,5 Pa").find("has a comma where a point should be"), std::string::npos);
}

}  // namespace
}  // namespace berm::input::this_file
