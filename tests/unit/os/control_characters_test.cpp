// SPDX-License-Identifier: BSD-3-Clause
#include "os/control_characters.hpp"

#include <gtest/gtest.h>

namespace berm::this_file {
namespace {

TEST(ControlCharacters, are_those_of_ascii_and_of_unicode)
{
  for (const std::string text : {"a\nb", "a\tb", "\x1B[2J", "\x7F", "\xC2\x80", "\xC2\x9F"}) {
    EXPECT_TRUE(has_control_character(text)) << text;
    EXPECT_FALSE(has_control_character(one_line(text))) << text;
    EXPECT_EQ(one_line(text).size(), text.size());
  }
  EXPECT_TRUE(has_control_character(std::string("a\0b", 3)));
  for (const std::string text : {"", "plain = #1", "\xC2\xA0", "\xC3\xA9", "\xC2", "\xE2\x80\x99"}) {
    EXPECT_FALSE(has_control_character(text)) << text;
    EXPECT_EQ(one_line(text), text);
  }
}

}  // namespace
}  // namespace berm::this_file
