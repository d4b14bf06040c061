// SPDX-License-Identifier: BSD-3-Clause
#include "slices/line_of_case.hpp"

#include "samples/pipeline_case.hpp"

#include <gtest/gtest.h>

namespace berm::slices::this_file {
namespace {

/// The line of a pipe of steel, 0.4 m x 15 mm, in its last stage at 30 K and 10 MPa.
problem::Case heated()
{
  problem::Case c = test::line_case();
  problem::PipelineSettings& p = *c.pipeline;
  p.bending_stiffness.reset(), p.axial_stiffness.reset();
  p.wall = 0.015;
  p.young_modulus = 206e9;
  p.expansion = 1.17e-5;
  p.length = 1000;
  p.slices = {8, 64};
  p.imperfection = {0.4, 60};
  p.far_soil = {};
  c.stage.back().pipeline = {30, 10e6, {}, {}};
  return c;
}

TEST(LineOfCase, has_the_stiffness_and_the_compression_of_its_wall)
{
  const LineOfCase of(heated());
  const Real outer = 0.4, inner = 0.37, area = pi / 4 * (outer * outer - inner * inner);
  const beam::Section& section = of.line.section.front();
  EXPECT_NEAR(section.axial_stiffness, 206e9 * area, 1e-9 * section.axial_stiffness);
  EXPECT_NEAR(section.bending_stiffness, 206e9 * pi / 64 * (std::pow(outer, 4) - std::pow(inner, 4)), 1e-9 * section.bending_stiffness);
  EXPECT_EQ(section.mass, 330);
  LineLoads hot = of.laid();
  hot.temperature = 30, hot.pressure = 10e6;
  EXPECT_NEAR(of.constrained_force(hot), 206e9 * area * 1.17e-5 * 30 + 0.4 * 10e6 * pi / 4 * inner * inner, 1) << "1 - 2 nu = 0.4";
  EXPECT_EQ(of.constrained_force(of.laid()), 0);
}

TEST(LineOfCase, has_a_node_at_each_slice_and_elements_that_resolve_the_buckle)
{
  const LineOfCase of(heated());
  ASSERT_EQ(of.places.size(), 9U);
  for (const Real place : of.places)
    EXPECT_TRUE(std::find_if(of.line.x.begin(), of.line.x.end(), [&](Real x) { return std::abs(x - place) < 1e-9; }) != of.line.x.end())
        << place;
  const Real P = of.constrained_force({30, 10e6, 1500, 0}), longest = pi * std::sqrt(of.line.section.front().bending_stiffness / P) / 4;
  for (Index e = 0; e < of.line.elements(); ++e) EXPECT_LE(of.line.length(e), longest * (1 + 1e-9)) << e;
  EXPECT_GE(of.line.x.back(), 1000);
}

TEST(LineOfCase, has_its_imperfection_with_its_amplitude_and_its_slope)
{
  for (const problem::LineHalf half : {problem::LineHalf::symmetric, problem::LineHalf::antisymmetric}) {
    problem::Case c = heated();
    c.pipeline->half = half;
    const LineOfCase of(c);
    Real largest = 0;
    for (Index i = 0; i < of.line.nodes(); ++i) largest = std::max(largest, of.line.shape[of.line.across(beam::Plane::lateral, i)]);
    EXPECT_NEAR(largest, 0.4, 0.02) << "a node lies within 2 m of it";
    for (Index i = 1; i + 1 < of.line.nodes(); ++i) {
      const Index at = of.line.across(beam::Plane::lateral, i), before = of.line.across(beam::Plane::lateral, i - 1),
                  after = of.line.across(beam::Plane::lateral, i + 1);
      const Real slope = (of.line.shape[after] - of.line.shape[before]) / (of.line.x[i + 1] - of.line.x[i - 1]);
      EXPECT_NEAR(of.line.shape[at + 1], slope, 0.01) << "central differences over 8 m, x = " << of.line.x[i];
    }
  }
}

TEST(LineOfCase, carries_its_weight_on_slices_and_springs)
{
  const LineOfCase of(heated());
  Real on_slices = 0, on_springs = 0;
  for (const Real length : of.stations.lengths()) on_slices += length;
  for (const Real length : of.length_on_springs) on_springs += length;
  EXPECT_NEAR(on_slices, 64, 1e-9);
  EXPECT_NEAR(on_slices + on_springs, of.line.x.back(), 1e-9);
}

TEST(LineOfCase, goes_from_load_to_load_and_keeps_what_a_stage_does_not_name)
{
  const LineLoads laid{0, 0, 1500, 0}, hot = target_of({30, {}, {}, {}}, laid), empty = target_of({{}, {}, 900, {}}, hot);
  EXPECT_EQ(hot.temperature, 30);
  EXPECT_EQ(hot.weight, 1500);
  EXPECT_EQ(empty.temperature, 30);
  EXPECT_EQ(empty.weight, 900);
  EXPECT_EQ(between(hot, empty, 0.25).weight, 1350);
  EXPECT_EQ(between(hot, empty, 1).weight, 900);
}

}  // namespace
}  // namespace berm::slices::this_file
