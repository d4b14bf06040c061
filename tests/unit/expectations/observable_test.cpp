// SPDX-License-Identifier: BSD-3-Clause
#include "expectations/observable.hpp"

#include "os/error.hpp"
#include "samples/history_columns.hpp"
#include "samples/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace berm::expectations::this_file {
namespace {

/// Rows of one column, 0.013 s apart: no multiple of it is a period.
template <class Function>
run_folder::History sampled(const std::string& column, Real end, const Function& value)
{
  run_folder::History history;
  history.columns = columns_named({"time_s", column});
  history.values.resize(2);
  for (Real t = 0; t <= end; t += 0.013) {
    history.values[0].push_back(t);
    history.values[1].push_back(value(t));
    history.stage.push_back("all");
  }
  return history;
}

Observable of_column(const std::string& column, Measure measure, std::optional<Real> from = {}, std::optional<Real> to = {})
{
  Observable observable;
  observable.column = column;
  observable.measure = measure;
  observable.from = from;
  observable.to = to;
  return observable;
}

TEST(Observable, measures_the_period_of_a_sine_about_any_level)
{
  // 2.3 periods: the mean of the rows is not the sine's level. Linear interpolation over 0.013 s is good for 1e-4.
  const run_folder::History history = sampled("a_ux_m", 2.3 * 1.7, [](Real t) { return 5 + std::sin(2 * pi / 1.7 * t + 0.4); });
  EXPECT_NEAR(evaluate(of_column("a_ux_m", Measure::period), history), 1.7, 2e-4);
}
TEST(Observable, measures_no_period_where_there_is_none)
{
  const run_folder::History history = sampled("a_ux_m", 1, [](Real t) { return t; });
  EXPECT_TRUE(std::isnan(evaluate(of_column("a_ux_m", Measure::period), history)));
}
TEST(Observable, measures_the_acceleration_of_a_displacement_and_of_a_velocity)
{
  // Far from t = 0, where a fit with powers of t itself would lose digits.
  const run_folder::History u = sampled("a_ux_m", 100, [](Real t) { return 3 - 2 * t + 0.5 * 1.25 * t * t; });
  const run_folder::History v = sampled("a_vx_m_s", 100, [](Real t) { return -2 + 1.25 * t; });
  EXPECT_NEAR(evaluate(of_column("a_ux_m", Measure::acceleration, 90., 99.), u), 1.25, 1e-9);
  EXPECT_NEAR(evaluate(of_column("a_vx_m_s", Measure::acceleration, 90., 99.), v), 1.25, 1e-12);
  EXPECT_NEAR(evaluate(of_column("a_vx_m_s", Measure::slope), v), 1.25, 1e-12);
}
TEST(Observable, measures_within_its_window_only)
{
  const run_folder::History history = sampled("V_N_m", 1, [](Real t) { return t < 0.5 ? 1e6 : t; });
  EXPECT_NEAR(evaluate(of_column("V_N_m", Measure::mean, 0.6, 0.8), history), 0.7, 0.01);
  EXPECT_NEAR(evaluate(of_column("V_N_m", Measure::largest, 0.6, 0.8), history), 0.8, 0.013);
  EXPECT_NEAR(evaluate(of_column("V_N_m", Measure::least, 0.6, 0.8), history), 0.6, 0.013);
  EXPECT_NEAR(evaluate(of_column("V_N_m", Measure::change, 0.6, 0.8), history), 0.2, 0.026);
  EXPECT_EQ(evaluate(of_column("V_N_m", Measure::end), history), history["V_N_m"].back());
  EXPECT_TRUE(std::isnan(evaluate(of_column("V_N_m", Measure::end, 7.), history)));
}
TEST(Observable, is_an_input_error_where_the_history_has_no_such_column)
{
  EXPECT_THROW(evaluate(of_column("W_N_m", Measure::end), sampled("V_N_m", 1, [](Real t) { return t; })), InputError);
}

TEST(Observable, takes_the_unit_from_the_schema)
{
  const auto unit = [](const std::string& column, Measure measure) {
    return unit_of(of_column(column, measure), sampled(column, 1, [](Real t) { return t; }));
  };
  EXPECT_EQ(unit("block_ux_m", Measure::acceleration), "m/s^2");
  EXPECT_EQ(unit("bar_vx_m_s", Measure::acceleration), "m/s^2");
  EXPECT_EQ(unit("angle_rad", Measure::acceleration), "rad/s^2");
  EXPECT_EQ(unit("pipe_M_Nm_m", Measure::mean), "N m/m");
  EXPECT_EQ(unit("disk_Lz_N_s", Measure::mean), "N s");
  EXPECT_EQ(unit("bar_vx_m_s", Measure::period), "s");
  EXPECT_EQ(unit("V_N_m", Measure::slope), "N/m/s");
  EXPECT_EQ(unit("overstress", Measure::mean), "");
  EXPECT_EQ(unit("overstress", Measure::slope), "1/s");
}
TEST(Observable, finds_quantities_checks_and_times_in_a_summary)
{
  TemporaryFolder folder;
  folder.write("summary.json", R"({"quantities": {"V_end": {"value": 12.5, "unit": "N/m"}, "H_end": {"value": null, "unit": "N/m"}},
    "timing": {"wall_s": 3.5, "loops": []}, "checks": {"finished": true}, "text": {}})");
  const auto value = [&](const std::string& name) {
    Observable observable;
    observable.quantity = name;
    return evaluate(observable, folder.path()).value;
  };
  EXPECT_EQ(value("V_end"), 12.5);
  EXPECT_TRUE(std::isnan(value("H_end")));
  EXPECT_EQ(value("finished"), 1);
  EXPECT_EQ(value("wall_s"), 3.5);
  try {
    value("V_ends");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean \"V_end\""), std::string::npos) << error.what();
  }
}

TEST(Observable, of_a_summary_that_is_damaged_is_refused)
{
  const TemporaryFolder folder;
  Observable observable;
  observable.quantity = "V_end";
  for (const char* text :
       {"", "{", "[]", "5", "{\"quantities\": 5}", "{\"quantities\": {\"V_end\": {}}}", "{\"quantities\": {\"V\": {\"value\": [1]}}}"}) {
    folder.write("summary.json", text);
    EXPECT_THROW(evaluate(observable, folder.path()), RunError) << text;
  }
}

}  // namespace
}  // namespace berm::expectations::this_file
