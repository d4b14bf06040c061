// SPDX-License-Identifier: BSD-3-Clause
#include "report/page/page.hpp"

#include "record/travel_curve.hpp"
#include "samples/history_columns.hpp"
#include "samples/made_run.hpp"

#include <gtest/gtest.h>

namespace berm::report::this_file {
namespace {

using Json = nlohmann::ordered_json;

/// A pipe that rests for a row, is pushed by 2 mm in `push` rows and dragged by 10 mm in `drag` rows, with forces that jump from row to row.
record::RunRecord long_run(Index push, Index drag)
{
  record::RunRecord run = MadeRun{}.record();
  run_folder::History& h = run.history;
  h = {columns_named({"time_s", "u_m", "w_m", "H_N_m", "V_N_m"}), std::vector<std::vector<Real>>(5), {}};
  const auto add = [&](const char* stage, Real u, Real w, Real H, Real V) {
    const Real row[] = {static_cast<Real>(h.rows()), u, w, H, V};
    for (int c = 0; c < 5; ++c) h.values[c].push_back(row[c]);
    h.stage.emplace_back(stage);
  };
  const auto noise = [](Index k) { return k % 2 == 0 ? 50. : -50.; };
  add("geostatic", 0, 0, 0, 0);
  for (Index k = 1; k <= push; ++k) add("push", 0, 0.002 * k / push, 0, 800. * k / push + noise(k));
  for (Index k = 1; k <= drag; ++k) add("drag", 0.01 * k / drag, 0.002, 300 + 1e4 * (0.01 * k / drag) + noise(k), 800);
  return run;
}

/// Row of history.csv of a row of the page.
Index history_row(const Json& data, Index row)
{
  return data["row"].is_null() ? row : data["row"][row].get<Index>();
}

TEST(PageData, short_history_has_all_its_rows)
{
  const record::RunRecord run = MadeRun{}.record();
  const Json data = report::run_data(run);
  EXPECT_TRUE(data["row"].is_null());
  EXPECT_EQ(data["columns"]["time_s"].size(), std::size_t(run.history.rows()));
}

TEST(PageData, a_lift_begins_with_the_row_before_it)
{
  record::RunRecord run = long_run(10, 20);
  run.settings.stage.push_back(MadeRun::stage_of("lift", settings::StageKind::push));
  run.settings.stage.back().velocity = -0.1;
  for (Index k = 1; k <= 5; ++k) {
    const Real row[] = {100. + k, 0.01, 0.002 - 1e-4 * k, 0, -50. * k};
    for (int c = 0; c < 5; ++c) run.history.values[c].push_back(row[c]);
    run.history.stage.emplace_back("lift");
  }
  EXPECT_EQ(report::run_data(run)["lift"]["rows"].get<std::vector<Index>>(), (std::vector<Index>{30, 31, 32, 33, 34, 35}));
  EXPECT_TRUE(report::run_data(long_run(10, 20))["lift"]["rows"].empty());
}

TEST(PageData, thinned_history_keeps_the_ends_of_each_stage_and_the_row_before_the_drag)
{
  const record::RunRecord run = long_run(1000, 5000);
  ASSERT_EQ(run.history.rows(), 6001);
  const Json data = report::run_data(run);
  const std::vector<Index> kept = data["row"];
  EXPECT_LT(kept.size(), 5006u);
  EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end()));
  for (const Index row : {0, 1, 1000, 1001, 6000}) EXPECT_TRUE(std::binary_search(kept.begin(), kept.end(), row)) << row;

  const std::vector<Index> push = data["push"]["rows"], drag = data["drag"]["rows"];
  EXPECT_EQ(history_row(data, push.front()), 1);
  EXPECT_EQ(history_row(data, push.back()), 1000);
  EXPECT_EQ(history_row(data, drag.front()), 1000);
  EXPECT_EQ(history_row(data, drag[1]), 1001);
  EXPECT_EQ(history_row(data, drag.back()), 6000);
}

TEST(PageData, rows_of_a_thinned_history_are_those_of_history_csv)
{
  const record::RunRecord run = long_run(1000, 5000);
  const Json data = report::run_data(run);
  const std::size_t kept = data["row"].size();
  EXPECT_EQ(data["stage"].size(), kept);
  for (std::size_t c = 0; c < run.history.columns.size(); ++c) {
    const Json& column = data["columns"][run.history.columns[c].name];
    ASSERT_EQ(column.size(), kept);
    for (std::size_t k = 0; k < kept; ++k) ASSERT_EQ(column[k], run.history.values[c][data["row"][k].get<Index>()]);
  }
  for (std::size_t k = 0; k < kept; ++k) ASSERT_EQ(data["stage"][k], run.history.stage[data["row"][k].get<Index>()]);
}

