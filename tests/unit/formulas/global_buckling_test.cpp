// SPDX-License-Identifier: BSD-3-Clause
#include "formulas/global_buckling.hpp"

#include <gtest/gtest.h>

namespace berm::formulas::this_file {
namespace {

// benranderson/uhb, tests/test_analytical.py: 3873 N/m, with a tolerance of 0.1 %. By hand: EI = 3.49623 MN m2, sqrt(EI w_0/delta) = 36.7683 kN,
// (1.16 - 4.76 x 36768.3/786019) x 786019 x sqrt(0.5 x 193.34/EI) = 3874.13 N/m.
TEST(GlobalBuckling, download_on_a_prop_is_that_of_a_public_program)
{
  EXPECT_NEAR(palmer_download(786019, 207e9 * 1.689e-5, 193.34, 0.5).value, 3873, 1e-3 * 3873);
  EXPECT_NEAR(palmer_download(786019, 207e9 * 1.689e-5, 193.34, 0.5).value, 3874.13, 0.01);
  EXPECT_EQ(palmer_download(1e4, 207e9 * 1.689e-5, 193.34, 0.5).value, 0) << "too small a compression lifts nothing";
  EXPECT_FALSE(palmer_download(1e4, 207e9 * 1.689e-5, 193.34, 0).valid);
}

// 500 N/m at 1200 m: 600 kN.
TEST(GlobalBuckling, a_curve_pushes_sideways_with_its_compression_over_its_radius)
{
  EXPECT_EQ(curve_buckling_force(500, 1200).value, 6e5);
  EXPECT_FALSE(curve_buckling_force(0, 1200).valid);
}

// 1 MN is released at 400 N/m: 2500 m each side, whose compression falls from 1 MN to 0: mean strain 0.5 MN/2 GN, 0.625 m each side.
TEST(GlobalBuckling, a_buckle_takes_what_the_released_force_lengthens)
{
  EXPECT_NEAR(buckle_feed_in(1.2e6, 0.2e6, 2e9, 400).value, 2 * 2500 * 0.5 * 1e6 / 2e9, 1e-12);
  EXPECT_FALSE(buckle_feed_in(0.1e6, 0.2e6, 2e9, 400).valid);
}

// 2000 N/m, EI = 32 MN m2, T_0 = 200 kN, w = 0.1 m: 2000 x 32e6/(4e10 x 0.1) = 16, the fourth root 2: 1.4.
TEST(GlobalBuckling, lay_factor_grows_with_the_fourth_root)
{
  EXPECT_NEAR(f114_lay_factor(2000, 0.1, 32e6, 200e3).value, 1.4, 1e-12);
  EXPECT_FALSE(f114_lay_factor(2000, 0.1, 32e6, 0).valid);
}

}  // namespace
}  // namespace berm::formulas::this_file
