// SPDX-License-Identifier: BSD-3-Clause
#include "structures/pipe/axial_results.hpp"

#include "samples/made_run_in_water.hpp"
#include "structures/structures.hpp"

#include <gtest/gtest.h>

namespace berm::pipe::this_file {
namespace {

TEST(AxialResults, are_the_effective_normal_force_over_V_and_times_the_friction_coefficient)
{
  EXPECT_TRUE(axial_states(MadeRunInWater{}.record()).empty());
  const record::RunRecord run = MadeRunInWater{}.record_with_normal_force();
  const std::vector<AxialState> states = axial_states(run);
  ASSERT_EQ(states.size(), 2u);
  EXPECT_EQ(states[1].stage, "rest");
  EXPECT_DOUBLE_EQ(states[1].w, 0.002);
  EXPECT_DOUBLE_EQ(states[1].wedging(), 1.1);
  const std::vector<run_folder::Quantity> quantities = axial_quantities(run);
  ASSERT_EQ(quantities.size(), 5u);
  EXPECT_EQ(quantities[2].name, "wedging_of_rest");
  EXPECT_EQ(quantities[3].name, "axial_friction_of_rest");
  EXPECT_EQ(quantities[3].unit, "N/m");
  EXPECT_NEAR(quantities[3].value, 550 * std::tan(70. / 3 * degree), 1e-9);
}

TEST(AxialResults, of_a_rest_that_consolidates_have_their_gain_beside_U)
{
  const record::RunRecord run = MadeRunInWater{}.record_with_normal_force();
  const std::vector<AxialGain> gains = axial_gains(run);
  ASSERT_EQ(gains.size(), 1u);
  EXPECT_EQ(gains[0].stage, "rest");
  EXPECT_DOUBLE_EQ(gains[0].degree, 0.75);
  EXPECT_DOUBLE_EQ(gains[0].ratio(), 5.5) << "550 N/m of normal force after 100 N/m";
  EXPECT_EQ(axial_quantities(run).back().name, "axial_gain_of_rest");
  EXPECT_DOUBLE_EQ(axial_quantities(run).back().value, 5.5);
  const base::DisplayUnits shown({{base::body_scale(run), &run.quantities}});
  const std::string words = structures::structure_of(run.settings).in_words(run, shown);
  EXPECT_TRUE(
      words.starts_with("In \"rest\" 75 % of the excess pore pressure dissipates (U), and the axial friction resistance grows from "))
      << words;
  EXPECT_NE(words.find(", 5.5 times. Pushed to"), std::string::npos) << words;
  EXPECT_TRUE(axial_gains(MadeRunInWater{}.record()).empty()) << "no normal force";
}

}  // namespace
}  // namespace berm::pipe::this_file
