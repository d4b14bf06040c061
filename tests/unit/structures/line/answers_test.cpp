// SPDX-License-Identifier: BSD-3-Clause
#include "structures/line/answers.hpp"

#include "samples/made_line_run.hpp"
#include "structures/line/tables.hpp"
#include "structures/structures.hpp"
#include "text/quantity_words.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace berm::line::this_file {
namespace {

using test::MadeLineRun;

class LineAnswers : public testing::Test {
protected:
  record::RunRecord record_of(const MadeLineRun& made)
  {
    record::RunRecord run = made.record(folder_);
    run.quantities = structures::structure_of(run.settings).quantities(run, {});
    return run;
  }
  static Real value(const record::RunRecord& run, const std::string& name)
  {
    const run_folder::Quantity* found = run.quantity(name);
    return found == nullptr ? nan : found->value;
  }
  TemporaryFolder folder_;
};

TEST_F(LineAnswers, at_the_end_of_a_stage_are_those_of_its_last_row_and_shape)
{
  const record::RunRecord run = record_of({});
  EXPECT_NEAR(value(run, "heat.y"), 1.9, 1e-12);
  EXPECT_NEAR(value(run, "heat.lobe_length"), MadeLineRun::lobe, 0.05);
  EXPECT_EQ(value(run, "heat.lobes"), 3);
  EXPECT_NEAR(value(run, "heat.slip_length"), MadeLineRun::slip_end * (1 - 2e-3 / 0.1), 1e-6);
  EXPECT_NEAR(value(run, "cool.slip_length"), MadeLineRun::slip_end * (1 - 2e-3 / 0.04), 1e-6);
  EXPECT_NEAR(value(run, "heat.strain_bending"), 1.3e-3, 1e-12);
  EXPECT_TRUE(std::isnan(value(run, "heat.ratchet"))) << "there is no cycle before";
  EXPECT_TRUE(std::isnan(value(run, "heat.springs_y")));
}

TEST_F(LineAnswers, of_a_cycle_compare_ends_under_the_same_load)
{
  const record::RunRecord run = record_of({});
  EXPECT_NEAR(value(run, "heat_2.ratchet"), 0.1, 1e-12);
  EXPECT_NEAR(value(run, "heat_2.walking"), -0.01 * MadeLineRun::slip_end / 2 / 1500, 1e-7);
  EXPECT_TRUE(std::isnan(value(run, "cool.ratchet")));
  EXPECT_NE(run.quantity("heat_2.ratchet")->meaning.find("since the end of heat, a cycle before"), std::string::npos);
  MadeLineRun held;
  held.stages = {"heat", "cool", "heat_2", "cool_2", "heat_3"}, held.y = {1.9, 1.3, 2.0, 1.4, 2.05},
  held.fed_in = {0.1, 0.04, 0.11, 0.05, 0.11};
  const record::RunRecord three = record_of(held);
  EXPECT_NEAR(value(three, "heat_3.ratchet"), 0.05, 1e-12) << "since the heating before, not the first";
  EXPECT_NEAR(value(three, "cool_2.ratchet"), 0.1, 1e-12);
}

// 1e-3 in compression by the shape and 1.17e-5 times 32 K that the wall would be longer, over 2.2322 % (by hand, see the test of the limit) by 2.5 and 1.1.
TEST_F(LineAnswers, utilisation_is_the_strain_that_makes_stress_over_its_limit)
{
  const record::RunRecord run = record_of({});
  EXPECT_NEAR(value(run, "heat.strain_compressive"), 1.3744e-3, 1e-9);
  EXPECT_NEAR(value(run, "heat.utilisation"), 1.3744e-3 * 2.5 * 1.1 / 0.022322, 1e-4);
  record::RunRecord cable = run;
  cable.settings.pipeline->wall = cable.settings.pipeline->young_modulus = {};
  cable.settings.pipeline->bending_stiffness = 1e6, cable.settings.pipeline->axial_stiffness = 1e8;
  cable.quantities = line_quantities(cable);
  EXPECT_TRUE(std::isnan(value(cable, "heat.utilisation")));
  EXPECT_FALSE(std::isnan(value(cable, "heat.strain_compressive")));
}

TEST_F(LineAnswers, without_shapes_or_with_damaged_ones_are_those_of_the_history)
{
  record::RunRecord run = record_of({});
  for (const char* damage : {"", "frame\n"}) {
    if (*damage == '\0')
      std::filesystem::remove(folder_ / "line.csv");
    else
      folder_.write("line.csv", damage);
    run.quantities = line_quantities(run);
    EXPECT_NEAR(value(run, "heat.y"), 1.9, 1e-12);
    EXPECT_TRUE(std::isnan(value(run, "heat.lobe_length")));
    EXPECT_TRUE(std::isnan(value(run, "heat.lobes")));
  }
}

// A run that was stopped has rows beyond its last frame.
TEST_F(LineAnswers, of_a_stage_that_has_not_ended_are_without_the_shape_of_an_earlier_moment)
{
  record::RunRecord run = record_of({});
  for (std::vector<Real>& column : run.history.values) column.push_back(column.back());
  run.history.stage.push_back("heat_2");
  run.history.values[0].back() += 0.05;
  run.quantities = line_quantities(run);
  EXPECT_TRUE(std::isnan(value(run, "heat_2.lobe_length")));
  EXPECT_FALSE(std::isnan(value(run, "heat.lobe_length")));
}

TEST_F(LineAnswers, have_names_that_are_known_before)
{
  MadeLineRun made;
  made.springs = true;
  const record::RunRecord run = record_of(made);
  const std::vector<std::string> names = structures::structure_of(run.settings).quantity_names(run.settings);
  for (const run_folder::Quantity& quantity : run.quantities)
    EXPECT_NE(std::ranges::find(names, quantity.name), names.end()) << quantity.name;
  EXPECT_NE(run.quantity("heat.springs_M"), nullptr);
}

TEST_F(LineAnswers, stand_in_tables_with_springs_and_hobbs_beside_in_heated_stages)
{
  MadeLineRun made;
  made.springs = true;
  const record::RunRecord run = record_of(made);
  const std::string log = log_tables(run), page = page_tables(run, "a"), beside = tables_beside(run, "b");
  for (const char* words : {"lobe, m", "utilisation", "ratchet, m", "heat_2"}) EXPECT_NE(log.find(words), std::string::npos) << log;
  EXPECT_NE(page.find("DNV-OS-F101, equation 5.30"), std::string::npos) << page;
  EXPECT_NE(beside.find("Hobbs, far_soil 0.6 W"), std::string::npos) << beside;
  EXPECT_NE(beside.find("the same on springs"), std::string::npos);
  EXPECT_NE(beside.find(">heat_2<"), std::string::npos);
  EXPECT_EQ(beside.find(">cool<"), std::string::npos) << "theory is of a line that is heated for the first time";
}

/// A run with the forces of its slices, every 8 m from x = 0 on: |H|/V is 0.3 within the buckle, which ends at x = 45 m, and 0.02 beyond.
record::RunRecord with_slices(record::RunRecord run)
{
  run_folder::History& h = run.history;
  const auto V = static_cast<std::size_t>(std::ranges::find(h.columns, "V_N_m", &run_folder::Column::name) - h.columns.begin());
  for (std::size_t row = 0; row < h.stage.size(); ++row) h.values[V - 1][row] = 0.3 * h.values[V][row];
  for (int k = 1; k <= 8; ++k)
    for (const char* symbol : {"H", "V"}) {
      h.columns.push_back(columns_named({fmt::format("slice_{}_{}_N_m", k, symbol)}).front());
      const Real sign = k % 2 == 0 ? 1 : -1, friction = 8 * k <= 45 ? 0.3 * sign : 0.02;
      h.values.emplace_back(h.stage.size(), *symbol == 'H' ? 1500 * friction : 1500);
    }
  run.quantities = line_quantities(run);
  return run;
}

TEST_F(LineAnswers, have_hobbs_beside_at_the_friction_of_the_slices_in_the_buckle)
{
  const record::RunRecord run = with_slices(record_of({}));
  EXPECT_NEAR(value(run, "heat.friction"), 0.3, 1e-12);
  const std::string beside = tables_beside(run, "b");
  EXPECT_NE(beside.find("Hobbs, H/V of the slices 0.30"), std::string::npos) << beside;
  EXPECT_NE(beside.find("Hobbs, far_soil 0.6 W"), std::string::npos) << beside;
  const Real P0 = run.history["line_P0_N"][9];
  const auto P_of = [&](Real friction) { return text::table_number(HobbsLine(run.settings, friction).at(P0).compression / 1e3); };
  EXPECT_NE(P_of(0.3), P_of(0.6));
  for (const Real friction : {0.3, 0.6}) EXPECT_NE(beside.find(">" + P_of(friction) + "<"), std::string::npos) << friction << beside;
}

TEST_F(LineAnswers, say_that_the_line_still_moves_when_its_stage_ends)
{
  record::RunRecord run = record_of({});
  const auto meaning = [&] {
    const std::vector<run_folder::Quantity> list = line_quantities(run);
    return std::ranges::find(list, "heat.y", &run_folder::Quantity::name)->meaning;
  };
  settings::StageSettings& heat = run.settings.stage[run.settings.stage.size() - 3];
  heat.until = {}, heat.until.time = 0.9, heat.ramp = 0;
  EXPECT_NE(meaning().find("still moving at the end: y at 1.5 m/s"), std::string::npos) << meaning();
  auto y = std::ranges::find(run.history.columns, "line_y_m", &run_folder::Column::name);
  for (int row = 7; row < 10; ++row) run.history.values[y - run.history.columns.begin()][row] = 1.9;
  EXPECT_EQ(meaning().find("still moving"), std::string::npos) << meaning();
}

TEST_F(LineAnswers, say_below_which_force_hobbs_has_no_buckle)
{
  MadeLineRun made;
  record::RunRecord run = record_of(made);
  for (Real& P0 : run.history.values[7]) P0 *= 0.5;  // line_P0_N
  const std::string beside = tables_beside(run, "b");
  EXPECT_NE(beside.find("Hobbs, far_soil 0.6 W: no buckle"), std::string::npos) << beside;
  EXPECT_NE(beside.find("gives no buckle of this line at constrained forces P0 up to"), std::string::npos) << beside;
}

}  // namespace
}  // namespace berm::line::this_file
