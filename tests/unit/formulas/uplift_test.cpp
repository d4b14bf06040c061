// SPDX-License-Identifier: BSD-3-Clause
#include "formulas/uplift.hpp"

#include <gtest/gtest.h>
#include <string>

namespace berm::formulas::this_file {
namespace {

/// Of 0.3 m under 0.6 m of sand.
BuriedPipe sand()
{
  return {.diameter = 0.3, .cover = 0.6, .unit_weight = 9e3, .friction_angle = 33 * degree, .dilation_angle = 10 * degree, .k0 = 0.46};
}

BuriedPipe clay()
{
  return {.diameter = 0.5, .cover = 1, .unit_weight = 6e3, .strength = 5e3};
}

/// Equilibrium of the block above the pipe, in slices: its weight, and on both planes the stress at rest, with the friction that it gives.
Real by_slices(const BuriedPipe& pipe, Real psi)
{
  constexpr int slices = 100000;
  const Real H = pipe.depth(), R = pipe.diameter / 2, dz = H / slices, K0 = *pipe.k0;
  Real force = 0;
  for (int k = 0; k < slices; ++k) {
    const Real depth = (k + 0.5) * dz, above = H - depth;  // above the pipe's centre
    const Real width = 2 * (R + above * std::tan(psi)) - (above < R ? 2 * std::sqrt(R * R - above * above) : 0);
    const Real vertical = pipe.unit_weight * depth, side = K0 * vertical;
    // The plane's normal leans by psi from the horizontal: downwards, out of the block.
    const Real n[2] = {std::cos(psi), -std::sin(psi)};
    const Real normal = side * n[0] * n[0] + vertical * n[1] * n[1], length = dz / std::cos(psi);
    force += pipe.unit_weight * width * dz;
    force += 2 * length * normal * (std::tan(pipe.friction_angle) * std::cos(psi) + n[1]);
  }
  return force;
}

TEST(Uplift, of_a_block_between_slip_planes_is_its_weight_and_what_acts_on_them)
{
  const BuriedPipe pipe = sand();
  EXPECT_NEAR(uplift_inclined_slip(pipe).value, by_slices(pipe, 10 * degree), 1e-5 * by_slices(pipe, 10 * degree));
  EXPECT_NEAR(uplift_vertical_slip(pipe).value, by_slices(pipe, 0), 1e-5 * by_slices(pipe, 0));
  BuriedPipe still = pipe;
  still.dilation_angle = 0;
  EXPECT_NEAR(uplift_inclined_slip(still).value, uplift_vertical_slip(pipe).value, 1e-9);
  EXPECT_GT(uplift_inclined_slip(pipe).value, uplift_vertical_slip(pipe).value);
}

// By hand: gamma' (H D - pi D^2/8) = 9 (0.225 - 0.035343) = 1.706914 kN/m, gamma' H^2 = 5.0625 kN/m, K_0 tan phi = 0.46 x 0.6494076.
TEST(Uplift, of_vertical_planes_is_that_of_a_calculation_by_hand)
{
  EXPECT_NEAR(uplift_vertical_slip(sand()).value, 1706.914 + 5062.5 * 0.46 * 0.6494076, 0.01);
  BuriedPipe at_rest = sand();
  at_rest.k0.reset();
  EXPECT_NEAR(uplift_vertical_slip(at_rest).value, 1706.914 + 5062.5 * (1 - std::sin(33 * degree)) * 0.6494076, 0.01);
}

// Numbers of the unit tests of the program U of docs/formulas.md: 5 digits.
TEST(Uplift, of_the_lifelines_alliance_is_that_of_a_public_program)
{
  const BuriedPipe one{.diameter = 0.508, .cover = 4.725, .unit_weight = 8e3, .friction_angle = 35 * degree};
  const BuriedPipe other{.diameter = 0.1731, .cover = 1, .unit_weight = 18e3, .friction_angle = 32 * degree};
  EXPECT_NEAR(ala_uplift_sand(one).value, 157757, 1);
  EXPECT_NEAR(ala_uplift_sand(other).value, 15455, 1);
  EXPECT_NEAR(ala_uplift_displacement(one).low.value, 0.04979, 1e-8);
  EXPECT_NEAR(ala_uplift_displacement(other).low.value, 0.01087, 1e-5);
  EXPECT_NEAR(ala_uplift_displacement(one).high.value, 0.0508, 1e-12) << "0.1 D at most";
  BuriedPipe deep = one;
  deep.cover = 60;
  EXPECT_NEAR(ala_uplift_sand(deep).value, 33.296 * 8e3 * deep.depth() * 0.508, 1e-4 * 33.296 * 8e3 * deep.depth() * 0.508);
}

TEST(Uplift, of_clay_grows_with_the_cover_until_soil_flows_around_the_pipe)
{
  EXPECT_NEAR(ala_uplift_clay(clay()).value, 5 * 5e3 * 0.5, 1e-9);  // 2 H/D = 5
  EXPECT_NEAR(otc_uplift_clay(clay()).value, 6e3 * 1.25 * 0.5 + 2 * 1.25 * 5e3, 1e-9);
  BuriedPipe deep = clay();
  deep.cover = 20;
  EXPECT_NEAR(ala_uplift_clay(deep).value, 10 * 5e3 * 0.5, 1e-9);
  EXPECT_NEAR(ala_uplift_displacement(clay()).low.value, 0.1, 1e-12);  // 0.2 D is less than 0.1 H
}

// By hand: D = 0.5 m, cover 1 m, 9 kN/m3: gamma' C D = 4500, gamma' D^2 (1/2 - pi/8) = 241.427, gamma' H^2 = 14062.5 N/m.
TEST(Uplift, of_the_codes_is_that_of_a_calculation_by_hand)
{
  const BuriedPipe pipe{.diameter = 0.5, .cover = 1, .unit_weight = 9e3, .friction_angle = 30 * degree, .k0 = 0.5};
  EXPECT_NEAR(f114_uplift(pipe, Packing::loose).value, 4741.427 + 0.29 * 14062.5, 1e-3);
  EXPECT_NEAR(f114_uplift(pipe, Packing::medium).value, 4741.427 + 0.47 * 14062.5, 1e-3);
  EXPECT_NEAR(f114_uplift(pipe, Packing::dense).value, 4741.427 + 0.62 * 14062.5, 1e-3);
  EXPECT_NEAR(f110_uplift(pipe).value, 5625 * (1 + 0.5 * std::tan(30 * degree) * 2.5), 1e-6);
  // The two agree but for the weight that the upper half of the pipe takes the place of.
  EXPECT_NEAR(f110_uplift(pipe).value - uplift_vertical_slip(pipe).value, 9e3 * pi * 0.25 / 8, 1e-6);
}

TEST(Uplift, gives_all_that_apply_to_a_soil_and_nothing_of_another)
{
  const auto names = [](const BuriedPipe& pipe) {
    std::string all;
    for (const UpliftModel& model : uplift_models(pipe)) {
      EXPECT_TRUE(model.resistance.valid) << model.name;
      EXPECT_GT(model.resistance.value, 0) << model.name;
      EXPECT_NE(model.resistance.source.label, Label::recalled) << model.name;
      all += std::string(model.name) + ";";
    }
    return all;
  };
  EXPECT_EQ(uplift_models(sand()).size(), 7u) << names(sand());
  EXPECT_EQ(uplift_models(clay()).size(), 3u) << names(clay());
  BuriedPipe nothing = clay();
  nothing.strength = 0;
  EXPECT_TRUE(uplift_models(nothing).empty());
}

TEST(Uplift, scales_with_weight_and_the_square_of_length)
{
  BuriedPipe large = sand();
  large.diameter *= 4, large.cover *= 4, large.unit_weight *= 3;
  const std::vector<UpliftModel> small = uplift_models(sand()), scaled = uplift_models(large);
  for (std::size_t k = 0; k < small.size(); ++k)
    EXPECT_NEAR(scaled[k].resistance.value, 48 * small[k].resistance.value, 1e-9 * scaled[k].resistance.value) << small[k].name;
}

TEST(Uplift, is_out_of_range_without_cover_or_where_sand_dilates_more_than_it_rubs)
{
  BuriedPipe bare = sand();
  bare.cover = 0;
  for (const UpliftModel& model : uplift_models(bare)) EXPECT_FALSE(model.resistance.valid) << model.name;
  BuriedPipe loose = sand();
  loose.dilation_angle = 40 * degree;
  EXPECT_FALSE(uplift_inclined_slip(loose).valid);
  EXPECT_FALSE(ala_uplift_clay(sand()).valid);
  EXPECT_FALSE(ala_uplift_sand(clay()).valid);
}

// By hand: D = 0.3 m, cover 2 D, 9 kN/m3: H = 0.75 m, weight 9 (0.75 x 0.3 - pi 0.09/8) = 1.7069 kN/m, gamma' H^2 = 5.0625 kN/m. f = K_0 tan phi = 0.4 and 0.6, of phi = 45 degrees.
TEST(Uplift, of_a_buried_pipe_by_vertical_planes_is_that_of_a_hand_check)
{
  BuriedPipe pipe{.diameter = 0.3, .cover = 0.6, .unit_weight = 9e3, .friction_angle = 45 * degree, .k0 = 0.4};
  EXPECT_NEAR(uplift_vertical_slip(pipe).value, 3731.91, 0.01);
  pipe.k0 = 0.6;
  EXPECT_NEAR(uplift_vertical_slip(pipe).value, 4744.41, 0.01);
}

}  // namespace
}  // namespace berm::formulas::this_file