TEST(PageData, means_of_a_thinned_history_are_those_of_all_its_rows)
{
  const record::RunRecord run = long_run(1000, 5000);
  const Json data = report::run_data(run);
  const run_folder::History& h = run.history;
  std::vector<Real> u(h["u_m"].begin() + 1000, h["u_m"].end()), H(h["H_N_m"].begin() + 1000, h["H_N_m"].end());
  const record::TravelCurve curve(u, H);
  const Json& drag = data["drag"];
  ASSERT_EQ(drag["H_mean"].size(), drag["rows"].size());
  for (std::size_t k = 0; k < drag["rows"].size(); ++k) {
    const Index row = history_row(data, drag["rows"][k]);
    const Real here = h["u_m"][row], half = averaging_half(base::body_scale(run.settings));
    ASSERT_DOUBLE_EQ(drag["H_mean"][k], curve.at(here, std::min(half, here))) << "from the first row on";
  }
}

TEST(PageData, means_along_very_many_rows_stay_on_the_force)
{
  const record::RunRecord run = long_run(20000, 30000);
  const Json data = report::run_data(run);
  const Real D = base::body_scale(run.settings).width;
  std::size_t seen = 0;
  for (std::size_t k = 0; k < data["drag"]["rows"].size(); ++k) {
    const Real u = run.history["u_m"][history_row(data, data["drag"]["rows"][k])];
    if (u < 0.02 * D) continue;  // H jumps where the drag begins
    ++seen;
    // The noise of +-50 N/m is gone but for what half a row more on one side than on the other leaves of it.
    ASSERT_NEAR(data["drag"]["H_mean"][k].get<Real>(), 300 + 1e4 * u, 1) << "at " << u / D << " D";
  }
  EXPECT_GT(seen, 2000u);
  EXPECT_TRUE(data["drag"]["H_mean"].back().is_number());
}

TEST(PageData, a_drag_that_goes_back_and_forth_has_no_mean)
{
  record::RunRecord run = long_run(100, 500);
  for (Index k = 101; k <= 600; ++k) run.history.values[1][k] = 0.003 * std::sin(0.05 * (k - 100));
  run.settings.stage.back().velocity.reset(), run.settings.stage.back().force = 400;
  const Json data = report::run_data(run);
  ASSERT_GT(data["drag"]["rows"].size(), 400u);
  for (const char* mean : {"H_mean", "V_mean"})
    for (const Json& each : data["drag"][mean]) ASSERT_TRUE(each.is_null());
  EXPECT_TRUE(data["push"]["V_mean"].back().is_number());
}

TEST(PageData, prototype_is_of_runs_whose_gravity_is_not_the_earths)
{
  MadeRun made;
  for (const Real level : {0., 1., 10 / standard_gravity}) {
    made.gravity_level = level;
    EXPECT_TRUE(report::run_data(made.record())["prototype"].is_null()) << level;
  }
  for (const Real level : {0.5, 50.}) {
    made.gravity_level = level;
    EXPECT_DOUBLE_EQ(report::run_data(made.record())["prototype"], level);
  }
}

TEST(PageData, forces_have_the_measure_of_the_tables)
{
  MadeRun made;
  const auto measure = [&] { return report::run_data(made.record())["measure"]; };
  const Real weight = base::body_scale(made.settings()).unit_weight;
  EXPECT_DOUBLE_EQ(measure()["size"], weight * made.D * made.D);
  EXPECT_EQ(measure()["force"], "γ′ D²");

  made.law = MadeRun::clay_law();  // with weight, for gravity is on
  EXPECT_DOUBLE_EQ(measure()["size"], 1000 * made.D);
  EXPECT_EQ(measure()["force"], "D s_u");
  EXPECT_EQ(measure()["stress"], "s_u");
  EXPECT_EQ(measure()["energy"], "D² s_u");

  made.gravity_level = 0;
  EXPECT_DOUBLE_EQ(measure()["size"], 1000 * made.D);
  made.law.cohesion = 0;
  EXPECT_TRUE(measure().is_null());
}

}  // namespace
}  // namespace berm::report::this_file
