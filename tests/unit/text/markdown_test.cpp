// SPDX-License-Identifier: BSD-3-Clause
#include "text/markdown.hpp"

#include "text/tex_math.hpp"

#include <gtest/gtest.h>

namespace berm::text::this_file {
namespace {

std::string html(const std::string& text)
{
  return html_of_markdown(text, [](const std::string& address) { return address; });
}

bool holds(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

TEST(Markdown, knows_headings_tables_and_code)
{
  const std::string page = html("# A & B\n\n| a | b |\n|---|---|\n| 1 | `x < 2` |\n\n```sh\nrun $HOME | $x\n```\n");
  EXPECT_TRUE(holds(page, "<h1>A &amp; B</h1>")) << page;
  EXPECT_TRUE(holds(page, "<td><code>x &lt; 2</code></td>")) << page;
  EXPECT_TRUE(holds(page, "run $HOME | $x")) << "code holds no formula: " << page;
}
TEST(Markdown, shows_formulas_as_math_and_leaves_their_underscores_alone)
{
  const std::string page = html("Force $V_a$ and `$V_a$` and _this_:\n\n$$a_1 * b_1 * c$$\n");
  EXPECT_TRUE(holds(page, "<math display=\"inline\">")) << page;
  EXPECT_TRUE(holds(page, "<math display=\"block\">")) << page;
  EXPECT_TRUE(holds(page, "<code>$V_a$</code>")) << page;
  EXPECT_TRUE(holds(page, "<em>this</em>")) << page;
}
TEST(Markdown, takes_money_for_no_formula)
{
  EXPECT_TRUE(holds(html("from $5 to $6, or $ 7 $"), "from $5 to $6, or $ 7 $"));
  EXPECT_TRUE(holds(html("one $ here\n\nand $ there"), "one $ here"));
}
TEST(Markdown, writes_the_addresses_that_it_is_told)
{
  const std::string page = html_of_markdown("[a](b.md) ![p](q.png)", [](const std::string& address) { return "../" + address; });
  EXPECT_TRUE(holds(page, "href=\"../b.md\"")) << page;
  EXPECT_TRUE(holds(page, "src=\"../q.png\"")) << page;
}
TEST(Markdown, leaves_out_what_is_no_markdown)
{
  EXPECT_FALSE(holds(html("<script>alert(1)</script>\n\n<!-- words -->"), "alert"));
}

TEST(Math, has_fractions_roots_scripts_and_accents)
{
  EXPECT_EQ(html_math("x", false), "<math display=\"inline\"><mrow><mi>x</mi></mrow></math>");
  EXPECT_TRUE(holds(html_math("\\frac{a}{2b}", true),
                    "<mfrac><mrow><mrow><mi>a</mi></mrow></mrow><mrow><mrow><mn>2</mn><mi>b</mi></mrow></mrow></mfrac>"));
  EXPECT_TRUE(holds(html_math("\\tfrac12", true), "<mfrac><mrow><mn>1</mn></mrow><mrow><mn>2</mn></mrow></mfrac>"));
  EXPECT_TRUE(
      holds(html_math("\\sqrt{\\rho}", true),
            "<mrow class=\"root\" intent=\"square-root($of)\"><mrow arg=\"of\"><mrow><mrow><mi>ρ</mi></mrow></mrow></mrow></mrow>"));
  EXPECT_TRUE(holds(html_math("v_0^2", true),
                    "<msubsup><mi>v</mi><mrow><mrow><mn>0</mn></mrow></mrow><mrow><mrow><mn>2</mn></mrow></mrow></msubsup>"));
  EXPECT_TRUE(holds(html_math("\\ddot u", true), "<mover accent=\"true\"><mrow><mi>u</mi></mrow><mo>¨</mo></mover>"));
  EXPECT_TRUE(holds(html_math("\\sum_p m_p", true), "<munder><mo>∑</mo>"));
  EXPECT_TRUE(holds(html_math("a \\text{ where } b", true), "<mtext>&#xA0;where&#xA0;</mtext>"));
}
TEST(Math, that_is_not_known_or_broken_is_shown_as_it_is_written)
{
  for (const std::string tex : {"\\begin{cases} a & b", "\\frac{a", "a}", "\\left( a", "x_", "\\unheard", "\\text{a", "5 € 6"})
    EXPECT_TRUE(holds(html_math(tex, false), "<code class=\"tex\">")) << tex;
  EXPECT_EQ(html_math("\\unheard{a<b}", false), "<code class=\"tex\">\\unheard{a&lt;b}</code>");
}

}  // namespace
}  // namespace berm::text::this_file
