// SPDX-License-Identifier: BSD-3-Clause
// What stands beside the uplift of a buried pipe.
#include "structures/pipe/published_of_soil.hpp"

#include "formulas/uplift.hpp"
#include "samples/made_run.hpp"

#include <gtest/gtest.h>

namespace berm::pipe::this_file {
namespace {

PipeSoil sand()
{
  return SandAround{
      .diameter = 0.3, .unit_weight = 9e3, .friction_angle = 33 * degree, .dilation_angle = 0, .interface_angle = 22 * degree};
}

TEST(published_uplift, takes_the_cover_from_the_invert)
{
  const std::vector<Comparison> list = in_uplift(sand(), 0.9, 4000, 0.01);
  const auto vertical =
      std::find_if(list.begin(), list.end(), [](const Comparison& c) { return c.about.find("vertical slip") != std::string::npos; });
  ASSERT_NE(vertical, list.end());
  EXPECT_EQ(vertical->berm, 4000);
  // gamma' (H D - pi D^2/8) + K0 tan phi gamma' H^2 with H = 0.75 m to the centre.
  const Real f = (1 - std::sin(33 * degree)) * std::tan(33 * degree), H = 0.75, D = 0.3;
  EXPECT_NEAR(vertical->published.value, 9e3 * (H * D - pi * D * D / 8) + f * 9e3 * H * H, 1e-6);
  EXPECT_EQ(list.back().quantity, "u at R");
}

TEST(published_uplift, is_not_told_of_a_pipe_that_is_not_buried)
{
  EXPECT_TRUE(in_uplift(sand(), 0.29, 4000, 0.01).empty());
  EXPECT_TRUE(in_uplift(NoFormula{""}, 0.9, 4000, 0.01).empty());
}

}  // namespace
}  // namespace berm::pipe::this_file
