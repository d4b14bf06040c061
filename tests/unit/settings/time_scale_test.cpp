// SPDX-License-Identifier: BSD-3-Clause
#include "settings/time_scale.hpp"

#include "material/mohr_coulomb.hpp"
#include "samples/sample_case.hpp"

#include <gtest/gtest.h>

namespace berm::problem::this_file {
namespace {

/// A pipe of 0.4 m, 100 kg/m, on clay of 2 kPa, under waves of H with a period of 10 s.
settings::Case pipe_in_waves(Real largest)
{
  settings::StageSettings storm = stage_of(settings::StageKind::drag, "storm");
  for (int k = 0; k <= 400; ++k) {
    storm.load_times.push_back(0.1 * k);
    storm.loads.of("H").push_back(largest * std::sin(2 * pi * 0.1 * k / 10) + 0.02 * largest * (k % 2));  // and the noise of a record
  }
  storm.loads.of("V").assign(401, 500);
  settings::Case c = pipe_over_box({storm});
  c.rigid[0].second.mass = 100;
  material::MohrCoulomb clay;
  clay.density = 1600;
  clay.young_modulus = 1e6;
  clay.poisson_ratio = 0.49;
  clay.cohesion = 2000;
  c.material = {{"clay", clay}};
  c.body[0].second.material = "clay";
  contact::ContactSettings skin;
  skin.body = "bed";
  skin.rigid = "pipe";
  c.contact = {{"skin", skin}};
  return c;
}

TEST(TimeScale, is_the_fastest_at_which_inertia_is_small)
{
  const settings::Case c = pipe_in_waves(400);
  const std::optional<settings::TimeScale> found = time_scale_of(c, c.stage[0]);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->half_wave, 5, 0.3) << "of the waves, not of the noise";
  const Real soil = 0.04 / std::sqrt(0.003 * 2000 / 1600), body = std::sqrt(4 * 100 * 0.04 / (0.03 * 500));
  EXPECT_GT(body, soil);
  EXPECT_NEAR(found->shortest, body, 1e-12);
  EXPECT_EQ(found->reason, settings::TimeScale::Reason::mass);
  EXPECT_GE(found->scale, found->shortest / found->half_wave);
  EXPECT_LT(found->scale, found->shortest / found->half_wave + 0.01);
}

TEST(TimeScale, is_limited_by_the_soil_where_the_force_is_large)
{
  const settings::Case c = pipe_in_waves(40000);
  const std::optional<settings::TimeScale> found = time_scale_of(c, c.stage[0]);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->shortest, 0.04 / std::sqrt(0.003 * 2000 / 1600), 1e-12);
  EXPECT_EQ(found->reason, settings::TimeScale::Reason::soil);
}

TEST(TimeScale, takes_a_jump_for_no_wave)
{
  settings::Case c = pipe_in_waves(400);
  settings::StageSettings& storm = c.stage[0];
  storm.load_times = {0, 2, 2, 7, 7, 12, 12, 15};
  storm.loads.of("H") = {0, 400, -400, -400, 400, 400, -400, 0};
  storm.loads.of("V").assign(8, 500);
  const std::optional<settings::TimeScale> found = time_scale_of(c, storm);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->half_wave, 5) << "from one jump to the next";
}

TEST(TimeScale, is_none_of_velocities_nor_without_soil_or_history)
{
  settings::Case c = pipe_in_waves(400);
  settings::StageSettings moved = c.stage[0];
  std::swap(moved.loads.of("H"), moved.loads.of("u"));
  EXPECT_FALSE(time_scale_of(c, moved));
  EXPECT_FALSE(time_scale_of(c, stage_of(settings::StageKind::drag)));
  c.contact.clear();
  EXPECT_FALSE(time_scale_of(c, c.stage[0]));
}

TEST(TimeScale, is_said_with_both_times)
{
  settings::StageSettings storm = pipe_in_waves(400).stage[0];
  storm.time_scale = 0.3;
  EXPECT_EQ(time_scale_words(storm), "a record of 40 s in 12 s of the run, time_scale = 0.3");
}

}  // namespace
}  // namespace berm::problem::this_file
