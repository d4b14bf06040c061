// SPDX-License-Identifier: BSD-3-Clause
#include "samples/paper_run.hpp"

#include "report/expectations/expectations_section.hpp"

#include <gtest/gtest.h>

namespace berm::report::this_file {
namespace {

using test::PaperRun;

/// What is published of the probe test.
const ExpectationSheets& paper()
{
  static const ExpectationSheets sheets = {
      expectations::read_expectations(std::string(BERM_SOURCE_DIR) + "/examples/probe_test/expected.toml")};
  return sheets;
}

/// The row of the claims whose statement holds these words.
std::string row_with(const std::string& html, const std::string& words)
{
  const auto at = html.find(words);
  if (at == std::string::npos) return "";
  const auto from = html.rfind("<tr", at);
  return html.substr(from, html.find("</tr>", at) - from);
}

/// The verdict of that row: the text of its first badge.
std::string verdict(const std::string& html, const std::string& words)
{
  const std::string row = row_with(html, words);
  const auto badge = row.find("class=\"badge");
  if (badge == std::string::npos) return "";
  const auto from = row.find('>', badge) + 1;
  return row.substr(from, row.find('<', from) - from);
}

TEST(Claims, are_only_made_of_the_runs_that_the_file_names)
{
  EXPECT_TRUE(is_of_a_test(PaperRun{}.record("case"), paper()));
  EXPECT_TRUE(is_of_a_test(PaperRun{.file = "wip_10.toml", .overrides = {}}.record("wip"), paper()));
  EXPECT_FALSE(published_points({PaperRun{}.record("case")}, paper()).empty());
  for (const char* other : {"material.sand.friction_angle=\"30 deg\"", "rigid.pipe.diameter=\"40 mm\""}) {
    const record::RunRecord run = PaperRun{.file = "case.toml", .overrides = {other}}.record("other");
    EXPECT_FALSE(is_of_a_test(run, paper())) << other;
    EXPECT_EQ(claims_section({run}, paper()), "") << other;
    EXPECT_TRUE(published_points({run}, paper()).empty()) << other;
  }
  record::RunRecord stopped = PaperRun{}.record("stopped"), old = PaperRun{}.record("old");
  stopped.end = record::RunEnd::stopped;
  old.origin.reset();
  EXPECT_EQ(claims_section({stopped, old}, paper()), "") << "a run that did not come to its end, and one of an earlier version";
}

TEST(Claims, of_the_paper_name_numbers_that_runs_have)
{
  std::vector<record::RunRecord> runs = {PaperRun{}.record("case")};
  for (const char* file : {"as_published.toml", "wip_10.toml", "wip_25.toml"})
    runs.push_back(PaperRun{.file = file, .overrides = {}}.record(file));
  runs.push_back(PaperRun{.file = "as_published.toml", .overrides = {"contact.skin.scheme=\"musl_single\""}}.record("once"));
  for (record::RunRecord& run : runs) run.quantities.push_back({"overlap_max_over_D", 0, "1"});
  const std::string html = claims_section(runs, paper());
  EXPECT_EQ(html.find("has no quantity"), std::string::npos) << html.substr(html.find("has no quantity"), 100);
  EXPECT_EQ(html.find("needs at"), std::string::npos);
}

TEST(Claims, the_force_of_the_push_is_judged_by_its_distance_from_the_papers)
{
  const auto of = [](double V_at_tenth) {
    PaperRun run;
    run.V = [=](double w) { return V_at_tenth * w / 0.1; };
    return verdict(claims_section({run.record("case")}, paper()), "A push to w = 0.1 D");
  };
  EXPECT_EQ(of(4000), "reproduced");
  EXPECT_EQ(of(3500), "reproduced");
  EXPECT_EQ(of(3000), "partly");
  EXPECT_EQ(of(784), "not reproduced");
  PaperRun low;
  low.V = [](double w) { return 7840 * w; };
  const std::string row = row_with(claims_section({low.record("case")}, paper()), "A push to w = 0.1 D");
  EXPECT_NE(row.find("V at w = 0.1 D: 0.784 kN/m (39.2 kN/m in the prototype), 0.2 times the 4 kN/m that is published; w/D where V "
                     "reaches 4 kN/m: none"),
            std::string::npos)
      << row;
}

TEST(Claims, runs_that_disagree_make_partly)
{
  PaperRun low;
  low.V = [](double w) { return 7840 * w; };
  EXPECT_EQ(verdict(claims_section({PaperRun{}.record("a"), low.record("b")}, paper()), "A push to w = 0.1 D"), "partly");
}

TEST(Claims, sinking_and_its_end_are_told_apart)
{
  PaperRun run;
  run.w = [](double u) { return 0.1 + std::min(u, 0.3) * 0.5; };
  std::string html = claims_section({run.record("case")}, paper());
  EXPECT_EQ(verdict(html, "The pipe sinks while it is dragged"), "reproduced");
  EXPECT_EQ(verdict(html, "has reached its maximum"), "reproduced");
  run.w = [](double u) { return 0.1 + u; };
  html = claims_section({run.record("case")}, paper());
  EXPECT_EQ(verdict(html, "The pipe sinks while it is dragged"), "not reproduced");
  EXPECT_EQ(verdict(html, "has reached its maximum"), "not reproduced");
}

TEST(Claims, a_resistance_that_falls_again_does_not_grow)
{
  PaperRun run;
  run.H = [](double u) { return 1000 * u * (1.2 - u); };
  EXPECT_EQ(verdict(claims_section({run.record("case")}, paper()), "H grows"), "not reproduced");
  EXPECT_EQ(verdict(claims_section({PaperRun{}.record("case")}, paper()), "H grows"), "reproduced");
}

TEST(Claims, finite_elements_are_compared_at_the_scale_of_the_other_forces_and_with_the_drag)
{
  PaperRun wip_10{.file = "wip_10.toml", .overrides = {}}, wip_25{.file = "wip_25.toml", .overrides = {}};
  wip_10.u_end = wip_25.u_end = 0.3;
  wip_10.w = [](double) { return 0.1; };
  wip_25.w = [](double) { return 0.25; };
  wip_10.H = [](double) { return 20; };
  wip_25.H = [](double) { return 40; };
  PaperRun drag;  // H(0.3 D) = 300 N/m; w = 0.25 D at u = 0.3 D
  const auto html = [&] { return claims_section({drag.record("case"), wip_10.record("wip_10"), wip_25.record("wip_25")}, paper()); };
  // In the prototype 1 and 2 kN/m, the paper's numbers; but its V is read per metre of the model.
  EXPECT_EQ(verdict(html(), "give H of about 1 kN"), "not reproduced");
  EXPECT_NE(row_with(html(), "give H of about 1 kN").find("Per metre of the model"), std::string::npos);
  EXPECT_EQ(verdict(html(), "Finite elements at the first embedment"), "reproduced");
  EXPECT_EQ(verdict(html(), "Finite elements at the last embedment"), "reproduced");
  const std::string row = row_with(html(), "Finite elements at the last embedment");
  EXPECT_NE(row.find("H over that of the finite elements: 7.5;"), std::string::npos) << row;
  EXPECT_EQ(row.find("er metre of"), std::string::npos) << "a ratio has no scale";
  wip_25.H = [](double) { return 290; };
  EXPECT_EQ(verdict(html(), "Finite elements at the last embedment"), "not reproduced");
}

TEST(Claims, of_which_no_run_tells_anything_are_not_examined)
{
  const std::string html = claims_section({PaperRun{}.record("case")}, paper());
  EXPECT_EQ(verdict(html, "Finite elements at the first embedment"), "not examined");
  EXPECT_EQ(verdict(html, "Correcting twice"), "not examined");
}

TEST(Claims, runs_that_have_only_begun_make_no_numbers)
{
  PaperRun begun;
  begun.w_push = 0.01;
  begun.u_end = 1e-4;
  for (const std::string& html : {claims_section({begun.record("begun")}, paper()),
                                  claims_section({PaperRun{.file = "wip_10.toml", .overrides = {}}.record("wip")}, paper())})
    for (const char* number : {"inf", "nan"}) EXPECT_EQ(html.find(std::string(" ") + number), std::string::npos) << html;
}

TEST(Claims, a_larger_resistance_under_a_larger_load_proves_half)
{
  PaperRun wip{.file = "wip_10.toml", .overrides = {}};
  wip.u_end = 0.3;
  wip.w = [](double) { return 0.1; };
  wip.H = [](double) { return 20; };
  const auto verdict_with = [&](double V) {
    wip.V = [=](double) { return V; };
    return verdict(claims_section({PaperRun{}.record("case"), wip.record("wip")}, paper()), "Finite elements at the first embedment");
  };
  EXPECT_EQ(verdict_with(4000), "reproduced");
  EXPECT_EQ(verdict_with(1000), "partly");
}

/// The case of the paper, with two corrections or one.
record::RunRecord corrected(bool twice)
{
  const std::vector<std::string> once = {"contact.skin.scheme=\"musl_single\""};
  return PaperRun{.file = "as_published.toml", .overrides = twice ? std::vector<std::string>() : once}.record(twice ? "twice" : "once");
}

TEST(Claims, of_two_corrections_are_judged_by_runs_that_correct_twice)
{
  record::RunRecord once = corrected(false), twice = corrected(true);
  once.quantities = twice.quantities = {{"overlap_max_over_D", 0, "1"}};
  EXPECT_EQ(verdict(claims_section({once}, paper()), "With the two corrections"), "not examined");
  EXPECT_EQ(verdict(claims_section({twice}, paper()), "With the two corrections"), "reproduced");
  twice.quantities = {{"overlap_max_over_D", 0.01, "1"}};
  EXPECT_EQ(verdict(claims_section({twice}, paper()), "With the two corrections"), "not reproduced");
}

TEST(Claims, correcting_twice_is_judged_where_a_run_corrects_once)
{
  record::RunRecord once = corrected(false), twice = corrected(true);
  once.quantities = {{"V_noise", 0.03, "1"}};
  twice.quantities = {{"V_noise", 0.02, "1"}};
  EXPECT_EQ(verdict(claims_section({once, twice}, paper()), "Correcting twice"), "reproduced");
  twice.quantities = {{"V_noise", 0.029, "1"}};
  EXPECT_EQ(verdict(claims_section({once, twice}, paper()), "Correcting twice"), "not reproduced");
  EXPECT_EQ(verdict(claims_section({twice}, paper()), "Correcting twice"), "not examined");
}

TEST(Claims, names_of_runs_are_no_markup)
{
  EXPECT_EQ(claims_section({PaperRun{}.record("<b>x")}, paper()).find("<b>x"), std::string::npos);
}

}  // namespace
}  // namespace berm::report::this_file
