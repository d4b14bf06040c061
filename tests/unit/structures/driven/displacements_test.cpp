// SPDX-License-Identifier: BSD-3-Clause
#include "structures/driven/displacements.hpp"
#include "structures/driven/report.hpp"

#include "samples/made_run.hpp"
#include "structures/driven/driven_run.hpp"
#include "structures/driven/quantities.hpp"

#include <gtest/gtest.h>

namespace berm::driven::this_file {
namespace {

constexpr Real D = 0.02;

/// A pipe that a force moves to +0.8 D, back to +0.2 D and to +0.4 D, 1 s a row, with jitter that is no turn, while it sinks to 0.3 D and rises to 0.25 D.
record::RunRecord moved()
{
  MadeRun made;
  made.dragged = 0;
  record::RunRecord run = made.record();
  run.settings.stage.push_back(MadeRun::stage_of("storm", settings::StageKind::drag));
  settings::StageSettings& storm = run.settings.stage.back();
  storm.velocity.reset();
  storm.force = 300;
  storm.load_times = {0, 80, 140, 160};
  storm.load_factors = {1, -1, 1, 0};
  const auto add = [&](Real u, Real w) {
    const Real row[] = {static_cast<Real>(run.history.rows()), u, w, 100, 800};
    for (int k = 0; k < 5; ++k) run.history.values[k].push_back(row[k]);
    run.history.stage.emplace_back("storm");
  };
  for (int k = 1; k <= 80; ++k) add((0.01 * k - (k % 10 == 0 ? 0.005 : 0)) * D, (0.1 + 0.0025 * k) * D);
  for (int k = 1; k <= 60; ++k) add((0.8 - 0.01 * k) * D, 0.3 * D);
  for (int k = 1; k <= 20; ++k) add((0.2 + 0.01 * k) * D, 0.25 * D);
  run.quantities = structures::structure_of(run.settings).quantities(run, {});
  return run;
}

TEST(Displacements, of_a_force_that_varies_are_largest_and_last_and_of_each_half_cycle)
{
  const record::RunRecord run = moved();
  const Displacements m = *DrivenRun(run).results().main_drag().moved;
  EXPECT_NEAR(m.u_largest, 0.795 * D, 0.006 * D);
  EXPECT_NEAR(m.u_end, 0.4 * D, 1e-9);
  EXPECT_NEAR(m.w_largest, 0.3 * D, 1e-9);
  EXPECT_NEAR(m.w_end, 0.25 * D, 1e-9);
  EXPECT_EQ(m.half_cycles, 3);
  EXPECT_NEAR(m.largest_half_cycle, 0.795 * D, 0.006 * D);
  EXPECT_NEAR(*m.time_half_D, 51, 1e-9) << "the first row beyond 0.5 D but for the jitter";
  EXPECT_FALSE(m.time_D);
  EXPECT_NEAR(run.quantity("u_end")->value, 0.4 * D, 1e-9);
  EXPECT_NEAR(run.quantity("u_end_of_drag")->value, 0.4 * D, 1e-9) << "not the largest";
}

TEST(Displacements, are_drawn_over_time_and_by_half_cycle_and_begin_the_page)
{
  const record::RunRecord run = moved();
  const base::Charts charts = structures::structure_of(run.settings).charts(run);
  const base::Curve in_time = curves_in(charts, "u_t").at(0), cycles = curves_in(charts, "half_cycles").at(0);
  ASSERT_EQ(in_time.x.size(), 161u) << "the row before the stage and its rows";
  EXPECT_NEAR(in_time.x.back() - in_time.x.front(), 160, 1e-9);
  EXPECT_NEAR(in_time.y.back(), 0.4 * D, 1e-9);
  EXPECT_EQ(cycles.x, (std::vector<Real>{1, 2, 3}));
  EXPECT_NEAR(cycles.y[2], 0.2 * D, 0.006 * D);
  const base::DisplayUnits shown({{base::body_scale(run), &run.quantities}});
  const base::Headline numbers = structures::structure_of(run.settings).headline(run, shown);
  ASSERT_GE(numbers.size(), 3u);
  EXPECT_EQ(numbers[0].quantity, "u_largest");
  EXPECT_NE(numbers[0].beside.find("time_scale = 1"), std::string::npos) << numbers[0].beside;
}

TEST(Displacements, are_told_in_the_time_of_the_load_history)
{
  record::RunRecord run = moved();
  run.settings.stage.back().time_scale = 0.1;
  const Stages stages = stages_of(run.settings);
  const Displacements m = *results_from(run.history, base::body_scale(run), stages).drags.back().moved;
  EXPECT_NEAR(*m.time_half_D, 510, 1e-6);
  EXPECT_NE(half_cycles_csv(run.history, stages, D).find("storm,1,0,800,"), std::string::npos) << half_cycles_csv(run.history, stages, D);
}

TEST(Displacements, are_no_resistance)
{
  const record::RunRecord run = moved();
  for (const char* name : {"H_max", "H_breakout", "H_residual", "H_noise", "H_at_u_0.1D"}) EXPECT_EQ(run.quantity(name), nullptr) << name;
  EXPECT_EQ(run.quantity("H_end_of_drag")->kind, run_folder::QuantityKind::prescribed);
}

std::string words_of(const record::RunRecord& run)
{
  return results_in_words(DrivenRun(run), base::DisplayUnits({{base::body_scale(run), &run.quantities}}));
}

/// The same with another time scale: the run took as long, so that the record is longer.
record::RunRecord moved_at(Real time_scale)
{
  record::RunRecord run = moved();
  settings::StageSettings& storm = run.settings.stage.back();
  storm.time_scale = time_scale;
  for (Real& time : storm.load_times) time /= time_scale;
  run.quantities = structures::structure_of(run.settings).quantities(run, {});
  return run;
}

TEST(Displacements, are_said_to_be_of_a_mass_and_of_the_times_of_the_load)
{
  record::RunRecord run = moved();
  run.settings.rigid.front().second.mass = 2.5;
  EXPECT_NE(words_of(run).find("That is for its mass of 2.5 kg/m and for a record of 160 s in 160 s of the run, time_scale = 1"),
            std::string::npos)
      << words_of(run);
}

TEST(Displacements, of_a_body_that_breaks_out_are_a_lower_estimate_where_the_run_is_faster_than_its_record)
{
  EXPECT_TRUE(lower_estimates(moved()).empty()) << "it runs in real time";
  const record::RunRecord fast = moved_at(0.5);
  ASSERT_EQ(lower_estimates(fast).size(), 1u);
  EXPECT_NE(
      lower_estimates(fast)[0].find("\"storm\" is a lower estimate: its record ran with time_scale = 0.5, and the pipe moved by 0.8 D in "
                                    "a half cycle"),
      std::string::npos)
      << lower_estimates(fast)[0];
  const base::Structure& structure = structures::structure_of(fast.settings);
  for (const char* words :
       {"\"storm\" is a record of 320 s in 160 s of the run, time_scale = 0.5", "half_cycles.csv", "Run with time_scale = 1"})
    EXPECT_NE(structure.table_of(fast).find(words), std::string::npos) << words << " in " << structure.table_of(fast);
  for (const char* words : {"is a lower estimate", "exceeds 0.5 D after 1.7 min of the record", "time_scale = 0.5"})
    EXPECT_NE(words_of(fast).find(words), std::string::npos) << words << " in " << words_of(fast);
  ASSERT_NE(fast.quantity("time_scale"), nullptr);
  EXPECT_EQ(fast.quantity("time_scale")->value, 0.5);
  EXPECT_EQ(fast.quantity("time_scale")->kind, run_folder::QuantityKind::prescribed);
}

TEST(Displacements, of_a_body_that_the_soil_holds_do_not_depend_on_the_time_scale)
{
  record::RunRecord run = moved_at(0.5);
  for (Real& u : run.history.values[1]) u /= 10;  // 0.08 D at most
  EXPECT_TRUE(lower_estimates(run).empty());
  const auto drag = [&] { return path_of(run.history, stages_of(run.settings)).drags.back(); };
  // The last half cycle is 0.02 D within 20 s of the run: m a is m 0.2 mm (pi/20 s)^2, a tenth of 100 N/m for 2.03e6 kg/m.
  EXPECT_FALSE(is_accelerated(drag(), run.history, D, 2e6));
  EXPECT_TRUE(is_accelerated(drag(), run.history, D, 2.06e6)) << "its inertia matters";
}

TEST(Displacements, have_a_table_of_their_half_cycles)
{
  const record::RunRecord run = moved();
  const std::string csv = half_cycles_csv(run.history, stages_of(run.settings), D);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 4);
  EXPECT_NE(csv.find("\nstorm,2,"), std::string::npos);
  EXPECT_EQ(half_cycles_csv(MadeRun{}.record().history, stages_of(MadeRun{}.settings()), D), "");
}

}  // namespace
}  // namespace berm::driven::this_file
