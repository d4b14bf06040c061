// SPDX-License-Identifier: BSD-3-Clause
#include "formulas/hobbs.hpp"

#include "samples/similar_shapes.hpp"

#include <gtest/gtest.h>

namespace berm::formulas::this_file {
namespace {

const HotLine pipe_on_sand{69.4e6, 3.74e9, 900, 750};  // 16 inch, 0.6 W sideways and 0.5 W along

// y P^2/(h EI) and M P/(h EI) from the equation of the shape with friction against the displacement, by finite differences; the constants have four digits, of lobes that end where no lobe follows.
TEST(Hobbs, modes_three_and_four_have_the_amplitude_and_moment_of_the_equation_of_their_shape)
{
  constexpr Real P = 5e5;
  const Real unit = pipe_on_sand.lateral * pipe_on_sand.bending_stiffness / P;
  for (const auto& [mode, kind] :
       {std::pair{HobbsMode::three, test::SimilarKind::symmetric}, {HobbsMode::four, test::SimilarKind::antisymmetric}}) {
    const HobbsBuckle buckle = hobbs_buckle(mode, pipe_on_sand, P);
    const test::SimilarShape shape = test::SimilarShapes(kind, 0).shape();
    EXPECT_NEAR(buckle.amplitude / (unit / P), shape.ordinate, 0.01 * shape.ordinate);
    EXPECT_NEAR(buckle.moment / unit, shape.curvature, 0.01 * shape.curvature);
  }
}

// One lobe between walls, EI v'' + P v = h (x^2 - a^2)/2 + c with v = v' = v'' = 0 at its ends a = L/2: tan ka = ka, so that k a = 4.4934 and P = 4 * 4.4934^2 EI/L^2.
TEST(Hobbs, mode_one_has_the_force_of_a_lobe_with_straight_ends)
{
  const HobbsBuckle one = hobbs_buckle(HobbsMode::one, pipe_on_sand, 1e6);
  constexpr Real ka = 4.493409;
  EXPECT_NEAR(one.lobe, 2 * ka * std::sqrt(pipe_on_sand.bending_stiffness / 1e6), 1e-3 * one.lobe);
}

// What the buckle takes is what its feed-in gives: half of the shortening by its slopes, h^2 L^7/EI^2 times a constant, against the strain (P_0 - P)/EA within it and half of that within the slip.
TEST(Hobbs, feed_in_of_the_slip_is_the_shortening_of_the_buckle_for_any_axial_friction)
{
  Real constant = 0;
  for (const Real axial : {300., 750., 1500.}) {
    HotLine line = pipe_on_sand;
    line.axial = axial;
    const HobbsBuckle b = hobbs_buckle(HobbsMode::three, line, 4e5);
    const Real missing = b.constrained_force - b.compression, slip = b.slip_length - b.half_length;
    EXPECT_NEAR(missing, axial * slip, 1e-9 * missing);
    const Real shortening = missing / line.axial_stiffness * (b.half_length + slip / 2);
    const Real now = shortening * std::pow(line.bending_stiffness / line.lateral, 2) / std::pow(b.lobe, 7);
    if (constant == 0) constant = now;
    EXPECT_NEAR(now, constant, 1e-9 * constant);
  }
}

TEST(Hobbs, at_a_constrained_force_the_longer_buckle_is_found_and_none_below_the_smallest)
{
  for (const HobbsMode mode : {HobbsMode::one, HobbsMode::two, HobbsMode::three, HobbsMode::four}) {
    const HobbsBuckle hot = hobbs_buckle_at(mode, pipe_on_sand, 1.4e6), hotter = hobbs_buckle_at(mode, pipe_on_sand, 1.5e6);
    EXPECT_NEAR(hot.constrained_force, 1.4e6, 1);
    EXPECT_GT(hotter.amplitude, hot.amplitude);
    EXPECT_LT(hotter.compression, hot.compression) << "it feeds in more, and carries less";
    EXPECT_TRUE(std::isnan(hobbs_buckle_at(mode, pipe_on_sand, 2e5).amplitude));
    const Real smallest = hobbs_smallest_force(mode, pipe_on_sand);
    EXPECT_TRUE(std::isnan(hobbs_buckle_at(mode, pipe_on_sand, (1 - 1e-6) * smallest).amplitude));
    EXPECT_FALSE(std::isnan(hobbs_buckle_at(mode, pipe_on_sand, (1 + 1e-6) * smallest).amplitude));
  }
}

TEST(Hobbs, without_friction_or_compression_there_is_no_buckle)
{
  HotLine line = pipe_on_sand;
  line.axial = 0;
  EXPECT_TRUE(std::isnan(hobbs_buckle_at(HobbsMode::three, line, 1.4e6).amplitude));
  EXPECT_TRUE(std::isnan(hobbs_buckle_at(HobbsMode::three, pipe_on_sand, -1e5).amplitude));
}

// By hand, 323.9 mm x 12.7 mm of steel (206 GPa, 1.17e-5/K) that weighs 0.8 kN/m, 24 K, friction 0.6: EI = 31.015 MN m2, EA = 2557.76 MN, P_0 = 718.2 kN, and the longer root of P_0(L) is 58.861 m.
TEST(Hobbs, mode_three_of_a_12_inch_line_at_24_K_is_that_of_a_hand_check)
{
  constexpr Real D = 0.3239, d = D - 2 * 0.0127, E = 206e9, friction = 0.6 * 800;
  const Real EA = E * pi / 4 * (D * D - d * d);
  const HotLine line{E * pi / 64 * (std::pow(D, 4) - std::pow(d, 4)), EA, friction, friction};
  const HobbsBuckle buckle = hobbs_buckle_at(HobbsMode::three, line, EA * 1.17e-5 * 24);
  EXPECT_NEAR(buckle.constrained_force, 718220.0, 0.5);
  EXPECT_NEAR(buckle.lobe, 58.8614, 1e-4);
  EXPECT_NEAR(buckle.compression, 304.899e3, 1);
  EXPECT_NEAR(buckle.amplitude, 1.91721, 1e-5);
  EXPECT_NEAR(buckle.moment, 238.480e3, 1);
}

}  // namespace
}  // namespace berm::formulas::this_file
