// SPDX-License-Identifier: BSD-3-Clause
#include "expectations/quotation.hpp"

#include "input/reader.hpp"
#include "os/error.hpp"

#include <gtest/gtest.h>

namespace berm::expectations::this_file {
namespace {

/// What reading an expected.toml complains of, or "".
std::string complaint(const std::string& text)
{
  input::Document document = input::parse_text("expected.toml", text);
  Expectations all;
  try {
    read(document, all);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

const std::string one_run = "[run.a]\n";
const std::string words = "source = \"here\"\nwhy = \"so\"\nrequirement = \"it holds\"\nderived = \"there\"\n";

TEST(Expectation, is_met_within_its_tolerance_and_bounds)
{
  Expectation relative, absolute, bounds;
  relative.exact = -200;
  relative.tolerance = 0.01;
  EXPECT_TRUE(is_met(relative, -201.9));
  EXPECT_FALSE(is_met(relative, -202.1));
  EXPECT_NEAR(error_of(relative, -199), 0.005, 1e-15);
  absolute.exact = 0;
  absolute.absolute_tolerance = 1e-6;
  EXPECT_TRUE(is_met(absolute, -9e-7));
  EXPECT_FALSE(is_met(absolute, 2e-6));
  bounds.min = 650;
  bounds.max = 950;
  EXPECT_TRUE(is_met(bounds, 800));
  EXPECT_FALSE(is_met(bounds, 649));
  EXPECT_NEAR(error_of(bounds, 960), 10, 1e-12);
}
TEST(Expectation, is_never_met_by_what_is_not_a_number)
{
  Expectation exact, bounds;
  exact.exact = 1;
  exact.tolerance = 0.1;
  bounds.max = 1;
  EXPECT_FALSE(is_met(exact, std::nan("")));
  EXPECT_FALSE(is_met(bounds, std::nan("")));
}

TEST(Expectation, of_a_band_needs_a_quantity_of_a_run_with_uncertainty_and_no_tolerance)
{
  const std::string asked = "[run.a]\nuncertainty = true\n",
                    exact = "[[expect]]\nrun = \"a\"\nquantity = \"H_max\"\nexact = 1\nheld = \"yes\"\n" + words;
  EXPECT_EQ(complaint(asked + exact), "");
  EXPECT_NE(complaint(one_run + exact).find("needs uncertainty = true"), std::string::npos);
  EXPECT_NE(complaint(asked + exact + "tolerance = 0.1\n").find("one of them"), std::string::npos);
  const std::string column = "[[expect]]\nrun = \"a\"\ncolumn = \"H_N_m\"\nexact = 1\nheld = \"yes\"\n" + words;
  EXPECT_NE(complaint(asked + column).find("only a quantity of one run has a band"), std::string::npos);
}

TEST(Expectation, of_element_tests_needs_a_quantity_and_has_no_band)
{
  const std::string tests = "[run.a]\nelement = true\n",
                    quantity = "[[expect]]\nrun = \"a\"\nquantity = \"ds.s_u\"\nexact = 1\ntolerance = 1\n",
                    column = "[[expect]]\nrun = \"a\"\ncolumn = \"q_Pa\"\nexact = 1\ntolerance = 1\n";
  EXPECT_EQ(complaint(tests + quantity + words), "");
  EXPECT_NE(complaint(tests + column + words).find("has quantities only"), std::string::npos);
  EXPECT_NE(complaint(tests + "uncertainty = true\n" + quantity + words).find("have no bands"), std::string::npos);
}

TEST(Expectation, may_be_written_in_any_unit_of_one_dimension)
{
  const std::string begin = one_run + "[[expect]]\nrun = \"a\"\nquantity = \"w_at_u_0.3D\"\nleast = \"5 mm\"\n" + words;
  Expectations all;
  input::Document document = input::parse_text("expected.toml", begin + "most = 0.0066\n");
  read(document, all);
  EXPECT_DOUBLE_EQ(all.expect.at(0).min.value(), 0.005);
  EXPECT_EQ(all.expect.at(0).unit, "m");
  EXPECT_NE(complaint(begin + "most = \"1 kPa\"\n").find("is in Pa, another number of this parameter in m"), std::string::npos)
      << complaint(begin + "most = \"1 kPa\"\n");
}
TEST(Expectation, may_be_the_ratio_of_the_numbers_of_two_runs)
{
  const std::string runs = "[run.a]\n[run.b]\n[[expect]]\nrun = \"a\"\nquantity = \"V_at_w_0.1D\"\nexact = 1\ntolerance = 0.03\n" + words;
  Expectations all;
  input::Document document = input::parse_text("expected.toml", runs + "over = \"b\"\n");
  read(document, all);
  const Expectation& ratio = all.expect.at(0);
  EXPECT_EQ(runs_of(ratio), (std::vector<std::string>{"a", "b"}));
  EXPECT_TRUE(is_pure(ratio));
  EXPECT_EQ(words_of(ratio), "V_at_w_0.1D divided by that of b");
  EXPECT_DOUBLE_EQ(number_of(ratio, {103, 100}), 1.03);
  EXPECT_TRUE(is_met(ratio, 1.029));
  EXPECT_FALSE(is_met(ratio, 0.969));
  EXPECT_NE(complaint(runs + "over = \"c\"\n").find("there is no such [run.NAME]"), std::string::npos);
  EXPECT_NE(complaint(runs + "over = \"a\"\n").find("needs a run, and another one"), std::string::npos);
}
TEST(Expectation, may_be_the_number_that_a_page_quotes_to_its_last_digit)
{
  const auto quoted = [](const std::string& text) {
    return read_expectations_text("expected.toml", one_run + "[[expect]]\nrun = \"a\"\nquantity = \"V\"\n" + text).expect.at(0);
  };
  const Expectation sentence = quoted("quoted = \"breaks out with {0.92 kN/m} after\"\n");
  EXPECT_DOUBLE_EQ(*sentence.exact, 920);
  EXPECT_NEAR(*sentence.absolute_tolerance, 10, 1e-12);
  EXPECT_EQ(sentence.source, "README.md");
  EXPECT_TRUE(is_met(sentence, 929));
  EXPECT_FALSE(is_met(sentence, 931));
  EXPECT_EQ(quotation_of(sentence).on_page("0.94"), "breaks out with 0.94 kN/m after");
  EXPECT_EQ(quotation_of(sentence).in_braces("0.94"), "breaks out with {0.94 kN/m} after");
  EXPECT_EQ(quotation_of(sentence).rounded(944), "0.94");
  const Expectation cell = quoted("quoted = \"| laid | {-106} |\"\nquoted_unit = \"mm\"\npage = \"results.md\"\n");
  EXPECT_DOUBLE_EQ(*cell.exact, -0.106);
  EXPECT_DOUBLE_EQ(*cell.absolute_tolerance, 1e-3);
  EXPECT_EQ(quotation_of(cell).on_page("-108"), "| laid | -108 |");
  EXPECT_EQ(quotation_of(cell).rounded(-0.1083), "-108");
}
TEST(Expectation, that_is_quoted_is_refused_where_it_cannot_be)
{
  const auto of = [](const std::string& text) { return complaint(one_run + "[[expect]]\nrun = \"a\"\nquantity = \"V\"\n" + text); };
  EXPECT_EQ(of("quoted = \"with {0.92 kN/m}\"\n"), "");
  EXPECT_NE(of("quoted = \"with 0.92 kN/m\"\n").find("has no number in braces"), std::string::npos);
  EXPECT_NE(of("quoted = \"with {0.92 kNm/}\"\n").find("expect[0].quoted"), std::string::npos);
  EXPECT_NE(of("quoted = \"with {0.92 kN/m}\"\nquoted_unit = \"mm\"\n").find("needs no quoted_unit"), std::string::npos);
  EXPECT_NE(of("quoted = \"with {0.92 kN/m}\"\nexact = 920\n").find("leave out exact"), std::string::npos);
  EXPECT_NE(of("exact = 1\ntolerance = 0.1\nquoted_unit = \"mm\"\n" + words).find("needs quoted"), std::string::npos);
}
TEST(Expectation, measures_the_order_of_convergence)
{
  Expectation order;
  order.runs = {"h8", "h16", "h32"};
  order.limit = 2;
  EXPECT_NEAR(number_of(order, {2 - 0.16, 2 - 0.04, 2 - 0.01}), 2, 1e-12);
  EXPECT_NEAR(number_of(order, {2 + 0.1, 2 - 0.05, 2 + 0.025}), 1, 1e-12);
  // Of logarithms 0, -1, -4 the least-squares slope is -2.
  EXPECT_NEAR(number_of(order, {3, 2.5, 2.0625}), 2, 1e-12);
  EXPECT_TRUE(std::isnan(number_of(order, {2.1, std::nan(""), 2.01})));
  EXPECT_TRUE(std::isnan(number_of(order, {2.1, 2, 2.01})));
}
TEST(Expectation, of_an_order_has_a_limit_with_a_unit_and_bounds_without)
{
  const std::string runs = "[run.h8]\n[run.h16]\n[[expect]]\nruns = [\"h8\", \"h16\"]\ncolumn = \"a_ux_m\"\n" + words;
  Expectations all;
  input::Document document = input::parse_text("expected.toml", runs + "limit = \"1 mm\"\nleast = 1.8\n");
  read(document, all);
  EXPECT_DOUBLE_EQ(all.expect.at(0).limit.value(), 0.001);
  EXPECT_TRUE(is_pure(all.expect.at(0)));
  EXPECT_NE(complaint(runs + "limit = \"1 mm\"\nleast = \"1.8 mm\"\n").find("expected.toml:11: expect[0].least"), std::string::npos);
  EXPECT_NE(complaint(runs + "least = 1.8\n").find("runs and a limit go together"), std::string::npos);
  EXPECT_NE(complaint(runs + "limit = 1\nleast = 1.8\nrun = \"h8\"\n").find("either a run or"), std::string::npos);
}
TEST(Expectation, is_refused_at_its_line_where_it_cannot_be)
{
  const std::string head = one_run + "[[expect]]\nrun = \"a\"\ncolumn = \"a_ux_m\"\n";
  EXPECT_EQ(complaint(head + "exact = \"1 mm\"\ntolerance = 0.1\n" + words), "");
  EXPECT_NE(complaint(head + "exact = \"1 mm\"\nabsolute_tolerance = \"1 kN\"\n" + words).find("absolute_tolerance"), std::string::npos);
  EXPECT_NE(complaint(head + "exakt = 1\ntolerance = 0.1\n" + words).find("did you mean \"exact\""), std::string::npos);
  EXPECT_NE(complaint(head + "measure = \"peak\"\nexact = 1\ntolerance = 0.1\n" + words).find("largest"), std::string::npos);
  EXPECT_NE(complaint(head + "exact = 1\ntolerance = 0.1\n").find("source"), std::string::npos);
  for (const char* wrong : {"exact = 1\n", "tolerance = 0.1\n", "exact = 1\ntolerance = 0.1\nleast = 0\n", "exact = 0\ntolerance = 0.1\n",
                            "least = 1\nmost = 0\n", "least = 1\ntolerance = 0.1\n", "quantity = \"b\"\nleast = 1\n",
                            "from = 2\nto = 1\nleast = 1\n", "least = 1\nlimit = 1\n"})
    EXPECT_NE(complaint(head + wrong + words), "") << wrong;
  EXPECT_NE(complaint(""), "");
  EXPECT_NE(complaint(one_run + "[[expect]]\nrun = \"a\"\nquantity = \"V\"\nfrom = 1\nleast = 1\n" + words), "");
}
TEST(Expectation, and_run_belong_together)
{
  const std::string rest = "quantity = \"V\"\nleast = 1\n" + words;
  EXPECT_NE(complaint("[run.slow]\n[[expect]]\nrun = \"slwo\"\n" + rest)
                .find("expected.toml:3: expect[0].run: there is no such [run.NAME]; did you mean \"slow\"?"),
            std::string::npos);
  EXPECT_NE(complaint(one_run + "[[expect]]\n" + rest).find("either a run or"), std::string::npos);
  EXPECT_NE(
      complaint(one_run + "[run.b]\n[[expect]]\nrun = \"a\"\n" + rest).find("expected.toml:2: run.b: no [[expect]] is about this run"),
      std::string::npos);
}

TEST(Expectation, says_what_is_promised_or_the_file_does)
{
  const std::string number = one_run + "[[expect]]\nrun = \"a\"\nquantity = \"finished\"\nleast = 1\nsource = \"s\"\nwhy = \"w\"\n";
  EXPECT_NE(complaint(number).find("expected.toml:2: expect[0]: needs a requirement"), std::string::npos) << complaint(number);
  EXPECT_NE(complaint("requirement = \"it ends\"\n" + number).find("needs derived"), std::string::npos);
  EXPECT_EQ(complaint("requirement = \"it ends\"\nderived = \"there\"\n" + number), "");

  input::Document document = input::parse_text("expected.toml", "requirement = \"it ends\"\nderived = \"there\"\n" + number +
                                                                    number.substr(one_run.size()) + "requirement = \"its own\"\n");
  Expectations all;
  read(document, all);
  EXPECT_EQ(all.expect[0].requirement, "it ends");
  EXPECT_EQ(all.expect[1].requirement, "its own");
  EXPECT_EQ(all.expect[1].derived, "there");
}

TEST(Expectation, may_be_over_another_number_of_its_run)
{
  const std::string ratio =
      one_run + "[[expect]]\nrun = \"a\"\nquantity = \"H\"\nat = 1\nover_number = {quantity = \"V\"}\nleast = 1\n" + words;
  EXPECT_EQ(complaint(ratio), "");
  const Expectations all = read_expectations_text("expected.toml", ratio);
  EXPECT_EQ(runs_of(all.expect[0]), (std::vector<std::string>{"a", "a"}));
  EXPECT_EQ(words_of(all.expect[0]), "H 1 divided by V");
  EXPECT_EQ(observable_of(all.expect[0], 1).quantity, "V");
  EXPECT_EQ(number_of(all.expect[0], {3, 2}), 1.5);
  EXPECT_NE(complaint(one_run + "[[expect]]\nrun = \"a\"\ncolumn = \"w_m\"\nat = 1\nleast = 1\n" + words).find("only a quantity"),
            std::string::npos);
}

TEST(Expectation, of_a_claim_needs_a_label_and_a_run_of_its_own_or_of_the_claim)
{
  const std::string head = one_run + "[[expect]]\nrun = \"a\"\nquantity = \"V\"\nleast = 1\n" + words;
  const auto claim = [&](const std::string& runs, const std::string& number) {
    return head + "[published]\nsource = \"s\"\n[[published.claim]]\nstatement = \"it is\"\nwhere = \"1\"\nwhy = \"so\"\n" + runs +
           "expect = [{" + number + "}]\n";
  };
  const std::string number = "label = \"V\", quantity = \"V\"";
  EXPECT_EQ(complaint(claim("runs = [\"a\"]\n", number)), "");
  EXPECT_EQ(complaint(claim("", "run = \"a\", " + number)), "");
  EXPECT_EQ(complaint(claim("runs = [\"a\"]\n", number + ", exact = \"4 kN/m\", tolerance = 0.1, partly = \"always\"")), "");
  const std::vector<std::pair<std::string, const char*>> wrong = {
      {claim("", number), "needs a run"},
      {claim("runs = [\"b\"]\n", number), "there is no such [run.NAME]"},
      {claim("runs = [\"a\"]\n", "quantity = \"V\""), "needs a label"},
      {claim("runs = [\"a\"]\n", number + ", partly = 1"), "needs exact or bounds"},
      {claim("runs = [\"a\"]\n", number + ", exact = 1"), "tolerance"},
      {claim("runs = [\"a\"]\n", number + ", colour = 1"), "colour"},
      {head + "partly = 1\n", "only a claim can hold partly"}};
  for (const auto& [text, said] : wrong) EXPECT_NE(complaint(text).find(said), std::string::npos) << complaint(text);
}

}  // namespace
}  // namespace berm::expectations::this_file
