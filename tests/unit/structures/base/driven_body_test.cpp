// SPDX-License-Identifier: BSD-3-Clause
#include "structures/base/driven_body.hpp"

#include "samples/made_run.hpp"

#include <gtest/gtest.h>

namespace berm::base {
namespace {

TEST(DrivenBody, is_measured_by_its_width_its_soil_and_gravity)
{
  const BodyScale sand = body_scale(MadeRun{}.settings());
  EXPECT_EQ(sand.width, 0.02);
  EXPECT_NEAR(sand.unit_weight, 430e3, 1e-6);
  EXPECT_NEAR(sand.gravity_level, 50, 1e-12);
  EXPECT_EQ(sand.strength, 0);
  MadeRun clay;
  clay.law = MadeRun::clay_law();
  EXPECT_EQ(body_scale(clay.settings()).strength, 1000);
}

TEST(DrivenBody, is_none_where_no_push_or_drag_moves_it)
{
  problem::Case c = MadeRun{}.settings();
  EXPECT_TRUE(drives_a_body(c));
  c.stage.clear();
  EXPECT_FALSE(drives_a_body(c));
  c.rigid.clear();
  c.contact.clear();
  EXPECT_FALSE(drives_a_body(c));
  EXPECT_EQ(body_word(c), "body");
  EXPECT_EQ(touched_material(c), nullptr);
}

TEST(DrivenBody, has_a_prototype_under_another_gravity_than_the_earths)
{
  EXPECT_TRUE(has_prototype({.width = 1, .unit_weight = 1, .gravity_level = 50}));
  EXPECT_FALSE(has_prototype({.width = 1, .unit_weight = 1, .gravity_level = 1.02}));
  EXPECT_FALSE(has_prototype({.width = 1, .unit_weight = 1, .gravity_level = 0}));
}

}  // namespace
}  // namespace berm::base
