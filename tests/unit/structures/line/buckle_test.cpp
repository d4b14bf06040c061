// SPDX-License-Identifier: BSD-3-Clause
#include "structures/line/buckle.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace berm::line::this_file {
namespace {

settings::PipelineSettings half_of(settings::LineHalf half)
{
  settings::PipelineSettings p;
  p.half = half;
  p.far_soil.axial_friction = 0.5;
  p.far_soil.axial_mobilisation = 2e-3;
  return p;
}

/// A line of 100 m with nodes every 0.5 m.
template <class Y, class U>
Shape shape_of(const Y& y, const U& u)
{
  Shape shape{.time = 0, .stage = "heat", .x{}, .y{}, .z{}, .u{}, .P{}, .M{}, .strain_max{}, .strain_min{}};
  for (int i = 0; i <= 200; ++i) {
    const Real x = 0.5 * i;
    shape.x.push_back(x), shape.y.push_back(y(x)), shape.u.push_back(u(x));
    for (std::vector<Real>* zeros : {&shape.z, &shape.P, &shape.M}) zeros->push_back(0);
    shape.strain_max.push_back(x < 10 ? 2e-3 : 1e-3), shape.strain_min.push_back(x < 10 ? -1e-3 : -5e-4);
  }
  return shape;
}

Real at_rest(Real)
{
  return 0;
}

/// A lobe to 20 m, one to 45 m, and tiny ones beyond.
Real three_lobes(Real x)
{
  if (x < 20) return std::cos(pi * x / 40);
  return x < 45 ? -0.3 * std::sin(pi * (x - 20) / 25) : 1e-3 * std::sin(pi * (x - 45) / 20);
}

TEST(Buckle, that_is_its_mirror_image_has_a_lobe_of_twice_the_way_to_its_crossing)
{
  const Buckle buckle = buckle_of(shape_of(three_lobes, at_rest), half_of(settings::LineHalf::symmetric));
  EXPECT_NEAR(buckle.lobe_length, 40, 0.05);
  EXPECT_EQ(buckle.lobes, 3) << "the crown once, its neighbours on both sides";
  EXPECT_NEAR(buckle.bending, 1.5e-3, 1e-12);
}

TEST(Buckle, that_is_turned_has_lobes_on_both_sides)
{
  const auto two = [](Real x) { return x < 30 ? std::sin(pi * x / 30) : x < 50 ? -0.2 * std::sin(pi * (x - 30) / 20) : 0; };
  const Buckle buckle = buckle_of(shape_of(two, at_rest), half_of(settings::LineHalf::antisymmetric));
  EXPECT_NEAR(buckle.lobe_length, 30, 0.05);
  EXPECT_EQ(buckle.lobes, 4);
}

TEST(Buckle, slips_as_far_as_its_friction_is_mobilised)
{
  const auto fed = [](Real x) { return x < 80 ? -0.1 * (1 - x / 80) : 0; };
  const Shape shape = shape_of(three_lobes, fed);
  EXPECT_NEAR(buckle_of(shape, half_of(settings::LineHalf::symmetric)).slip_length, 80 * (1 - 2e-3 / 0.1), 1e-9);
  EXPECT_EQ(buckle_of(shape_of(three_lobes, at_rest), half_of(settings::LineHalf::symmetric)).slip_length, 0);
  EXPECT_EQ(buckle_of(shape_of(three_lobes, [](Real) { return 0.01; }), half_of(settings::LineHalf::symmetric)).slip_length, 100)
      << "all of it";
  settings::PipelineSettings smooth = half_of(settings::LineHalf::symmetric);
  smooth.far_soil.axial_friction = 0;
  EXPECT_TRUE(std::isnan(buckle_of(shape, smooth).slip_length));
  EXPECT_NEAR(mean_axial(shape), -0.1 * 40 / 100, 1e-9);
}

TEST(Buckle, of_a_straight_line_has_no_lobe)
{
  const Buckle none_of_it = buckle_of(shape_of(at_rest, at_rest), half_of(settings::LineHalf::symmetric));
  EXPECT_EQ(none_of_it.lobes, 0);
  EXPECT_TRUE(std::isnan(none_of_it.lobe_length));
}

}  // namespace
}  // namespace berm::line::this_file
