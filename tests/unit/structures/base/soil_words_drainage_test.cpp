// SPDX-License-Identifier: BSD-3-Clause
#include "structures/base/soil_words.hpp"

#include "samples/made_run_in_water.hpp"

#include <gtest/gtest.h>

namespace berm::base::this_file {
namespace {

TEST(DrainageWords, tell_the_velocity_of_each_stage_over_that_of_the_water)
{
  EXPECT_STREQ(drainage_word(0.01), "drained");
  EXPECT_STREQ(drainage_word(0.02), "partially drained");
  EXPECT_STREQ(drainage_word(30), "undrained");
  EXPECT_TRUE(drainage_words(MadeRun{}.settings()).empty());
  // v D / c_v = 0.1 m/s * 0.02 m / 4e-4 m2/s.
  const std::vector<std::string> lines = drainage_words(MadeRunInWater{}.record().settings);
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_NE(lines[0].find("c_v = 0.0004 m2/s"), std::string::npos) << lines[0];
  EXPECT_NE(lines[1].find("stage \"push\": v D/c_v = 5, partially drained"), std::string::npos) << lines[1];
  EXPECT_NE(lines[2].find("stage \"rest\": T = c_v t/D2 = 6"), std::string::npos) << lines[2];
  // Waves of sqrt(1e6 Pa / 800 kg/m3) = 35.4 m/s.
  EXPECT_NE(lines[1].find("; v is 0.0028 of the speed of waves: inertia is small"), std::string::npos) << lines[1];
  EXPECT_NE(lines[2].find("; a wave crosses the body in 0.0057 of the time in which half of the pressure dissipates: inertia is small"),
            std::string::npos)
      << lines[2];
}

TEST(Dissipation, is_read_from_the_rows_of_the_stages_at_rest)
{
  const std::vector<Dissipation> found = dissipation_of(MadeRunInWater{}.record());
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].stage, "rest");
  EXPECT_DOUBLE_EQ(found[0].time, 6);
  EXPECT_DOUBLE_EQ(found[0].degree, 0.75);
  EXPECT_DOUBLE_EQ(found[0].t50, 4);
  EXPECT_NEAR(found[0].T50, 4, 1e-4);  // D2 / c_v = 1 s, c_v from a difference of stresses
  EXPECT_TRUE(dissipation_of(MadeRun{}.record()).empty());
  const record::RunRecord run = MadeRunInWater{}.record();
  const Charts charts = dissipation_charts(run);
  ASSERT_EQ(charts.size(), 1u);
  ASSERT_EQ(charts[0].curves.size(), found.size());
  EXPECT_EQ(charts[0].curves[0].name, found[0].stage);
  EXPECT_NEAR(charts[0].curves[0].y.back(), found[0].degree, 1e-12);
  EXPECT_TRUE(dissipation_charts(MadeRun{}.record()).empty());
}

TEST(Dissipation, has_no_t50_before_half_of_the_pressure_is_gone)
{
  record::RunRecord run = MadeRunInWater{}.record();
  for (Real& U : run.history.values.back()) U /= 2;
  const std::vector<run_folder::Quantity> found = dissipation_quantities(run);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].name, "U_of_rest");
  EXPECT_DOUBLE_EQ(found[0].value, 0.375);
}

}  // namespace
}  // namespace berm::base::this_file
