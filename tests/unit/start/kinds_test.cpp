// SPDX-License-Identifier: BSD-3-Clause
// What berm new begins with: all kinds, at all sizes, are cases; a size changes cells and speeds, and nothing else.
#include "start/kinds.hpp"

#include "input/read_case.hpp"
#include "os/error.hpp"

#include <filesystem>
#include <gtest/gtest.h>

namespace berm::start::this_file {
namespace {

Kind made(const std::string& text)
{
  return {"made", "Group", "Why?", "Title", "bar", text};
}

TEST(Kinds, say_their_group_question_title_and_an_example_that_is_there)
{
  EXPECT_GE(kinds().size(), 18u);
  for (const Kind& one : kinds()) {
    EXPECT_FALSE(one.group.empty()) << one.name;
    EXPECT_TRUE(one.question.ends_with('?')) << one.name << ": " << one.question;
    EXPECT_FALSE(one.title.empty()) << one.name;
    EXPECT_TRUE(std::filesystem::is_directory(std::filesystem::path(BERM_SOURCE_DIR) / "examples" / one.example))
        << one.name << ": " << one.example;
    EXPECT_NE(one.text.find("# <-"), std::string::npos) << one.name;
  }
}

TEST(Kinds, are_cases_at_all_sizes_which_differ)
{
  for (const Kind& one : kinds())
    for (const std::string& size : sizes) {
      const std::string text = at_size(one, size);
      EXPECT_NO_THROW(input::read_case_text(one.name + ".toml", text)) << one.name << " " << size;
      EXPECT_EQ(text.find("[quick"), std::string::npos) << one.name << " " << size;
      EXPECT_EQ(text == at_size(one, "normal"), size == "normal") << one.name << " " << size;
    }
}

TEST(Kinds, have_the_values_of_a_size_in_the_lines_that_name_them)
{
  const Kind kind = made("a = \"50 mm\"   # [quick \"80 mm\", fine \"25 mm\"] of cells\nb = 1   # stays\n");
  EXPECT_EQ(at_size(kind, "quick"), "a = \"80 mm\"                             # quick: of cells\nb = 1   # stays\n");
  EXPECT_EQ(at_size(kind, "normal"), "a = \"50 mm\"                             # normal: of cells\nb = 1   # stays\n");
  EXPECT_EQ(at_size(kind, "fine"), "a = \"25 mm\"                             # fine: of cells\nb = 1   # stays\n");
}

TEST(Kinds, refuse_names_and_sizes_that_are_none)
{
  EXPECT_THROW(kind_called("pipe-in-cly"), InputError);
  EXPECT_THROW(at_size(kinds()[0], "huge"), InputError);
}

}  // namespace
}  // namespace berm::start::this_file
