// SPDX-License-Identifier: BSD-3-Clause
#include "structures/pipe/results/axial_results.hpp"

#include "samples/made_run_in_water.hpp"

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
  ASSERT_EQ(quantities.size(), 4u);
  EXPECT_EQ(quantities[2].name, "wedging_of_rest");
  EXPECT_EQ(quantities[3].name, "axial_friction_of_rest");
  EXPECT_EQ(quantities[3].unit, "N/m");
  EXPECT_NEAR(quantities[3].value, 550 * std::tan(70. / 3 * degree), 1e-9);
}

}  // namespace
}  // namespace berm::pipe::this_file
