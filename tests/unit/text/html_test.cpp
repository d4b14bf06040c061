// SPDX-License-Identifier: BSD-3-Clause
#include "text/html.hpp"

#include <gtest/gtest.h>

namespace berm::text::this_file {
namespace {

TEST(html, table_escapes_its_caption_and_marks_numbers)
{
  HtmlTable table("key", "a <b> & \"c\"");
  table.columns({{"what"}, {"model", true}});
  table.row({{"V"}, {"784", true}}, "out_of_range");
  const std::string html = table.html();
  EXPECT_NE(html.find("<caption><span>a &lt;b&gt; &amp; &quot;c&quot;</span></caption>"), std::string::npos) << html;
  EXPECT_NE(html.find("<tr class=\"out_of_range\"><th scope=\"row\">V</th><td class=\"number\">784</td></tr>"), std::string::npos) << html;
  EXPECT_NE(html.find("data-copy=\"key\""), std::string::npos) << html;
}

TEST(html, a_row_of_one_cell_goes_over_all_columns)
{
  HtmlTable table("key", "results");
  table.columns({{"what"}, {"model", true}});
  table.row({{"push"}}, "group");
  table.row({{"V"}, {"784", true}});
  const std::string html = table.html();
  EXPECT_NE(html.find("<tr class=\"group\"><th scope=\"row\" colspan=\"2\"><span>push</span></th></tr>"), std::string::npos) << html;
  EXPECT_NE(html.find("<tr><th scope=\"row\">V</th>"), std::string::npos) << html;
}

TEST(html, is_read_as_plain_text)
{
  EXPECT_EQ(text_of_html("<strong>V</strong> = 2 D s<sub>u</sub> of &quot;a &lt; b&quot; <a href=\"#trust\">R &amp; D</a>"),
            "V = 2 D s_u of \"a < b\" R & D");
  EXPECT_EQ(text_of_html("5 < 6"), "5 < 6") << "no tag ends";
}

}  // namespace
}  // namespace berm::text::this_file
