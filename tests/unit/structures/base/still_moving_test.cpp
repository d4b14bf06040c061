// SPDX-License-Identifier: BSD-3-Clause
#include "structures/base/still_moving.hpp"

#include "samples/made_run.hpp"
#include "structures/structures.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace berm::base::this_file {
namespace {

/// A pipe that is laid and then sinks under a force for 10 s: w = 2 mm + 1 mm (t/10 s)^power.
record::RunRecord sinking(Real power)
{
  MadeRun made;
  made.dragged = 0;
  record::RunRecord run = made.record();
  settings::StageSettings hold = MadeRun::stage_of("hold", settings::StageKind::push);
  hold.velocity.reset(), hold.force = 2000, hold.until = {}, hold.until.time = 10;
  run.settings.stage.push_back(hold);
  run_folder::History& h = run.history;
  const auto place = [&](const char* name) {
    return static_cast<std::size_t>(std::ranges::find(h.columns, name, &run_folder::Column::name) - h.columns.begin());
  };
  const Real begin = h["time_s"].back(), w = h["w_m"].back();
  for (int k = 1; k <= 100; ++k) {
    for (std::vector<Real>& column : h.values) column.push_back(column.back());
    h.values[place("time_s")].back() = begin + 0.1 * k;
    h.values[place("w_m")].back() = w + 1e-3 * std::pow(k / 100., power);
    h.values[place("V_N_m")].back() = 2000;
    h.stage.emplace_back("hold");
  }
  return run;
}

/// What is said of w at the end of the push, which goes on in "hold".
std::string meaning_of_end(const record::RunRecord& run)
{
  const std::vector<run_folder::Quantity> list = structures::structure_of(run.settings).quantities(run, {});
  return std::ranges::find(list, "w_end_of_push", &run_folder::Quantity::name)->meaning;
}

TEST(StillMoving, is_a_body_that_would_go_on_by_more_than_a_fiftieth_of_its_travel)
{
  const std::vector<StillMoving> moving = still_moving(sinking(1));
  ASSERT_EQ(moving.size(), 1u);
  EXPECT_EQ(moving[0].stage, "hold");
  EXPECT_EQ(moving[0].symbol, "w");
  EXPECT_NEAR(moving[0].velocity, 1e-4, 1e-9);
  EXPECT_NEAR(moving[0].end - moving[0].before, 1e-4, 1.1e-5) << "a tenth of the stage, and a row at most";
  EXPECT_TRUE(still_moving(sinking(0.1)).empty()) << "the last tenth is (1 - 0.9^0.1) = 1 % of the travel";
}

TEST(StillMoving, is_said_in_the_rows_of_the_end_of_its_stage)
{
  record::RunRecord run = sinking(1);
  EXPECT_EQ(meaning_of_end(run),
            "embedment at the end of the push; still moving at the end: w at 0.1 mm/s, from 2.9 mm to 3 mm in the last 1 s");
  EXPECT_NE(still_moving_lines(run).find("\"hold\" was still moving at the end"), std::string::npos);
  run = sinking(0.1);
  EXPECT_EQ(meaning_of_end(run), "embedment at the end of the push");
}

TEST(StillMoving, is_no_body_that_a_velocity_drives_nor_that_a_limit_stopped_nor_a_run_that_was_stopped)
{
  record::RunRecord driven = sinking(1), limited = sinking(1), stopped = sinking(1);
  driven.settings.stage.back().velocity = 1e-4;
  limited.settings.stage.back().until.embedment = 3e-3;
  stopped.settings.stage.back().until.time = 20;
  for (const record::RunRecord* run : {&driven, &limited, &stopped}) EXPECT_TRUE(still_moving(*run).empty());
}

}  // namespace
}  // namespace berm::base::this_file
