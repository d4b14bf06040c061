// SPDX-License-Identifier: BSD-3-Clause
#include "run/expectation.hpp"

#include "core/error.hpp"
#include "input/reader.hpp"

#include <gtest/gtest.h>

namespace berm {
namespace {

/// Rows of one column, 0.013 s apart: no multiple of it is a period.
template <class Function>
History sampled(const std::string& column, Real end, const Function& value)
{
  History history;
  history.columns = {"time_s", column};
  history.values.resize(2);
  for (Real t = 0; t <= end; t += 0.013) {
    history.values[0].push_back(t);
    history.values[1].push_back(value(t));
    history.stage.push_back("all");
  }
  return history;
}

Expectation of_column(const std::string& column, Measure measure, std::optional<Real> from = {}, std::optional<Real> to = {})
{
  Expectation e;
  e.column = column;
  e.measure = measure;
  e.from = from;
  e.to = to;
  return e;
}

/// What reading an expected.toml complains of, or "".
std::string complaint(const std::string& text)
{
  Document document = parse_text("expected.toml", text);
  Expectations all;
  try {
    read(document, all);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

const std::string words = "source = \"here\"\nwhy = \"so\"\n";

TEST(Expectation, measures_the_period_of_a_sine_about_any_level)
{
  // 2.3 periods: the mean of the rows is not the sine's level. Linear interpolation over 0.013 s is good for 1e-4.
  const History history = sampled("a_ux_m", 2.3 * 1.7, [](Real t) { return 5 + std::sin(2 * pi / 1.7 * t + 0.4); });
  EXPECT_NEAR(evaluate(of_column("a_ux_m", Measure::period), history), 1.7, 2e-4);
}
TEST(Expectation, measures_no_period_where_there_is_none)
{
  const History history = sampled("a_ux_m", 1, [](Real t) { return t; });
  EXPECT_TRUE(std::isnan(evaluate(of_column("a_ux_m", Measure::period), history)));
}
TEST(Expectation, measures_the_acceleration_of_a_displacement_and_of_a_velocity)
{
  // Far from t = 0, where a fit with powers of t itself would lose digits.
  const History u = sampled("a_ux_m", 100, [](Real t) { return 3 - 2 * t + 0.5 * 1.25 * t * t; });
  const History v = sampled("a_vx_m_s", 100, [](Real t) { return -2 + 1.25 * t; });
  EXPECT_NEAR(evaluate(of_column("a_ux_m", Measure::acceleration, 90., 99.), u), 1.25, 1e-9);
  EXPECT_NEAR(evaluate(of_column("a_vx_m_s", Measure::acceleration, 90., 99.), v), 1.25, 1e-12);
  EXPECT_NEAR(evaluate(of_column("a_vx_m_s", Measure::slope), v), 1.25, 1e-12);
}
TEST(Expectation, measures_within_its_window_only)
{
  const History history = sampled("V_N_m", 1, [](Real t) { return t < 0.5 ? 1e6 : t; });
  EXPECT_NEAR(evaluate(of_column("V_N_m", Measure::mean, 0.6, 0.8), history), 0.7, 0.01);
  EXPECT_NEAR(evaluate(of_column("V_N_m", Measure::largest, 0.6, 0.8), history), 0.8, 0.013);
  EXPECT_NEAR(evaluate(of_column("V_N_m", Measure::least, 0.6, 0.8), history), 0.6, 0.013);
  EXPECT_NEAR(evaluate(of_column("V_N_m", Measure::change, 0.6, 0.8), history), 0.2, 0.026);
  EXPECT_EQ(evaluate(of_column("V_N_m", Measure::end), history), history["V_N_m"].back());
  EXPECT_TRUE(std::isnan(evaluate(of_column("V_N_m", Measure::end, 7.), history)));
}
TEST(Expectation, is_an_input_error_where_the_history_has_no_such_column)
{
  EXPECT_THROW(evaluate(of_column("W_N_m", Measure::end), sampled("V_N_m", 1, [](Real t) { return t; })), InputError);
}

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
  bounds.least = 650;
  bounds.most = 950;
  EXPECT_TRUE(is_met(bounds, 800));
  EXPECT_FALSE(is_met(bounds, 649));
  EXPECT_NEAR(error_of(bounds, 960), 10, 1e-12);
}
TEST(Expectation, is_never_met_by_what_is_not_a_number)
{
  Expectation exact, bounds;
  exact.exact = 1;
  exact.tolerance = 0.1;
  bounds.most = 1;
  EXPECT_FALSE(is_met(exact, std::nan("")));
  EXPECT_FALSE(is_met(bounds, std::nan("")));
}

TEST(Expectation, takes_the_unit_from_the_name)
{
  Expectations all;
  Document document = parse_text("expected.toml", "[[expect]]\nquantity = \"w_at_u_0.3D\"\nleast = \"5 mm\"\nmost = 0.0066\n" + words);
  read(document, all);
  EXPECT_DOUBLE_EQ(all.expect.at(0).least.value(), 0.005);
  EXPECT_EQ(unit_of("V_at_w_0.1D"), "N/m");
  EXPECT_EQ(unit_of("V_at_w_0.1D_over_gammaD2"), "");
  EXPECT_EQ(unit_of("H_over_V_at_u_0.3D"), "");
  EXPECT_EQ(unit_of(of_column("block_ux_m", Measure::acceleration)), "m/s^2");
  EXPECT_EQ(unit_of(of_column("bar_vx_m_s", Measure::period)), "s");
}
TEST(Expectation, is_refused_at_its_line_where_it_cannot_be)
{
  const std::string head = "[[expect]]\ncolumn = \"a_ux_m\"\n";
  EXPECT_EQ(complaint(head + "exact = \"1 mm\"\ntolerance = 0.1\n" + words), "");
  EXPECT_NE(complaint(head + "exact = \"1 kN\"\ntolerance = 0.1\n" + words).find("expected.toml:3"), std::string::npos);
  EXPECT_NE(complaint(head + "exakt = 1\ntolerance = 0.1\n" + words).find("did you mean \"exact\""), std::string::npos);
  EXPECT_NE(complaint(head + "measure = \"peak\"\nexact = 1\ntolerance = 0.1\n" + words).find("largest"), std::string::npos);
  EXPECT_NE(complaint(head + "exact = 1\ntolerance = 0.1\n").find("source"), std::string::npos);
  for (const char* wrong :
       {"exact = 1\n", "tolerance = 0.1\n", "exact = 1\ntolerance = 0.1\nleast = 0\n", "exact = 0\ntolerance = 0.1\n",
        "least = 1\nmost = 0\n", "least = 1\ntolerance = 0.1\n", "quantity = \"b\"\nleast = 1\n", "from = 2\nto = 1\nleast = 1\n"})
    EXPECT_NE(complaint(head + wrong + words), "") << wrong;
  EXPECT_NE(complaint(""), "");
  EXPECT_NE(complaint("[[expect]]\nquantity = \"V\"\nfrom = 1\nleast = 1\n" + words), "");
}

}  // namespace
}  // namespace berm
