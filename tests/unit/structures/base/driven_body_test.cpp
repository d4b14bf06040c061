// SPDX-License-Identifier: BSD-3-Clause
#include "structures/base/driven_body.hpp"

#include "samples/made_run.hpp"

#include <gtest/gtest.h>

namespace berm::base::this_file {
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
  settings::Case c = MadeRun{}.settings();
  EXPECT_TRUE(drives_a_body(c));
  c.stage.clear();
  EXPECT_FALSE(drives_a_body(c));
  c.rigid.clear();
  c.contact.clear();
  EXPECT_FALSE(drives_a_body(c));
  EXPECT_EQ(body_word(c), "body");
  EXPECT_FALSE(touched_material(c));
}

TEST(DrivenBody, covers_the_mesh_where_it_reaches_from_side_to_side)
{
  settings::Case c = MadeRun{}.settings();
  EXPECT_FALSE(covers_the_mesh(c)) << "a pipe on a seabed";
  mesh::BoxMesh box;
  box.lower = {-0.005, 0};
  box.size = {0.01, 1};
  c.mesh = box;
  EXPECT_TRUE(covers_the_mesh(c)) << "20 mm wide, over 10 mm";
  box.size = {0.016, 1};
  c.mesh = box;
  EXPECT_FALSE(covers_the_mesh(c)) << "open on the right";
}

TEST(DrivenBody, has_the_strength_of_its_lowest_point_at_the_end_of_the_push)
{
  MadeRun run;
  run.law = MadeRun::clay_law();
  settings::Case c = run.settings();
  c.material[0].second.get_if<material::MohrCoulomb>()->cohesion_gradient = 5e4;
  for (settings::StageSettings& stage : c.stage)
    if (stage.kind == settings::StageKind::push) stage.until.embedment = 0.01;
  EXPECT_DOUBLE_EQ(reference_depth(c), 0.01);
  EXPECT_DOUBLE_EQ(body_scale(c).strength, 1500);
  EXPECT_DOUBLE_EQ(body_scale(c).strength_depth, 0.01);
  EXPECT_EQ(body_scale(run.settings()).strength_depth, 0);
}

TEST(DrivenBody, in_a_trench_has_the_strength_of_the_soil_as_it_was_laid_down)
{
  MadeRun made;
  made.law = MadeRun::clay_law();
  record::RunRecord run = made.record();
  run.settings.material[0].second.get_if<material::MohrCoulomb>()->cohesion_gradient = 5e4;
  for (settings::StageSettings& stage : run.settings.stage)
    if (stage.kind == settings::StageKind::push) stage.until.embedment = 0.01;
  run.ground.line.corners = {{-1, 0}, {-0.05, 0}, {-0.05, -0.04}, {0.05, -0.04}, {0.05, 0}, {1, 0}};
  EXPECT_DOUBLE_EQ(soil_depth(run.settings, run.ground, 0.01), 0.05);
  EXPECT_DOUBLE_EQ(soil_depth(run.settings, {}, 0.01), 0.01);
  run.quantities.clear();
  run.quantities.push_back({"w_end_of_push", 0.01, "m", ""});
  EXPECT_DOUBLE_EQ(body_scale(run).strength_depth, 0.05);
  EXPECT_DOUBLE_EQ(body_scale(run).strength, 1000 + 5e4 * 0.05);
}

TEST(DrivenBody, in_regions_of_other_materials_meets_that_below_it_where_the_run_has_noted_it)
{
  MadeRun made;
  made.law = MadeRun::clay_law();  // s_u = 1 kPa
  record::RunRecord run = made.record();
  material::MohrCoulomb trench = made.law;
  trench.cohesion = 3000;
  trench.density *= 2;
  run.settings.material.emplace_back("trench", trench);
  run.settings.body[0].second.regions = {"bed", "filled"};
  run.settings.body[0].second.region_material = {{"filled", "trench"}};
  EXPECT_DOUBLE_EQ(body_scale(run).strength, 1000);
  run.summary.emplace();
  run.summary->text[region_entry] = "bed";
  EXPECT_DOUBLE_EQ(body_scale(run).strength, 1000);
  run.summary->text[region_entry] = "filled";
  EXPECT_DOUBLE_EQ(body_scale(run).strength, 3000);
  EXPECT_NEAR(body_scale(run).unit_weight, 2 * 430e3, 1e-6 * 430e3);
  EXPECT_EQ(touched_soil(run)->names, std::vector<std::string>{"trench"});
}

TEST(DrivenBody, has_a_prototype_under_another_gravity_than_the_earths)
{
  EXPECT_TRUE(has_prototype({.width = 1, .unit_weight = 1, .gravity_level = 50}));
  EXPECT_FALSE(has_prototype({.width = 1, .unit_weight = 1, .gravity_level = 1.02}));
  EXPECT_FALSE(has_prototype({.width = 1, .unit_weight = 1, .gravity_level = 0}));
}

}  // namespace
}  // namespace berm::base::this_file
