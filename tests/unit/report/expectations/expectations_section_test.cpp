// SPDX-License-Identifier: BSD-3-Clause
#include "report/expectations/expectations_section.hpp"

#include "samples/paper_run.hpp"

#include <gtest/gtest.h>

namespace berm::report::this_file {
namespace {

using test::PaperRun;

const std::string sheet = R"(requirement = "it holds"
derived = "there"
[run.pushed]
case = "case.toml"
[run.placed]
case = "wip_10.toml"
[[expect]]
run = "pushed"
quantity = "V_at_w_0.1D"
exact = "4 kN/m"
tolerance = 0.05
source = "<here>"
why = "so"
[[expect]]
run = "pushed"
column = "w_m"
most = "1 mm"
source = "s"
why = "w"
[[expect]]
run = "pushed"
over = "placed"
quantity = "H_at_u_0.3D"
least = 2
source = "s"
why = "w"
[[expect]]
run = "placed"
quantity = "no_such"
least = 2
source = "s"
why = "w"
)";

std::string section(const std::vector<record::RunRecord>& runs)
{
  return expectations_section(runs, {expectations::read_expectations_text("expected.toml", sheet)});
}

std::size_t count(const std::string& html, const std::string& words)
{
  std::size_t found = 0;
  for (std::size_t at = html.find(words); at != std::string::npos; at = html.find(words, at + 1)) ++found;
  return found;
}

TEST(ExpectationsSection, has_a_row_for_each_number_that_is_expected_of_the_runs_on_the_page)
{
  const std::string html = section({PaperRun{}.record("first")});
  EXPECT_EQ(count(html, "<tr"), 3u) << "a header and two rows: the third number needs another run";
  EXPECT_NE(html.find("V_at_w_0.1D"), std::string::npos);
  EXPECT_NE(html.find("4 kN/m (tolerance 5 %)"), std::string::npos) << html;
  EXPECT_NE(html.find("&lt;here&gt;; so"), std::string::npos);
  EXPECT_EQ(count(html, ">met<"), 1u);
  EXPECT_EQ(count(html, ">missed<"), 1u);
}

TEST(ExpectationsSection, compares_runs_that_are_both_there)
{
  const std::string html = section({PaperRun{}.record("first"), PaperRun{.file = "wip_10.toml", .overrides = {}}.record("second")});
  EXPECT_NE(html.find("H_at_u_0.3D divided by that of placed"), std::string::npos) << html;
  EXPECT_EQ(count(html, ">failed<"), 1u) << "a number that the run does not have";
}

TEST(ExpectationsSection, is_left_out_where_nothing_is_expected)
{
  EXPECT_EQ(section({PaperRun{.file = "case.toml", .overrides = {"title=\"another\""}}.record("other")}), "");
  EXPECT_EQ(expectations_section({PaperRun{}.record("case")}, {}), "");
}

}  // namespace
}  // namespace berm::report::this_file
