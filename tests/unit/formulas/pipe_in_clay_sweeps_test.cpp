// SPDX-License-Identifier: BSD-3-Clause
#include "formulas/pipe_in_clay.hpp"

#include <gtest/gtest.h>

namespace berm::formulas::this_file {
namespace {

PipeInClay pipe_of(Real strength, Real embedment = 0.25)
{
  return {.diameter = 0.5, .embedment = 0.5 * embedment, .strength = strength, .unit_weight = 6e3};
}

TEST(ClaySweeps, residual_resistance_falls_with_the_strength_as_tabulated)
{
  const Real table[][2] = {{0.5, 0.856}, {1, 0.744}, {2, 0.589}, {4, 0.438}};  // s_u/(gamma' D), H/V
  for (const auto& [strength, ratio] : table) {
    const Formula residual = clay_residual(pipe_of(strength * 6e3 * 0.5), 1000);
    EXPECT_NEAR(residual.value / 1000, ratio, 0.0005) << strength;
    EXPECT_TRUE(residual.valid);
  }
  PipeInClay weightless = pipe_of(2000);
  weightless.unit_weight = 0;
  EXPECT_FALSE(clay_residual(weightless, 1000).valid);
}

TEST(ClaySweeps, a_sweep_between_berms_meets_a_share_of_V_that_grows_where_the_pipe_is_deep)
{
  const Estimates shallow = safebuck_mid_sweep(pipe_of(2000, 0.5), 1000), deep = safebuck_mid_sweep(pipe_of(2000, 1), 1000);
  EXPECT_NEAR(shallow.low.value, 250, 1e-9);
  EXPECT_NEAR(shallow.high.value, 900, 1e-9);
  EXPECT_NEAR(deep.low.value, 310, 1e-9);
  EXPECT_NEAR(deep.high.value, 1350, 1e-9);
}

TEST(ClaySweeps, a_berm_is_as_strong_as_its_clay_and_as_high_as_the_pipe_is_deep)
{
  const Estimates H = safebuck_berm(pipe_of(2000, 0.4));
  EXPECT_NEAR(H.low.value, 0.9 * 0.4 * 1000, 1e-9);
  EXPECT_NEAR(H.high.value, 4.5 * 0.69314 * 1000, 0.05);  // 0.4^0.4 = 0.69314
  EXPECT_NEAR(H.best.value, (H.low.value + H.high.value) / 2, 1e-9);
  EXPECT_FALSE(safebuck_berm(pipe_of(0)).low.valid);
}

}  // namespace
}  // namespace berm::formulas::this_file
