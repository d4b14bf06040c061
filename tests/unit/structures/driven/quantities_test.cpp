// SPDX-License-Identifier: BSD-3-Clause
#include "structures/driven/quantities.hpp"

#include "samples/history_columns.hpp"
#include "samples/run_to_write.hpp"
#include "structures/base/answer.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <gtest/gtest.h>

namespace berm::driven::this_file {
namespace {

const BodyScale scale{.width = 0.02, .unit_weight = 430e3, .gravity_level = 50};
const Stages stages{Stage{.name = "push", .kind = settings::StageKind::push}, Stage{.name = "drag", .kind = settings::StageKind::drag}};

std::vector<run_folder::Quantity> pipe_quantities(const run_folder::History& history, const BodyScale& of, const Stages& by)
{
  return driven::quantities_of(results_from(history, of, by), of);
}

std::vector<run_folder::Quantity> quantities_of(const SamplePipe& pipe, const Stages& by = stages)
{
  const TemporaryFolder folder;
  pipe.write(folder.path() / "h");
  return pipe_quantities(run_folder::read_history(folder.path() / "h"), scale, by);
}

const run_folder::Quantity* find(const std::vector<run_folder::Quantity>& list, const std::string& name)
{
  const auto found = std::find_if(list.begin(), list.end(), [&](const run_folder::Quantity& q) { return q.name == name; });
  return found == list.end() ? nullptr : &*found;
}

Real value(const std::vector<run_folder::Quantity>& list, const std::string& name)
{
  const run_folder::Quantity* q = find(list, name);
  EXPECT_NE(q, nullptr) << name;
  return q == nullptr ? std::numeric_limits<Real>::quiet_NaN() : q->value;
}

TEST(PipeQuantities, a_linear_push_is_read_exactly_up_to_its_very_end)
{
  const SamplePipe pipe;
  const auto list = quantities_of(pipe);
  for (const auto& [name, w] :
       std::vector<std::pair<std::string, Real>>{{"0.05", 0.05}, {"0.1", 0.1}, {"0.15", 0.15}, {"0.2", 0.2}, {"0.25", 0.25}})
    EXPECT_NEAR(value(list, "V_at_w_" + name + "D"), pipe.stiffness * w * pipe.D, 1e-6) << name;
  EXPECT_EQ(find(list, "V_at_w_0.3D"), nullptr);
  EXPECT_NEAR(value(list, "V_end_of_push"), pipe.stiffness * 0.25 * pipe.D, 1e-6);
  EXPECT_NEAR(value(list, "w_end_of_push"), 0.25 * pipe.D, 1e-12);
  EXPECT_NEAR(value(list, "w_end_of_push_over_D"), 0.25, 1e-12);
  EXPECT_NEAR(value(list, "V_at_w_0.1D_over_gammaD2"), pipe.stiffness * 0.002 / (430e3 * 0.0004), 1e-9);
  EXPECT_EQ(find(list, "V_at_w_0.1D")->unit, "N/m");
  EXPECT_EQ(find(list, "V_at_w_0.1D_over_gammaD2")->unit, "1");
  EXPECT_EQ(find(list, "w_end_of_push")->unit, "m");
}

TEST(PipeQuantities, a_push_that_begins_in_the_bed_is_read_at_its_travel_from_there)
{
  // V = 5 kN/m2 of travel, from the row before the push on, in steps of 0.001 D; noise in the first 0.0025 D would reach over a quarter of it.
  const auto list_from = [](Real begin, bool noisy) {
    const TemporaryFolder folder;
    {
      NamedHistory file(folder.path() / "h", {"u_m", "w_m", "H_N_m", "V_N_m"});
      file.add(0, "rest", {0, begin * scale.width, 0, 0});
      for (int k = 1; k <= 20; ++k) file.add(k, "push", {0, (begin + 0.001 * k) * scale.width, 0, 5e3 * 0.001 * k});
    }
    BodyScale by = scale;
    by.noisy = noisy;
    return pipe_quantities(run_folder::read_history(folder.path() / "h"), by, stages);
  };
  for (const bool noisy : {true, false}) {
    const auto list = list_from(0.1, noisy);
    EXPECT_NEAR(value(list, "V_at_travel_0.0025D"), 12.5, 1e-9);
    EXPECT_NEAR(value(list, "V_at_travel_0.005D"), 25, 1e-9);
    EXPECT_NEAR(value(list, "V_at_travel_0.01D"), 50, 1e-9);
    EXPECT_NEAR(value(list, "V_at_travel_0.02D"), 100, 1e-9);
    EXPECT_EQ(find(list, "V_at_travel_0.03D"), nullptr);
  }
  EXPECT_EQ(find(list_from(0, true), "V_at_travel_0.01D"), nullptr);
}

TEST(Results, come_back_from_their_quantities)
{
  const BodyScale by{.width = 0.02, .unit_weight = 430e3};
  Results results;
  results.push = {{0.003, 300}, {0.004, 400}};
  results.push_end = PushPoint{0.0045, 450};
  results.travel = {{0.0002, 7}};
  DragResults drag{.stage = "drag"}, back{.stage = "back"};
  drag.points = {{0.002, 0.005, 300, 600}, {0.015, 0.006, 310, 620}};
  drag.largest = DragPeak{0.016, 320};
  drag.H_noise = 0.01;
  back.largest = DragPeak{0.004, 250};
  back.end = DragPoint{0.02, 0.007, 240, 610};
  back.berm_height = 0.003;
  results.drags = {drag, back};
  results.other_pushes = {{"unload", 0.0044, 200}};
  results.gap_mean = 1e-5;
  const std::vector<run_folder::Quantity> quantities = driven::quantities_of(results, by);
  EXPECT_EQ(value(quantities, "V_at_w_0.15D"), 300);
  EXPECT_EQ(value(quantities, "H_over_V_at_u_0.75D"), 0.5);
  EXPECT_EQ(value(quantities, "H_max"), 320);
  EXPECT_EQ(value(quantities, "back.H_max"), 250);
  EXPECT_EQ(value(quantities, "unload.V_end"), 200);
  Stages three = stages;
  three.push_back({.name = "unload", .kind = settings::StageKind::push});
  three.push_back({.name = "back", .kind = settings::StageKind::drag});
  three.push_back({.name = "never", .kind = settings::StageKind::drag});
  const Results read = results_of(quantities, by, three);
  ASSERT_EQ(read.push.size(), 2u);
  EXPECT_DOUBLE_EQ(read.push[1].w, 0.004);
  EXPECT_EQ(read.push[1].V, 400);
  EXPECT_EQ(read.push_end->w, 0.0045);
  ASSERT_EQ(read.travel.size(), 1u);
  ASSERT_EQ(read.drags.size(), 2u) << "the drag that was never begun has no results";
  ASSERT_EQ(read.drag().points.size(), 2u);
  EXPECT_DOUBLE_EQ(read.drag().points[1].V, 620);
  EXPECT_EQ(read.drag().largest->H, 320);
  EXPECT_EQ(read.drag().H_noise, 0.01);
  EXPECT_EQ(read.drags[1].stage, "back");
  EXPECT_EQ(read.drags[1].end->H, 240);
  EXPECT_EQ(read.drags[1].berm_height, 0.003);
  ASSERT_EQ(read.other_pushes.size(), 1u);
  EXPECT_EQ(read.other_pushes[0].V, 200);
  EXPECT_EQ(read.gap_mean, 1e-5);
  EXPECT_FALSE(read.V_noise || read.overlap_max || read.second_impulse_over_V);
  const std::vector<run_folder::Quantity> again = driven::quantities_of(read, by);
  ASSERT_EQ(again.size(), quantities.size());
  for (std::size_t k = 0; k < again.size(); ++k) EXPECT_EQ(again[k].name, quantities[k].name);
}

TEST(Results, in_space_are_forces_without_the_twin_of_plane_strain)
{
  Results results;
  results.push_end = PushPoint{0.01, 5};
  const auto list = driven::quantities_of(results, {.width = 0.02, .unit_weight = 1, .dimension = 3});
  EXPECT_EQ(find(list, "V_end_of_push")->unit, "N");
  EXPECT_EQ(find(list, "V_end_of_push_over_gammaD2"), nullptr);
}

TEST(PipeQuantities, forces_without_noise_are_taken_between_two_rows)
{
  // Rises to its plateau within the window of +-0.01 D that noise would be averaged over, from an embedment of 0.1 D.
  const TemporaryFolder folder;
  {
    NamedHistory file(folder.path() / "h", {"u_m", "w_m", "H_N_m", "V_N_m"});
    for (const auto& [w, V] : std::vector<std::pair<Real, Real>>{{0.1, 0}, {0.105, 900}, {0.11, 1000}})
      file.add(w, "push", {0, w * scale.width, 0, V});
  }
  BodyScale exact = scale;
  exact.noisy = false;
  const auto list = pipe_quantities(run_folder::read_history(folder.path() / "h"), exact, stages);
  EXPECT_EQ(value(list, "V_end_of_push"), 1000);
  EXPECT_EQ(value(list, "V_at_w_0.1D"), 0);
  EXPECT_EQ(find(list, "V_at_w_0.05D"), nullptr);  // above where the push began
  EXPECT_EQ(find(list, "V_noise"), nullptr);
}

TEST(PipeQuantities, a_drag_is_read_at_its_travel_as_far_as_it_went)
{
  const SamplePipe pipe;
  const auto list = quantities_of(pipe);
  for (const Real part : {0.1, 0.2, 0.3, 0.4, 0.5}) {
    const std::string at = fmt::format("_at_u_{:g}D", part);
    const Real u = part * pipe.D;
    // The mean over +-0.01 D of a curve differs from its value by half^2/6 of its second derivative, at most 0.77 H_end/a^2.
    const Real bend = 0.77 * pipe.H_end / (pipe.a * pipe.a) * 2e-4 * 2e-4 / 6;
    EXPECT_NEAR(value(list, "H" + at), pipe.H(u), 2 * bend);
    EXPECT_NEAR(value(list, "w" + at), pipe.w(u), 1e-12);
    EXPECT_NEAR(value(list, "w" + at + "_over_D"), pipe.w(u) / pipe.D, 1e-9);
    EXPECT_NEAR(value(list, "H_over_V" + at), pipe.H(u) / (pipe.stiffness * 0.25 * pipe.D), 2 * bend / 2000);
  }
  EXPECT_EQ(find(list, "H_at_u_0.75D"), nullptr);
  EXPECT_GE(value(list, "H_max"), value(list, "H_at_u_0.5D"));  // H grows to the end
  EXPECT_NEAR(value(list, "H_max"), pipe.H(pipe.drag), 0.3);
  EXPECT_NEAR(value(list, "u_at_H_max"), pipe.drag, 1e-12);
  EXPECT_NEAR(value(list, "V_rms_error_in_drag"), 0, 1e-12);
}

TEST(PipeQuantities, noise_from_row_to_row_is_averaged_away_and_its_size_is_told)
{
  SamplePipe pipe;
  pipe.ripple = 100;
  const auto list = quantities_of(pipe);
  // Eleven rows of alternating noise leave at most a tenth of it; twice that at an end.
  EXPECT_NEAR(value(list, "V_at_w_0.1D"), pipe.stiffness * 0.1 * pipe.D, 10);
  EXPECT_NEAR(value(list, "H_at_u_0.3D"), pipe.H(0.3 * pipe.D), 12);
  EXPECT_NEAR(value(list, "H_max"), pipe.H(pipe.drag), 40);
  EXPECT_NEAR(value(list, "V_rms_error_in_drag"), 100 / (pipe.stiffness * 0.25 * pipe.D), 1e-4);
}

TEST(PipeQuantities, noise_is_the_deviation_from_the_moving_mean_over_the_mean_magnitude)
{
  const SamplePipe quiet;
  const auto without = quantities_of(quiet);
  EXPECT_NEAR(value(without, "V_noise"), 0, 1e-12);
  EXPECT_NEAR(value(without, "H_noise"), 0, 1e-3);  // the curve itself bends
  SamplePipe pipe;
  pipe.ripple = 100;
  const auto list = quantities_of(pipe);
  // Rows of +100 and -100 N/m have a moving mean of zero; the means of V and H are those from 0.02 D of push and 0.1 D of drag on.
  Real H = 0;
  for (int k = 50; k <= 250; ++k) H += pipe.H(k * 0.002 * pipe.D) / 201;
  EXPECT_NEAR(value(list, "V_noise"), 100 / (pipe.stiffness * 0.135 * pipe.D), 0.001);
  EXPECT_NEAR(value(list, "H_noise"), 100 / H, 0.001);
  pipe.H_end = 0;
  EXPECT_NEAR(value(quantities_of(pipe), "H_noise"), 1, 0.02) << "a force without a mean is no larger than its noise";
  EXPECT_EQ(find(list, "V_noise")->unit, "1");
}

TEST(PipeQuantities, noise_is_not_told_of_rows_too_far_apart)
{
  const TemporaryFolder folder;
  {
    NamedHistory file(folder.path() / "h", {"u_m", "w_m", "H_N_m", "V_N_m"});
    for (int k = 0; k <= 20; ++k) file.add(k, "push", {0, k * 0.01 * scale.width, 0, k % 2 == 0 ? 900. : 1100.});
  }
  EXPECT_EQ(find(pipe_quantities(run_folder::read_history(folder.path() / "h"), scale, stages), "V_noise"), nullptr);
}

TEST(PipeQuantities, the_second_impulse_is_told_over_V_of_the_push)
{
  SamplePipe pipe;
  pipe.second = 0.25;
  EXPECT_NEAR(value(quantities_of(pipe), "second_impulse_over_V"), 0.25, 1e-12);
}

TEST(PipeQuantities, the_error_in_V_counts_from_the_held_force_where_it_is_given)
{
  Stages held = stages;
  held[1].held_force = 1600;
  EXPECT_NEAR(value(quantities_of({}, held), "V_rms_error_in_drag"), 0.25, 1e-12);  // V is 2000 N/m
}

TEST(PipeQuantities, a_push_alone_has_no_numbers_of_a_drag)
{
  Stages push_only = stages;
  push_only.pop_back();
  const auto list = quantities_of({}, push_only);
  EXPECT_NE(find(list, "V_end_of_push"), nullptr);
  for (const run_folder::Quantity& q : list) EXPECT_EQ(q.name.find("_at_u_"), std::string::npos) << q.name;
  EXPECT_EQ(find(list, "H_max"), nullptr);
}

TEST(PipeQuantities, contact_numbers_cover_push_and_drag_only)
{
  const auto list = quantities_of({});
  EXPECT_NEAR(value(list, "overlap_max_over_D"), 2e-5 / 0.02, 1e-12);
  // 131 rows of push and 250 of drag; the stage before, with its gap of 1e9, does not count.
  EXPECT_NEAR(value(list, "gap_mean"), (131 * 1e-4 + 250 * 3e-4) / 381, 1e-12);
}

TEST(PipeQuantities, of_a_run_that_stopped_early_there_is_what_was_reached)
{
  const TemporaryFolder folder;
  put_schema(folder.path() / "h", {"time_s", "u_m", "w_m", "H_N_m", "V_N_m"});
  put(folder.path() / "h", "time_s,stage,u_m,w_m,H_N_m,V_N_m\n");
  EXPECT_TRUE(pipe_quantities(run_folder::read_history(folder.path() / "h"), scale, stages).empty());
  put(folder.path() / "h", "time_s,stage,u_m,w_m,H_N_m,V_N_m\n0,drag,0,0.001,nan,nan\n");
  EXPECT_NO_THROW(pipe_quantities(run_folder::read_history(folder.path() / "h"), scale, stages));
}

TEST(PipeQuantities, weightless_soil_has_no_gamma_to_divide_by)
{
  const TemporaryFolder folder;
  SamplePipe{}.write(folder.path() / "h");
  for (const run_folder::Quantity& q :
       pipe_quantities(run_folder::read_history(folder.path() / "h"), {.width = 0.02, .unit_weight = 0}, stages))
    EXPECT_EQ(q.name.find("gamma"), std::string::npos);
}

TEST(KeyResults, give_model_dimensionless_and_prototype_values)
{
  const std::string table = base::log_table(quantities_of({}), scale);
  std::istringstream lines(table);
  std::string line;
  while (std::getline(lines, line) && line.rfind("V_at_w_0.1D ", 0) != 0) {
  }
  // 800 N/m; over 430e3 * 0.02^2 = 172 N/m; times 50.
  EXPECT_NE(line.find("800.0 N/m"), std::string::npos) << table;
  EXPECT_NE(line.find("4.651"), std::string::npos) << table;
  EXPECT_NE(line.find("40.00 kN/m"), std::string::npos) << table;
  // In clay over D s_u, 20 mm times 2 kPa.
  const std::string clay = base::log_table(quantities_of({}), {.width = 0.02, .unit_weight = 430e3, .strength = 2e3});
  EXPECT_NE(clay.find("20.00"), std::string::npos) << clay;
  EXPECT_NE(clay.find("forces over D s_u with s_u = 2 kPa, lengths over D"), std::string::npos) << clay;
  // One gravity rounded, and none at all, make no prototype.
  for (const Real level : {1., 10 / 9.81, 0.})
    EXPECT_EQ(base::log_table(quantities_of({}), {.width = 0.02, .unit_weight = 430e3, .gravity_level = level}).find("prototype"),
              std::string::npos);
}

}  // namespace
}  // namespace berm::driven::this_file
