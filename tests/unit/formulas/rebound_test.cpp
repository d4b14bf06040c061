// SPDX-License-Identifier: BSD-3-Clause
#include "formulas/rebound.hpp"

#include <gtest/gtest.h>

namespace berm::formulas::this_file {
namespace {

TEST(Rebound, is_that_of_the_guideline)
{
  // By hand: G = 215 kPa, nu = 0.45: 0.88 x 215/0.55 = 344 kPa.
  EXPECT_NEAR(pipe_rebound_stiffness(215e3, 0.45).value, 344e3, 1);
  EXPECT_TRUE(pipe_rebound_stiffness(215e3, 0.45).valid);
  EXPECT_FALSE(pipe_rebound_stiffness(0, 0.45).valid);
  EXPECT_FALSE(pipe_rebound_stiffness(215e3, 0.6).valid);
}

}  // namespace
}  // namespace berm::formulas::this_file
