// SPDX-License-Identifier: BSD-3-Clause
#include "study/table_axis.hpp"

#include "os/error.hpp"
#include "samples/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace berm::study::this_file {
namespace {

using Words = std::vector<std::string>;

class Table : public testing::Test {
protected:
  StudyAxis read(const std::string& text) const
  {
    folder_.write("t.csv", text);
    return read_table(folder_ / "t.csv", "soil");
  }
  std::string message(const std::string& text) const
  {
    try {
      read(text);
    } catch (const InputError& error) {
      const std::string message = error.what(), folder = folder_.path().string() + "/";
      return message.starts_with(folder) ? message.substr(folder.size()) : message;
    }
    return "no error";
  }

  TemporaryFolder folder_;
};

TEST_F(Table, without_names_is_a_sample_whose_rows_are_counted)
{
  const StudyAxis axis = read("gravity,material.*.density (g/cm^3)\n\"[0, -1]\",1.5\n\n# dry\n\"[0, -2]\",1.6\n");
  EXPECT_EQ(axis.name, "soil");
  ASSERT_EQ(axis.value.size(), 2u);
  EXPECT_EQ(axis.value[0].name, "1");
  EXPECT_EQ(axis.value[0].set, (Words{"gravity=[0, -1]", "material.*.density=1.5 g/cm^3"}));
  EXPECT_EQ(axis.value[1].name, "2");
  EXPECT_EQ(axis.value[1].set, (Words{"gravity=[0, -2]", "material.*.density=1.6 g/cm^3"}));
  EXPECT_EQ(axis.value[1].place, (folder_ / "t.csv").string() + ":5");
  EXPECT_EQ(axis.sample_from, std::optional<std::size_t>(0));
}
TEST_F(Table, has_names_that_a_terminal_a_folder_and_a_spreadsheet_can_hold)
{
  EXPECT_EQ(message("gravity,name\n1,a\n2,x\x1B[2J\x07\n"),
            "t.csv:3: \"x [2J \" holds a control character; fields are separated by commas, or all by semicolons");
  EXPECT_EQ(message("gravity,name\n1,\"a\nb\"\n"),
            "t.csv:2: \"a b\" holds a control character; fields are separated by commas, or all by semicolons");
  EXPECT_EQ(message("gravity,name\n1,a\n2," + std::string(5000, 'x') + "\n"), "t.csv:3: name: is longer than 100 bytes");
  for (const std::string name : {"=1+1", "=cmd|'/C calc'!A0", "+cmd|x", "-A(1)", "@sum"})
    EXPECT_EQ(message("gravity,name\n1," + name + "\n"), "t.csv:2: name: \"" + name + "\" is a formula to a spreadsheet");
  for (const char* name : {"-1.5", "+2 kPa", "a=1", "x-y", "-persist"})
    EXPECT_EQ(read(std::string("gravity,name\n1,") + name + "\n").value[0].name, name);
}
TEST_F(Table, with_names_holds_chosen_values)
{
  const StudyAxis axis = read("a.b,name\n2 kPa,soft\n3 kPa,stiff\n");
  EXPECT_EQ(axis.value[1].name, "stiff");
  EXPECT_EQ(axis.value[1].set, (Words{"a.b=3 kPa"}));
  EXPECT_FALSE(axis.sample_from);
}
TEST_F(Table, of_a_spreadsheet_is_read)
{
  // A byte order mark, semicolons, ends of lines as Windows has them, spaces, quotes and no end of the last line.
  const StudyAxis axis = read("\xEF\xBB\xBF\"a.b\"; a.c (kPa)\r\n1;2\r\n;\r\n3 ;4");
  ASSERT_EQ(axis.value.size(), 2u);
  EXPECT_EQ(axis.value[1].set, (Words{"a.b=3", "a.c=4 kPa"}));
}
TEST_F(Table, that_is_wrong_is_refused_with_file_and_line)
{
  EXPECT_EQ(message(""), "t.csv:1: is empty; the first line holds keys such as material.sand.friction_angle");
  EXPECT_EQ(message("a.b\n\n"), "t.csv:2: there is no row below the keys");
  EXPECT_EQ(message("a.b,a.c\n1,2\n3\n"), "t.csv:3: 1 fields for 2 columns");
  EXPECT_EQ(message("a.b,a.c\n1,2\n\n3,4,5\n"), "t.csv:4: 3 fields for 2 columns");
  EXPECT_EQ(message("a.b,a.c\n1,\n"), "t.csv:2: a.c is empty");
  EXPECT_EQ(message("a.b,a.b\n1,2\n"), "t.csv:1: \"a.b\" heads two columns");
  EXPECT_EQ(message("1,2\n3,4\n"), "t.csv:1: \"1\" is not a key; the first line holds keys such as material.sand.friction_angle");
  EXPECT_EQ(message("a,\n3,4\n"), "t.csv:1: \"\" is not a key; the first line holds keys such as material.sand.friction_angle");
  EXPECT_EQ(message("name\nsoft\n"), "t.csv:1: has no column but `name`");
  EXPECT_EQ(message("name,a\nso ft,1\nso/ft,2\n"), "t.csv:3: \"so/ft\" is the name, or as a file the name, of a row before it");
  EXPECT_EQ(message("a.b\n1\n\"2\n3\n"), "t.csv:3: a quote is not closed");
  EXPECT_EQ(message(std::string("a.b\n1\0\n", 7)), "t.csv: holds a NUL byte: this is not a text file; save it as text in UTF-8");
  EXPECT_THROW(read_table(folder_ / "other.csv", "soil"), InputError);
  EXPECT_THROW(read_table(folder_.path(), "soil"), InputError) << "a folder is not a table";
}

}  // namespace
}  // namespace berm::study::this_file
