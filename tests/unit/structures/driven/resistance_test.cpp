// SPDX-License-Identifier: BSD-3-Clause
#include "structures/driven/resistance.hpp"

#include "samples/made_run.hpp"

#include <gtest/gtest.h>

namespace berm::driven::this_file {
namespace {

constexpr Real D = 0.02;

Resistance of(const std::function<Real(Real u_over_D)>& H, Real dragged = D, settings::Method method = settings::Method::mpm)
{
  MadeRun made;
  made.dragged = dragged;
  made.method = method;
  made.H = [&](Real u) { return H(u / D); };
  return resistance_of(DrivenRun(made.record()));
}

/// Up to 300 N/m at 0.3 D, down to `after` at 0.6 D, level from there.
Real with_a_peak(Real x, Real after)
{
  return x < 0.3 ? 1000 * x : x < 0.6 ? std::lerp(300, after, (x - 0.3) / 0.3) : after;
}

TEST(resistance, breakout_is_where_H_falls_from)
{
  const Resistance found = of([](Real x) { return with_a_peak(x, 200); });
  ASSERT_TRUE(found.breakout);
  EXPECT_NEAR(found.breakout->u, 0.3 * D, 0.005 * D);
  EXPECT_NEAR(found.breakout->H, 300, 0.02 * 300);  // the corner is rounded by the averaging
  ASSERT_TRUE(found.residual);
  EXPECT_NEAR(*found.residual, 200, 1e-6);
  ASSERT_TRUE(found.residual_from);
  EXPECT_NEAR(*found.residual_from, 0.57 * D, 0.005 * D) << "H = 210, 5 % above the residual";
}

TEST(resistance, is_residual_from_where_it_stays_so)
{
  // On its way to a trough H passes the residual.
  const Resistance found = of([](Real x) {
    return x < 0.3 ? 1000 * x : x < 0.4 ? 300 - 2000 * (x - 0.3) : x < 0.7 ? std::lerp(100, 200, (x - 0.4) / 0.3) : 200;
  });
  ASSERT_TRUE(found.residual && found.residual_from);
  EXPECT_NEAR(*found.residual, 200, 1e-6);
  EXPECT_NEAR(*found.residual_from, 0.67 * D, 0.01 * D) << "H = 190, 5 % below the residual";
}

TEST(resistance, a_fall_of_less_than_5_percent_is_no_breakout)
{
  const Resistance found = of([](Real x) { return with_a_peak(x, 290); });
  EXPECT_FALSE(found.breakout);
  EXPECT_FALSE(found.residual_from);
  EXPECT_EQ(no_peak_words(found, "to the end of the drag"), "no peak: H levels off");
}

TEST(resistance, the_first_of_two_peaks_is_the_breakout)
{
  // The berm makes H grow beyond the breakout later.
  const Resistance found = of([](Real x) { return x < 0.6 ? with_a_peak(x, 200) : 200 + 1000 * (x - 0.6); });
  ASSERT_TRUE(found.breakout);
  EXPECT_NEAR(found.breakout->u, 0.3 * D, 0.005 * D);
  EXPECT_FALSE(found.residual);
}

TEST(resistance, H_that_grows_to_the_end_has_no_peak_and_no_residual)
{
  const Resistance found = of([](Real x) { return 600 * x; });
  EXPECT_FALSE(found.breakout);
  EXPECT_FALSE(found.residual);
  EXPECT_NEAR(found.last_change, 0.1 / 0.95, 1e-6);
  EXPECT_EQ(no_peak_words(found, "to the end of the drag"), "no peak: H grows to the end of the drag");
}

TEST(resistance, waves_of_a_dynamic_method_are_no_breakout)
{
  // Waves of 0.06 D that fall by 8 %, on H that grows.
  const auto waves = [](Real x) { return 100 + 600 * x + 30 * std::sin(2 * pi * x / 0.06); };
  EXPECT_FALSE(of(waves).breakout);
  EXPECT_FALSE(of(waves, D, settings::Method::fem).breakout);
}

// H that is level but for wiggles of 0.25 D, longer than what a peak has to stay: each falls by 10 %, and so it is no peak.
TEST(resistance, a_wiggle_among_others_is_no_breakout_and_a_peak_that_stands_out_of_them_is)
{
  const auto wiggles = [](Real x) { return 15 * std::sin(2 * pi * x / 0.25); };
  const Resistance level = of([&](Real x) { return 300 * std::min(1., x / 0.05) + wiggles(x); }, 2 * D);
  EXPECT_FALSE(level.breakout);
  EXPECT_TRUE(level.peak_in_noise);
  EXPECT_EQ(no_peak_words(level, "to the end of the drag").find("no peak above the noise of H"), 0U);
  const Resistance peak = of([&](Real x) { return with_a_peak(x, 150) + wiggles(x); }, 2 * D);
  ASSERT_TRUE(peak.breakout);
  EXPECT_NEAR(peak.breakout->u, 0.3 * D, 0.02 * D);
  const Resistance quiet = of([](Real x) { return 300 * std::min(1., x / 0.05); }, 2 * D);
  EXPECT_FALSE(quiet.breakout || quiet.peak_in_noise);
}

// After a steep start H grows with the soil that the pipe heaps up, and falls by a sixth for 0.3 D once it is 1.4 D away.
TEST(resistance, a_fall_beyond_1_D_is_no_breakout_and_H_that_grows_has_an_onset)
{
  const auto H = [](Real x) { return (250 + 100 * x) * std::min(1., x / 0.02); };
  const Resistance found = of([&](Real x) { return H(x) * (x > 1.4 && x < 1.7 ? 5. / 6 : 1); }, 3 * D);
  EXPECT_FALSE(found.breakout);
  EXPECT_EQ(no_peak_words(found, "to the end of the drag").find("no peak within 1 D"), 0U);
  ASSERT_TRUE(found.onset);
  EXPECT_NEAR(*found.onset, 250, 1e-6);
  EXPECT_NEAR(*of([](Real x) { return 250 * std::min(1., x / 0.02); }).onset, 250, 1e-6) << "H that is level";
  EXPECT_FALSE(of([](Real x) { return 600 * x; }).onset) << "H that grows from nothing";
  EXPECT_FALSE(of(H, 0.45 * D).onset) << "too short to tell";
  EXPECT_FALSE(of([](Real x) { return with_a_peak(x, 200); }).onset) << "a peak says where it breaks out";
}

TEST(resistance, of_finite_elements_an_increment_that_relaxes_is_no_breakout)
{
  const auto H = [](Real x) { return 300 * std::min(1., x / 0.05); };
  const auto relaxed = [&](Real x) { return H(x) * (x > 0.099 && x < 0.111 ? 0.93 : 1) - 0.1 * x; };
  EXPECT_FALSE(of(relaxed, 0.5 * D, settings::Method::fem).breakout);
  // The same fall that stays is one; also in a drag that is shorter than 0.3 D.
  const auto fallen = [&](Real x) { return H(x) * (x > 0.099 ? 0.93 : 1) - 0.1 * x; };
  for (const Real travel : {0.5 * D, 0.2 * D}) {
    const Resistance found = of(fallen, travel, settings::Method::fem);
    ASSERT_TRUE(found.breakout) << travel / D;
    EXPECT_NEAR(found.breakout->H, 300, 0.01 * 300);
  }
}

TEST(resistance, a_short_drag_is_residual_only_if_its_last_tenth_of_D_is_level)
{
  // Changes by 2.4 % over the last tenth of the drag of 0.3 D, and by 8 % over its last 0.1 D.
  const auto H = [](Real x) { return 100 * (1 + 0.8 * (x - 0.3)); };
  EXPECT_FALSE(of(H, 0.3 * D).residual);
  const Resistance level = of([](Real x) { return x < 0.1 ? 1000 * x : 100 * (1 + 0.1 * (x - 0.1)); }, 0.3 * D);
  ASSERT_TRUE(level.residual);
  EXPECT_NEAR(*level.residual, 101.5, 0.01);
}

TEST(resistance, the_largest_H_may_be_the_last)
{
  const Resistance found = of([](Real x) { return 600 * x; }, 0.65 * D);  // of which no quantity tells
  ASSERT_TRUE(found.largest);
  EXPECT_NEAR(found.largest->u, 0.65 * D, 1e-12);
  EXPECT_NEAR(found.largest->H, 390, 1e-9);
  EXPECT_NEAR(found.V_at_largest, 800, 1e-9);
  EXPECT_NEAR(found.travel, 0.65 * D, 1e-12);
}

TEST(resistance, of_a_long_history_is_that_of_a_short_one)
{
  const auto with_rows = [](int rows) {
    std::vector<Real> u, H;
    for (int k = 0; k < rows; ++k) {
      const Real x = Real(k) / (rows - 1);
      u.push_back(x * D);
      H.push_back(400 * std::sin(4 * x) * std::exp(-x) + 150 * x);
    }
    return resistance_to({u, H}, {.width = D, .unit_weight = 0});
  };
  const Resistance few = with_rows(1001), many = with_rows(100001);
  ASSERT_TRUE(few.breakout && many.breakout);
  EXPECT_NEAR(many.breakout->u, few.breakout->u, 1e-3 * D);
  EXPECT_NEAR(many.breakout->H, few.breakout->H, 1e-4 * few.breakout->H);
  EXPECT_NEAR(many.largest->H, few.largest->H, 1e-4 * few.largest->H);
  EXPECT_NEAR(many.last_change, few.last_change, 1e-4 * std::abs(few.last_change));
}

TEST(resistance, a_run_without_a_drag_has_none)
{
  const Resistance found = of([](Real) { return 0; }, 0);
  EXPECT_FALSE(found.breakout);
  EXPECT_FALSE(found.residual);
  EXPECT_TRUE(std::isnan(found.last_change));
}

/// A pipe that is swept out by 1.5 D and back, twice, with H of 100 N/m but for its third way, over u/D along the travel.
record::RunRecord swept(const std::function<Real(Real u_over_D)>& third, Real third_travel = 1.5)
{
  MadeRun made;
  made.dragged = 0;
  record::RunRecord run = made.record();
  Real u = 0;
  for (int sweep = 0; sweep < 4; ++sweep) {
    const Real direction = sweep % 2 == 0 ? 1 : -1, travel = sweep == 2 ? third_travel : 1.5, step = 0.002;
    run.settings.stage.push_back(MadeRun::stage_of("sweep_" + std::to_string(sweep + 1), settings::StageKind::drag));
    run.settings.stage.back().velocity = 0.1 * direction;
    for (int k = 1; k * step <= travel + step / 2; ++k) {
      const Real x = k * step, H = sweep == 2 ? third(x) : std::min(100., 500 * x);
      const Real row[] = {static_cast<Real>(run.history.rows()), u + direction * x * D, made.pushed_to, direction * H, made.held_V};
      for (int column = 0; column < 5; ++column) run.history.values[column].push_back(row[column]);
      run.history.stage.push_back(run.settings.stage.back().name);
    }
    u += direction * travel * D;
  }
  run.quantities = structures::structure_of(run.settings).quantities(run, {});
  return run;
}

/// 50 N/m until it grows to 90 N/m over the last D but for the last 0.2 D.
Real into_a_berm(Real x)
{
  return x < 0.1 ? 500 * x : x < 0.5 ? 50 : x < 1.3 ? std::lerp(50., 90., (x - 0.5) / 0.8) : 90;
}

TEST(resistance, that_grows_into_the_berm_of_an_earlier_sweep_is_no_residual_though_it_levels_off)
{
  const auto grows = [](Real x) { return x < 1.3 ? 200 * x / 1.3 : 200; };
  const record::RunRecord run = swept(grows);
  EXPECT_EQ(run.quantity("sweep_3.H_residual"), nullptr);
  ASSERT_NE(run.quantity("sweep_3.H_berm"), nullptr);
  EXPECT_NEAR(run.quantity("sweep_3.H_berm")->value, 200, 1e-6);
  EXPECT_NEAR(run.quantity("H_residual")->value, 100, 1e-6) << "the first sweep meets no berm";
  EXPECT_NEAR(run.quantity("sweep_2.H_residual")->value, 100, 1e-6) << "nor does the way back to where it began";
  EXPECT_NEAR(run.quantity("sweep_4.H_residual")->value, 100, 0.1) << "its plateau begins farther than D before the berm of sweep_2";
  EXPECT_EQ(run.quantity("sweep_4.H_berm"), nullptr);
}

TEST(resistance, before_the_berm_of_an_earlier_sweep_is_the_residual_where_it_is_a_plateau)
{
  const record::RunRecord run = swept(into_a_berm);
  EXPECT_NEAR(run.quantity("sweep_3.H_residual")->value, 50, 0.5);
  EXPECT_NEAR(run.quantity("sweep_3.H_berm")->value, 90, 1e-6);
}

TEST(resistance, beyond_the_berm_of_an_earlier_sweep_may_be_residual)
{
  const auto late = [](Real x) { return std::min(100., 100 * x / 1.6); };
  const record::RunRecord near = swept(late, 2.4), far = swept(late, 2.6);
  EXPECT_EQ(near.quantity("sweep_3.H_residual"), nullptr) << "0.9 D beyond";
  EXPECT_NEAR(near.quantity("sweep_3.H_berm")->value, 100, 1e-6);
  ASSERT_NE(far.quantity("sweep_3.H_residual"), nullptr) << "1.1 D beyond";
  EXPECT_EQ(far.quantity("sweep_3.H_berm"), nullptr);
}

TEST(resistance, that_grows_over_swept_ground_to_its_end_is_that_of_a_berm)
{
  const record::RunRecord run = swept([](Real x) { return 100 * x; }, 2.6);
  EXPECT_EQ(run.quantity("sweep_3.H_residual"), nullptr);
  ASSERT_NE(run.quantity("sweep_3.H_berm"), nullptr);
  EXPECT_NEAR(run.quantity("sweep_3.H_berm")->value, 247, 1) << "the mean over the last 0.26 D";
  const Resistance fresh = of([](Real x) { return 100 * x; }, 2.6 * D);
  EXPECT_FALSE(fresh.berm) << "on fresh ground H grows";
}

TEST(resistance, of_a_drag_that_goes_on_with_an_earlier_one_meets_no_berm_of_it)
{
  record::RunRecord run = swept([](Real x) { return std::min(100., 500 * x); });
  for (std::string& stage : run.history.stage)
    if (stage == "sweep_1" && run.history["u_m"][&stage - run.history.stage.data()] > 0.75 * D) stage = "on";
  settings::StageSettings on = MadeRun::stage_of("on", settings::StageKind::drag);
  run.settings.stage.insert(run.settings.stage.begin() + 2, on);
  run.quantities = structures::structure_of(run.settings).quantities(run, {});
  EXPECT_EQ(run.quantity("on.H_berm"), nullptr);
  EXPECT_NEAR(run.quantity("on.H_residual")->value, 100, 1e-6);
}

}  // namespace
}  // namespace berm::driven::this_file
