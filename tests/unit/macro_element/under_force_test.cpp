// SPDX-License-Identifier: BSD-3-Clause
#include "macro_element/under_force.hpp"

#include "os/error.hpp"
#include "samples/macro_element_parameters.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace berm::macro_element::this_file {
namespace {

TEST(UnderForce, a_pipe_that_was_laid_lies_where_the_laying_pushed_it_and_carries_its_weight)
{
  const Parameters p = sample_parameters();
  const berm_macro_element_state state = laid(p, 2500, 1500);
  EXPECT_NEAR(state.V, 1500, 1e-3);
  EXPECT_NEAR(state.w_p, 0.5 * std::pow(2500 / 1.2e4, 2), 1e-8) << "V0 there is that of the laying";
  EXPECT_NEAR(state.w, state.w_p + 1500 / 1e6, 1e-8);
  EXPECT_NEAR(state.H, 0, 1e-3);
  EXPECT_EQ(state.T, 0);
}

TEST(UnderForce, a_drag_keeps_its_force_and_friction_along_the_pipe_follows_it)
{
  const Parameters p = sample_parameters();
  berm_macro_element_state state = laid(p, 2500, 1500);
  for (int k = 1; k <= 50; ++k) {
    state = moved_under(p, state, 0.001 * k, 0.01 * k, 1500);
    EXPECT_NEAR(state.V, 1500, 1e-2) << "1e-7 of V and k_v D/1000";
  }
  EXPECT_EQ(state.u, 0.5);
  EXPECT_GT(state.w, 0.04);
  EXPECT_GT(state.T, 0);
}

TEST(UnderForce, refuses_a_pipe_that_is_laid_by_less_than_its_weight_or_that_the_soil_does_not_hold)
{
  Parameters p = sample_parameters();
  EXPECT_THROW(laid(p, 1000, 1500), InputError);
  EXPECT_THROW(laid(p, 1500, 0), InputError);
  p.backbone_points = 1;  // no stronger farther down
  p.backbone_w[0] = 0.1;
  p.backbone_V[0] = 2000;
  EXPECT_NO_THROW(laid(p, 1800, 1500));
  EXPECT_THROW(laid(p, 2500, 1500), InputError);
}

}  // namespace
}  // namespace berm::macro_element::this_file
