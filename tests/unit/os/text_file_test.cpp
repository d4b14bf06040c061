// SPDX-License-Identifier: BSD-3-Clause
#include "os/text_file.hpp"

#include "samples/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace berm::this_file {
namespace {

class TextFile : public testing::Test {
protected:
  FileBytes read(const std::string& bytes) const { return read_text(place_.write("file", bytes), 100); }
  TemporaryFolder place_;
};

TEST_F(TextFile, is_utf8_without_a_byte_order_mark)
{
  EXPECT_EQ(read("\xEF\xBB\xBFkN/m\u00B2\n").bytes, "kN/m\u00B2\n");
  EXPECT_EQ(read("\u4E2D\U0001F30A\n").bytes, "\u4E2D\U0001F30A\n");
  EXPECT_EQ(begin_of_text("\xEF\xBB\xBF"), 3u);
  EXPECT_EQ(begin_of_text("\xEF\xBB"), 0u);
}

TEST_F(TextFile, of_latin_1_becomes_utf8)
{
  EXPECT_EQ(read("S\xFC\x64, 5\xA0kN/m\xB2 \x96 \xE9").bytes, "S\u00FCd, 5\u00A0kN/m\u00B2 ? \u00E9");
  EXPECT_EQ(read("\xC3").bytes, "\u00C3") << "cut UTF-8 is none";
}

TEST_F(TextFile, has_lines_that_end_with_lf)
{
  EXPECT_EQ(read("a\rb\r").bytes, "a\nb\n");
  EXPECT_EQ(read("a\r\nb\r\n").bytes, "a\r\nb\r\n");
}

TEST_F(TextFile, in_utf16_or_with_a_nul_byte_is_none)
{
  EXPECT_NE(read("\xFF\xFE"
                 "a")
                .fault.find("UTF-16"),
            std::string::npos);
  EXPECT_NE(read(std::string("a\0", 2)).fault.find("NUL"), std::string::npos);
  EXPECT_EQ(read(std::string("a\0", 2)).bytes, "");
  EXPECT_EQ(read_text(place_ / "none", 100).fault, "there is no such file");
}

}  // namespace
}  // namespace berm::this_file
