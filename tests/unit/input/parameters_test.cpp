// SPDX-License-Identifier: BSD-3-Clause
#include "input/catalogue.hpp"
#include "input/message_text.hpp"
#include "input/read_case.hpp"
#include "input/units.hpp"

#include <functional>
#include <gtest/gtest.h>

namespace berm::input::this_file {
namespace {

void for_each_value(const Listed& table, const std::string& path, const std::function<void(const Listed&, const std::string&)>& visit)
{
  for (const Listed& entry : table.children) {
    if (entry.kind == Listed::Kind::value || entry.kind == Listed::Kind::word) visit(entry, path + "." + entry.key);
    for_each_value(entry, path + "." + entry.key, visit);
  }
}

TEST(Parameters, of_the_case_are_all_in_the_table_and_on_the_page)
{
  const Listed of_case = catalogue_of<settings::Case>();
  const std::string table = parameter_table(of_case), page = parameter_page(of_case);
  int count = 0;
  for_each_value(of_case, "", [&](const Listed& entry, const std::string& path) {
    ++count;
    EXPECT_NE(table.find("  " + entry.key + " "), std::string::npos) << path;
    EXPECT_NE(page.find("| `" + entry.key + "` |"), std::string::npos) << path;
    EXPECT_NE(table.find(entry.meaning), std::string::npos) << path;
    EXPECT_NE(page.find(entry.meaning), std::string::npos) << path;
  });
  EXPECT_GT(count, 60);
  for (const char* heading : {"[material.NAME]", "[body.NAME.block]", "[[stage]]", "[stage.until]", "law = \"mohr_coulomb\""}) {
    EXPECT_NE(table.find(heading), std::string::npos) << heading;
    EXPECT_NE(page.find(heading), std::string::npos) << heading;
  }
}

TEST(Parameters, have_units_that_are_units_and_defaults_in_range)
{
  for_each_value(catalogue_of<settings::Case>(), "", [](const Listed& entry, const std::string& path) {
    EXPECT_NO_THROW(to_si("1 " + entry.unit, entry.unit)) << path;
    const bool number = !entry.default_text.empty() && entry.type == Listed::Type::number && entry.number_words.empty();
    EXPECT_TRUE(!number || within(to_si(entry.default_text, entry.unit), entry.range)) << path;
    EXPECT_FALSE(entry.meaning.empty()) << path;
  });
}

TEST(Words, that_were_meant_are_found)
{
  const std::vector<std::string> words = {"friction_angle", "dilation_angle", "cohesion", "density", "x", "law"};
  EXPECT_EQ(nearest("friction_angel", words), "friction_angle");
  EXPECT_EQ(nearest("Density", words), "density");
  EXPECT_EQ(nearest("frction_angle", words), "friction_angle");
  EXPECT_EQ(nearest("friction", words), "friction_angle");
  EXPECT_EQ(nearest("lwa", words), "law");
  EXPECT_EQ(nearest("colour", words), "");
  EXPECT_EQ(nearest("y", words), "");
  EXPECT_EQ(edit_distance("abcd", "acbd"), 1);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
  EXPECT_EQ(edit_distance("", "abc"), 3);
}

TEST(Words, for_a_range_show_angles_in_degrees)
{
  EXPECT_EQ(range_text({0, 89.9 * pi / 180}, "rad"), "from 0 to 89.9 deg (0 to 1.569 rad)");
  EXPECT_EQ(range_text(positive, "m"), "more than 0 m");
  EXPECT_EQ(range_text(not_negative, ""), "at least 0");
  EXPECT_EQ(range_text({0, 1, true}, ""), "more than 0 and at most 1");
  EXPECT_EQ(range_text({-infinity, 1, false, true}, "s"), "less than 1 s");
  EXPECT_EQ(range_text(any_number, "m"), "");
  EXPECT_FALSE(within(0, positive));
  EXPECT_TRUE(within(0, not_negative));
  EXPECT_FALSE(within(1, Range{0, 1, false, true}));
}

}  // namespace
}  // namespace berm::input::this_file
