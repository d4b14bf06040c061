// SPDX-License-Identifier: BSD-3-Clause
#include "samples/made_run.hpp"

#include "core/error.hpp"
#include "report/claims/claims.hpp"

#include <gtest/gtest.h>

namespace berm::report::this_file {
namespace {

/// The claims of a test of pipes of 20 mm, of which V at 0.05 D is 400 N/m.
const std::string pipe_test = R"(source = "A test"
[test]
rigid."*".diameter = "20 mm"
"material.*.friction_angle" = "35 deg"
[[claim]]
statement = "V is 400 N/m"
where = "1"
why = "from {V least} to {V most}"
[[claim.finding]]
words = "{V}"
value = [{name = "V", observable = "V_at_w", at = 0.05, published = "400 N/m"}]
)";

std::string with(const std::string& what, const std::string& instead)
{
  std::string text = pipe_test;
  return text.replace(text.find(what), what.size(), instead);
}

/// What a sheet is refused with; "" where it is read.
std::string refusal(const std::string& text)
{
  try {
    read_claims_text("claims.toml", text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string section(const std::string& text, const MadeRun& run)
{
  return claims_section({run.record()}, {read_claims_text("claims.toml", text)});
}

TEST(ClaimSheet, a_sheet_of_another_test_is_judged_as_that_of_the_paper)
{
  EXPECT_NE(section(pipe_test, MadeRun{}).find("reproduced"), std::string::npos);
  EXPECT_NE(section(pipe_test, MadeRun{}).find("from 0.4 kN/m to 0.4 kN/m"), std::string::npos) << section(pipe_test, MadeRun{});
  EXPECT_NE(section(with("\"400 N/m\"", "\"4 kN/m\""), MadeRun{}).find("not reproduced"), std::string::npos);
}

TEST(ClaimSheet, a_run_is_of_the_test_where_one_table_of_its_case_has_all_that_is_asked_of_such_tables)
{
  const ClaimSheet sheet = read_claims_text("claims.toml", with("[test]", "[test]\nmaterial.\"*\".young_modulus = \"7 MPa\""));
  MadeRun made;
  EXPECT_TRUE(is_of_test(made.record(), sheet));
  made.D = 0.021;
  EXPECT_FALSE(is_of_test(made.record(), sheet));
  record::RunRecord two = MadeRun{}.record();
  two.settings.material.push_back(two.settings.material[0]);
  two.settings.material[0].second = MadeRun::clay_law();
  two.settings.material[1].first = "sand";
  EXPECT_TRUE(is_of_test(two, sheet));
  two.settings.material[1].second.get<material::MohrCoulomb>().young_modulus = 8e6;
  EXPECT_FALSE(is_of_test(two, sheet)) << "the friction of one and the stiffness of the other";
}

TEST(ClaimSheet, what_is_wrong_is_refused_with_file_line_and_key)
{
  const auto expect_refused = [](const std::string& text, const char* words) {
    const std::string said = refusal(text);
    EXPECT_EQ(said.rfind("claims.toml:", 0), 0u) << said;
    EXPECT_NE(said.find(words), std::string::npos) << said;
  };
  EXPECT_EQ(refusal(pipe_test), "");
  expect_refused(with("V_at_w", "V_at_v"), "claim[0].finding[0].value.V.observable");
  expect_refused(with("friction_angle", "friction_angel"), "is no parameter of a case");
  expect_refused(with("20 mm", "20 kg"), "claims.toml:3");
  expect_refused(with("{V}", "{W}"), "\"{W}\" stands for nothing");
  expect_refused(with("{V most}", "{V}"), "why");
  expect_refused(with(", at = 0.05", ""), "V_at_w needs at");
  expect_refused(with("at = 0.05", "at = 0.05, more_than = \"H\""), "is no value before it");
  expect_refused(with("at = 0.05", "at = 0.05, of_beside = true"), "there is no run beside");
  expect_refused(with("published = \"400 N/m\"", "published = \"400 mm\""), "published");
  expect_refused(with("published", "colour"), "colour");
  expect_refused(with("[[claim.finding]]", "[[claim.finding]]\nalike = [\"contact.*.detection\"]"), "there is no run beside");
  expect_refused("source = \"A test\"\n" + pipe_test.substr(pipe_test.find("[[claim]]")), "[test]");
}

TEST(ClaimSheet, each_test_has_a_section_of_its_own)
{
  const ClaimSheet sheet = read_claims_text("claims.toml", pipe_test);
  const std::string html = claims_section({MadeRun{}.record()}, {sheet, sheet});
  EXPECT_NE(html.find("id=\"claims\""), std::string::npos);
  EXPECT_NE(html.find("id=\"claims-2\""), std::string::npos);
}

}  // namespace
}  // namespace berm::report::this_file
