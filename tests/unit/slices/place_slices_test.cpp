// SPDX-License-Identifier: BSD-3-Clause
#include "slices/place_slices.hpp"

#include "samples/error_of.hpp"
#include "samples/pipeline_case.hpp"

#include "os/error.hpp"

#include <gtest/gtest.h>

namespace berm::slices::this_file {
namespace {

/// A pipe of steel, 0.4 m x 15 mm, that buckles under 32 K in 10 s, on 17 slices to 72 m.
settings::Case buckling()
{
  settings::Case c = test::line_case();
  settings::PipelineSettings& p = *c.pipeline;
  p.bending_stiffness.reset(), p.axial_stiffness.reset();
  p.wall = 0.015, p.young_modulus = 206e9, p.expansion = 1.17e-5;
  p.length = 1500;
  p.end = settings::LineEnd::anchored;
  p.imperfection = {0.4, 60};
  p.far_soil = {};
  p.slices = {};
  p.slices.count = 17, p.slices.to = 72;
  settings::StageSettings& heat = c.stage.back();
  heat.pipeline = {};
  heat.pipeline.temperature = 32;
  heat.ramp = 10, heat.until.time = 11;
  return c;
}

std::vector<Real> placed(settings::Case c)
{
  place_slices(c);
  EXPECT_EQ(c.pipeline->slices.count, 0);
  EXPECT_FALSE(c.pipeline->slices.to);
  return c.pipeline->slices.at;
}

/// The distance of the two places around x.
Real gap_at(const std::vector<Real>& places, Real x)
{
  const auto after = std::upper_bound(places.begin(), places.end(), x);
  return *after - *(after - 1);
}

TEST(PlaceSlices, gives_as_many_as_are_asked_for_half_of_them_evenly_and_the_same_again)
{
  const std::vector<Real> places = placed(buckling());
  ASSERT_EQ(places.size(), 17U);
  EXPECT_EQ(places.front(), 0);
  EXPECT_EQ(places.back(), 72);
  for (std::size_t k = 1; k < places.size(); ++k) {
    EXPECT_GT(places[k], places[k - 1]);
    EXPECT_LE(places[k] - places[k - 1], 2 * 4.5 + 2e-3) << "twice the even 4.5 m at most";
  }
  EXPECT_EQ(places, placed(buckling()));
}

// The lobe beside the crown begins 18 to 24 m from it while the line is heated; around the crown all slices slide the same way.
TEST(PlaceSlices, puts_them_nearer_where_the_line_turns)
{
  const std::vector<Real> places = placed(buckling());
  EXPECT_LT(gap_at(places, 21), 4.5 * 0.75);
  EXPECT_GT(gap_at(places, 1), 4.5 * 1.2);
  EXPECT_GT(gap_at(places, 65), 4.5 * 1.1);
}

TEST(PlaceSlices, finds_how_far_the_line_slides_sideways_where_the_case_does_not_say)
{
  settings::Case c = buckling();
  c.pipeline->slices.to.reset();
  const std::vector<Real> places = placed(c);
  EXPECT_GT(places.back(), 60) << "the lobe beside that of the crown";
  EXPECT_LT(places.back(), 150);
}

TEST(PlaceSlices, leaves_places_that_a_case_has)
{
  settings::Case c = buckling();
  c.pipeline->slices = {};
  c.pipeline->slices.at = {0, 1, 5, 9};
  place_slices(c);
  EXPECT_EQ(c.pipeline->slices.at, (std::vector<Real>{0, 1, 5, 9}));
}

TEST(PlaceSlices, is_refused_where_springs_cannot_tell)
{
  const auto error_of = [](const settings::Case& c) {
    settings::Case tried = c;
    return test::error_of<KeyError>([&] { place_slices(tried); });
  };
  settings::Case smooth = buckling(), cold = buckling();
  smooth.pipeline->far_soil.friction = 0;
  EXPECT_TRUE(error_of(smooth).starts_with("pipeline.slices.count: the springs of pipeline.far_soil")) << error_of(smooth);
  cold.stage.back().pipeline.temperature = 0.01;
  cold.pipeline->slices.to.reset();
  EXPECT_NE(error_of(cold).find("give pipeline.slices.to"), std::string::npos) << error_of(cold);
}

}  // namespace
}  // namespace berm::slices::this_file
