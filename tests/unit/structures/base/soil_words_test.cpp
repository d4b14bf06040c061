// SPDX-License-Identifier: BSD-3-Clause
#include "structures/base/soil_words.hpp"

#include "samples/made_run.hpp"

#include <gtest/gtest.h>

namespace berm::base::this_file {
namespace {

TEST(SoilWords, say_layers_and_the_strength_at_the_surface_and_where_the_push_ends)
{
  MadeRun run;
  run.law = MadeRun::clay_law();  // 1 kPa
  settings::Case c = run.settings();
  EXPECT_TRUE(soil_words(c).empty());
  auto stiff = c.material[0];
  stiff.first = "stiff";
  stiff.second.get_if<material::MohrCoulomb>()->cohesion = 3e3;
  c.material.push_back(stiff);
  c.material[0].second.get_if<material::MohrCoulomb>()->cohesion_gradient = 5e4;
  c.body[0].second.soil_layer = {{0.05, "stiff"}};
  for (settings::StageSettings& stage : c.stage)
    if (stage.kind == settings::StageKind::push) stage.until.embedment = 0.01;
  const std::vector<std::string> words = soil_words(c);
  ASSERT_EQ(words.size(), 3u);
  EXPECT_NE(words[0].find("from 50 mm down \"stiff\""), std::string::npos) << words[0];
  EXPECT_NE(words[1].find("at the surface: cohesion 1 kPa"), std::string::npos) << words[1];
  EXPECT_NE(words[2].find("10 mm deep, the lowest point of the pipe: cohesion 1.5 kPa"), std::string::npos) << words[2];
}

}  // namespace
}  // namespace berm::base::this_file
