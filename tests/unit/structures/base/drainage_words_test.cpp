// SPDX-License-Identifier: BSD-3-Clause
#include "structures/base/drainage_words.hpp"

#include "samples/made_run.hpp"

#include <gtest/gtest.h>

namespace berm::base {
namespace {

/// A pipe of 20 mm in sand; M = 8.4 MPa, K_w / n = 30 M.
problem::Case case_with(Real permeability)
{
  MadeRun run;
  run.law.dilation_angle = 0;
  run.law.inertia_density = 1900;
  run.law.water.emplace();
  run.law.water->drainage = material::Drainage::consolidation;
  run.law.water->porosity = 0.4;
  run.law.water->permeability = permeability;
  problem::Case c = run.settings();
  problem::StageSettings rest;
  rest.name = "rest";
  rest.kind = problem::StageKind::drive;
  rest.until.time = 2;
  c.stage.push_back(rest);
  return c;
}

TEST(DrainageWords, say_whether_stages_are_drained_and_how_far_soil_consolidates)
{
  const Real M = 8.4e6, c_v = 1e-6 / material::unit_weight_of_water / (1 / M + 1 / (30 * M));
  const problem::Case c = case_with(1e-6);
  EXPECT_NEAR(consolidation_coefficient(c.material[0].second), c_v, 1e-9 * c_v);
  const std::vector<std::string> words = drainage_words(c);
  ASSERT_EQ(words.size(), 4u);
  EXPECT_NE(words[0].find("c_v = 0.000829 m²/s"), std::string::npos) << words[0];
  EXPECT_NE(words[1].find(": v D/c_v = "), std::string::npos) << words[1];
  EXPECT_NE(words[1].find("partly drained"), std::string::npos) << words[1];
  EXPECT_NE(words[3].find("rest: T = c_v t/D² = 4.1"), std::string::npos) << words[3];
  EXPECT_NE(drainage_words(case_with(1e-10))[1].find(": undrained"), std::string::npos);
  EXPECT_NE(drainage_words(case_with(1))[1].find(": drained"), std::string::npos);
}

TEST(DrainageWords, are_none_where_no_water_flows)
{
  EXPECT_TRUE(drainage_words(MadeRun().settings()).empty());
}

}  // namespace
}  // namespace berm::base
