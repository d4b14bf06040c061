// SPDX-License-Identifier: BSD-3-Clause
#include "structures/pipe/published.hpp"

#include "formulas/pipe_in_sand.hpp"
#include "samples/clay_pipe.hpp"

#include <gtest/gtest.h>

namespace berm::pipe::this_file {
namespace {

const base::EnvelopeEnds no_probes{{}, {}, std::numeric_limits<Real>::quiet_NaN()};

TEST(PipeEnvelope, is_the_fit_for_clay_of_the_roughness_that_the_adhesion_makes)
{
  // D s_u = 10 kN/m; rough: 7.40 (w/D)^0.40 and 3.26 (w/D)^0.82.
  const base::PublishedEnvelope published = pipe_envelope(clay({"contact.skin.adhesion=10e3"}), no_probes);
  EXPECT_EQ(published.unit, 10e3);
  ASSERT_EQ(published.numbers.size(), 2u);
  EXPECT_NEAR(published.numbers[0].formula.value, 10e3 * 7.40 * std::pow(0.4, 0.40), 1e-6);
  EXPECT_NEAR(published.numbers[1].formula.value, 10e3 * 3.26 * std::pow(0.4, 0.82), 1e-6);
  EXPECT_TRUE(published.numbers[0].formula.valid);
  EXPECT_EQ(published.curves.size(), 1u);
}

TEST(PipeEnvelope, says_where_the_pipe_is_out_of_range)
{
  const base::PublishedEnvelope published = pipe_envelope(clay({"rigid.pipe.center=[0, -0.2]"}), no_probes);
  EXPECT_NE(published.curves.at(0).title.find("out of range"), std::string::npos);
}

TEST(PipeEnvelope, is_out_of_range_on_ground_that_is_not_level)
{
  const base::PublishedEnvelope published = pipe_envelope(clay({"contact.skin.adhesion=10e3", "mesh.slope=\"3 deg\""}), no_probes);
  ASSERT_EQ(published.numbers.size(), 2u);
  for (const auto& number : published.numbers) {
    EXPECT_FALSE(number.formula.valid);
    EXPECT_EQ(number.formula.source.range, "a level bed");
  }
  ASSERT_EQ(published.curves.size(), 1u);
  EXPECT_NE(published.curves[0].title.find("out of range: a level bed"), std::string::npos) << published.curves[0].title;
  EXPECT_NE(published.remark.find("level bed"), std::string::npos);
}

TEST(PipeEnvelope, lifts_the_clay_curve_by_the_buoyancy_of_what_the_pipe_displaces)
{
  // Half the circle lies in the clay: 18 kN/m3 x pi/8 m2.
  const base::PublishedEnvelope published = pipe_envelope(clay({"gravity=[0, -10]", "rigid.pipe.center=[0, 0]"}), no_probes);
  const base::PublishedCurve& curve = published.curves.at(0);
  EXPECT_NEAR(curve.V.front(), 18e3 * pi / 8, 1e-6);
  EXPECT_NEAR(curve.V.back(), 18e3 * pi / 8 + 10e3 * 5.66 * std::pow(0.5, 0.32), 1e-6);
  for (const auto& each : published.curves) EXPECT_EQ(each.title.find("recalled"), std::string::npos) << each.title;
}

TEST(PipeEnvelope, has_no_curve_for_friction_on_clay)
{
  const base::PublishedEnvelope published = pipe_envelope(clay({"contact.skin.friction_angle=\"20 deg\""}), no_probes);
  EXPECT_TRUE(published.curves.empty());
  EXPECT_NE(published.remark.find("not friction"), std::string::npos);
}

TEST(PipeEnvelope, is_a_parabola_through_the_probes_in_sand)
{
  const settings::Case sand = clay({"gravity=[0, -10]", "material.clay.cohesion=0", "material.clay.friction_angle=\"30 deg\""});
  const formulas::YieldSurface surface{0.4, 0.2};
  base::EnvelopeEnds ends{{1e3}, {0}, 1e3};
  for (const Real V : {200., 400., 700.}) {
    ends.V.push_back(V);
    ends.H.push_back(zhang_envelope(surface, V, 1e3).value);
  }
  const base::PublishedEnvelope published = pipe_envelope(sand, ends);
  EXPECT_EQ(published.unit, 18e3);
  ASSERT_EQ(published.numbers.size(), 2u) << "Vmax is tabulated for 35 degrees only";
  EXPECT_NEAR(published.numbers[0].formula.value, 0.4, 1e-9);
  EXPECT_NEAR(published.numbers[1].formula.value, 0.2, 1e-9);
  EXPECT_EQ(published.numbers[0].formula.source.label, formulas::Label::fit) << "a fit to the run itself: nothing is quoted";
}

}  // namespace
}  // namespace berm::pipe::this_file
