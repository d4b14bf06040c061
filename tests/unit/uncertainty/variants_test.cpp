// SPDX-License-Identifier: BSD-3-Clause
#include "uncertainty/variants.hpp"

#include "material/clay.hpp"
#include "material/mohr_coulomb.hpp"
#include "os/error.hpp"
#include "samples/clay_pipe.hpp"

#include <gtest/gtest.h>

namespace berm::uncertainty::this_file {
namespace {

std::string refusal_of(const settings::Case& c)
{
  try {
    choose_variants(c);
  } catch (const KeyError& error) {
    return error.what();
  }
  return "";
}

mesh::SeabedMesh& bed_of(settings::Case& c)
{
  return std::get<mesh::SeabedMesh>(c.mesh);
}

/// The clay's pipe of 1 m on cells of D/20.
settings::Case fine()
{
  settings::Case c = clay();
  bed_of(c).near_size = 0.05;
  c.fem.contact_size = 0.05;
  return c;
}

/// Names of the runs beside that of the case.
std::vector<std::string> names_of(const settings::Case& c)
{
  std::vector<std::string> names;
  for (const Variant& variant : choose_variants(c).variants) names.push_back(variant.name);
  return names;
}

/// The clay's pipe on cells of D/n.
settings::Case on_cells(Real n)
{
  settings::Case c = fine();
  bed_of(c).near_size = *c.fem.contact_size = 1 / n;
  return c;
}

using Names = std::vector<std::string>;

TEST(Variants, of_a_fine_case_are_two_of_coarser_cells_and_the_coarsest_once_more_at_twice_the_pace)
{
  const VariantPlan plan = choose_variants(fine());
  ASSERT_EQ(plan.variants.size(), 3u);
  const std::vector<Real> sizes = {3 / std::sqrt(2.), 3, 3};
  for (std::size_t k = 0; k < sizes.size(); ++k) {
    settings::Case c = plan.variants[k].settings;
    EXPECT_NEAR(plan.variants[k].size, sizes[k], 1e-12);
    EXPECT_EQ(plan.variants[k].speed, k == 2 ? 2 : 1);
    EXPECT_NEAR(bed_of(c).near_size, 0.05 * sizes[k], 1e-12);
    EXPECT_NEAR(bed_of(c).growth, 0.4 * sizes[k], 1e-12) << "all cells of the bed grow, not those of the fine zone alone";
    EXPECT_NEAR(*c.fem.contact_size, 0.05 * sizes[k], 1e-12);
  }
  EXPECT_EQ(names_of(fine()), (Names{"cells_2.12", "cells_3", "cells_3_long_steps"}));
  EXPECT_EQ(plan.variants[2].settings.fem.largest_step, 2 * plan.variants[1].settings.fem.largest_step);
  EXPECT_EQ(plan.variants[2].settings.fem.relaxation, 4 * plan.variants[1].settings.fem.relaxation);
  EXPECT_TRUE(plan.left_out.empty());
}

TEST(Variants, of_a_coarse_case_are_one_of_half_the_cells_and_one_of_coarser_ones)
{
  EXPECT_EQ(names_of(on_cells(10)), (Names{"cells_0.5", "cells_1.5", "cells_1.5_long_steps"}));
  EXPECT_EQ(names_of(on_cells(8)), (Names{"cells_0.5", "cells_1.25", "cells_1.25_long_steps"})) << "not coarser than D/6.4";
  EXPECT_EQ(names_of(on_cells(6)), (Names{"cells_0.5", "cells_0.707", "cells_1_long_steps"})) << "where none can be coarser, one between";
  for (const Real D : {0.35, 0.7, 1.1}) {  // where D over D/8 is not 8 to the last digit
    settings::Case other = fine();
    other.rigid.at(0).second.shape = bodies::CircleSettings{{0, 1}, D};
    bed_of(other).near_size = *other.fem.contact_size = D / 8;
    EXPECT_EQ(names_of(other), (Names{"cells_0.5", "cells_1.25", "cells_1.25_long_steps"})) << D;
  }
  settings::Case c = on_cells(4);
  EXPECT_EQ(refusal_of(c).find("fem.contact_size: "), 0u) << refusal_of(c);
  EXPECT_NE(refusal_of(c).find("make them 0.2 m or smaller"), std::string::npos) << refusal_of(c);
  c.method = settings::Method::mpm;
  EXPECT_EQ(refusal_of(c).find("mesh.near_size: "), 0u) << refusal_of(c);
}

TEST(Variants, have_half_the_cells_in_all_of_the_bed)
{
  settings::Case c = on_cells(10);
  c.method = settings::Method::mpm;
  c.fem.contact_size.reset();
  settings::Case half = choose_variants(c).variants[0].settings;
  EXPECT_EQ(bed_of(half).near_size, 0.05);
  EXPECT_EQ(bed_of(half).growth, bed_of(c).growth / 2);
  EXPECT_NO_THROW(mesh::check(bed_of(half)));
}

/// The clay's pipe in sand.
settings::Case in_sand(Real dilation_angle, std::optional<Real> d50)
{
  settings::Case c = fine();
  material::Material& soil = c.material.at(0).second;
  material::MohrCoulomb sand = soil.get<material::MohrCoulomb>();
  sand.friction_angle = 35 * pi / 180;
  sand.dilation_angle = dilation_angle;
  sand.d50 = d50;
  soil = sand;
  return c;
}

// Cells of D/20, 50 mm, become 150 mm: bands of 15 d50 = 1.5 and 7.5 mm are far narrower than four of them.
TEST(Variants, of_sand_without_a_d50_are_two_more_with_grains)
{
  const VariantPlan plan = choose_variants(in_sand(0, {}));
  ASSERT_EQ(plan.variants.size(), 5u);
  for (const int k : {3, 4}) {
    const Variant& with = plan.variants[static_cast<std::size_t>(k)];
    ASSERT_TRUE(with.d50);
    EXPECT_EQ(with.settings.material.at(0).second.get<material::MohrCoulomb>().d50, with.d50);
    EXPECT_NEAR(with.size, 3, 1e-12);
    EXPECT_EQ(with.speed, 1);
  }
  EXPECT_EQ(plan.variants[3].name, "cells_3_d50_0.1_mm");
  EXPECT_EQ(*plan.variants[4].d50, 0.5e-3);
}

TEST(Variants, have_no_grains_where_they_would_do_nothing)
{
  EXPECT_EQ(choose_variants(in_sand(0, 0.2e-3)).variants.size(), 3u) << "the sand has a d50";
  EXPECT_EQ(choose_variants(in_sand(35 * pi / 180, {})).variants.size(), 3u) << "bands of associated sand lose nothing";
  EXPECT_EQ(choose_variants(fine()).variants.size(), 3u) << "clay";
}

// Over the finest of the runs, which is the case: 1 + 1/4.5 + 1/9 + half of the last; of material points the sum of r^-3. That of half the cells takes 4 or 8.
TEST(Variants, and_the_case_take_no_more_than_1_4_times_the_finest_of_them)
{
  settings::Case c = fine();
  EXPECT_NEAR(work_of(choose_variants(c), c), 0.222 + 0.111 + 0.056, 0.001);
  c.method = settings::Method::mpm;
  EXPECT_NEAR(work_of(choose_variants(c), c), 0.105 + 0.037 + 0.019, 0.001);
  for (const Real n : {8., 10., 15.}) {
    c = on_cells(n);
    c.method = settings::Method::mpm;
    EXPECT_LE(1 + work_of(choose_variants(c), c), 1.4 * 8) << n;
  }
}

TEST(Variants, of_a_mesh_from_a_file_are_refused)
{
  settings::Case c = fine();
  c.mesh = mesh::GmshFile{"my.msh"};
  EXPECT_EQ(refusal_of(c).find("mesh.file: "), 0u) << refusal_of(c);
}

TEST(Variants, of_a_case_without_a_push_or_a_drag_are_refused)
{
  settings::Case c = fine();
  c.stage.resize(1);
  EXPECT_EQ(refusal_of(c).find("stage: "), 0u) << refusal_of(c);
}

TEST(Variants, keep_the_fine_zone_clear_of_the_walls)
{
  settings::Case c = fine();
  bed_of(c).left = 0.76;
  bed_of(c).near_left = -0.7;  // 0.06 m from the wall: less than a coarse cell
  settings::Case coarse = with_other_cells(c, 2).first;
  EXPECT_NEAR(bed_of(coarse).near_left, -0.66, 1e-12);
  EXPECT_NO_THROW(mesh::check(bed_of(coarse)));
}

TEST(Variants, leave_the_fine_zone_of_half_a_bed_at_its_axis)
{
  settings::Case c = fine();
  bed_of(c).left = 0;
  bed_of(c).near_left = 0;
  settings::Case coarse = with_other_cells(c, 2).first;
  EXPECT_EQ(bed_of(coarse).near_left, 0);
  EXPECT_NO_THROW(mesh::check(bed_of(coarse)));
}

/// The lower end of the fine zone, above the base; the bed is one that a mesh can be made of.
Real clear_of_the_base(settings::Case c)
{
  EXPECT_NO_THROW(mesh::check(bed_of(c)));
  return mesh::fine_zone_of(bed_of(c)).lower + bed_of(c).depth;
}

TEST(Variants, keep_the_fine_zone_clear_of_the_base_below_a_trench)
{
  settings::Case c = fine();
  bed_of(c).trench = mesh::Trench{0.3, 1, 1, 0};
  bed_of(c).near_depth = 1.2;  // 0.1 m from the base: less than a coarse cell
  EXPECT_NEAR(clear_of_the_base(c), 0.1, 1e-12);
  EXPECT_NEAR(clear_of_the_base(with_other_cells(c, 2.2).first), 0.11, 1e-12);
  bed_of(c).near_depth = 0.6;
  settings::Case coarse = with_other_cells(c, 2.2).first;
  EXPECT_EQ(bed_of(coarse).near_depth, 0.6) << "where there is room it stays";
}

TEST(Variants, keep_the_fine_zone_clear_of_the_base_below_a_step_and_the_top_above_it)
{
  settings::Case c = fine();
  bed_of(c).step = mesh::Step{-0.3, 0, 1};
  bed_of(c).near_depth = 1.2;
  EXPECT_NEAR(clear_of_the_base(with_other_cells(c, 2.2).first), 0.11, 1e-12);
  c = fine();
  bed_of(c).step = mesh::Step{0.25, 1, 1};  // beyond the fine zone, whose upper end is 0.2 m high: the bed is the highest
  bed_of(c).headroom = 0.31;
  EXPECT_NO_THROW(mesh::check(bed_of(c)));
  settings::Case coarse = with_other_cells(c, 2.2).first;
  EXPECT_NEAR(bed_of(coarse).headroom, 0.36, 1e-12);
  EXPECT_NO_THROW(mesh::check(bed_of(coarse)));
}

TEST(Variants, of_a_slope_have_the_depths_of_a_level_bed)
{
  settings::Case level = fine();
  bed_of(level).near_depth = 1.54;
  settings::Case slope = level;
  bed_of(slope).slope = 0.2;
  EXPECT_NEAR(clear_of_the_base(with_other_cells(level, 2.2).first), 0.11, 1e-12);
  EXPECT_NEAR(clear_of_the_base(with_other_cells(slope, 2.2).first), 0.11, 1e-12);
}

TEST(Variants, have_no_cells_larger_than_a_layer)
{
  settings::Case c = fine();
  bed_of(c).layer = 0.1;
  const VariantPlan plan = choose_variants(c);
  EXPECT_NEAR(plan.variants.back().size, 2, 1e-12);
  for (const Variant& variant : plan.variants) {
    settings::Case coarse = variant.settings;
    EXPECT_EQ(bed_of(coarse).layer, 0.1);
    EXPECT_NO_THROW(mesh::check(bed_of(coarse))) << variant.name;
  }
  bed_of(c).layer = 0.07;
  EXPECT_EQ(refusal_of(c).find("mesh.layer: "), 0u) << refusal_of(c);
  EXPECT_NE(refusal_of(c).find("make it 0.08 m or thicker"), std::string::npos) << refusal_of(c);
}

TEST(Variants, of_a_box_have_whole_cells_and_the_size_that_these_have)
{
  settings::Case c = fine();
  mesh::BoxMesh box;
  box.size = {2, 1};
  box.cells = {41, 20};
  c.mesh = box;
  bodies::BlockSettings block;
  block.spacing = 0.01;
  c.body[0].second.block = block;
  const auto [coarse, size] = with_other_cells(c, 2);
  const mesh::BoxMesh& made = std::get<mesh::BoxMesh>(coarse.mesh);
  EXPECT_EQ(made.cells, (std::vector<Real>{21, 10}));
  EXPECT_NEAR(size, std::sqrt(41. / 21 * 2), 1e-12);
  EXPECT_NEAR(coarse.body[0].second.block->spacing, 0.01 * size, 1e-12) << "as many particles a cell";
}

TEST(Variants, write_no_frames_on_the_way)
{
  settings::Case c = fine();
  c.output.frame_time = c.output.frame_travel = 0.1;
  const settings::Case coarse = with_other_cells(c, 2).first;
  EXPECT_FALSE(coarse.output.frame_time || coarse.output.frame_travel);
}

TEST(TwiceTheSpeed, goes_the_same_way_in_half_the_time)
{
  settings::Case c = fine();
  settings::StageSettings drag;
  drag.kind = settings::StageKind::drag;
  drag.velocity = -0.2;
  drag.vertical_velocity = 0.1;
  drag.ramp = 1;
  drag.until.time = 3;
  drag.until.displacement = 0.5;
  drag.load_times = {0, 2};
  drag.loads.of("u") = {0.1, 0.3};
  drag.loads.of("w_displacement") = {0, 0.2};
  c.stage.push_back(drag);
  c.output.history_time = 0.1;
  const settings::Case fast = at_twice_the_speed(c);
  const settings::StageSettings& s = fast.stage.back();
  EXPECT_EQ(*s.velocity, -0.4);
  EXPECT_EQ(*s.vertical_velocity, 0.2);
  EXPECT_EQ(s.ramp, 0.5);
  EXPECT_EQ(*s.until.time, 1.5);
  EXPECT_EQ(*s.until.displacement, 0.5);
  EXPECT_EQ(s.load_times, (std::vector<Real>{0, 1}));
  EXPECT_EQ(s.loads.of("u"), (std::vector<Real>{0.2, 0.6}));
  EXPECT_EQ(s.loads.of("w_displacement"), (std::vector<Real>{0, 0.2}));
  EXPECT_EQ(*fast.output.history_time, 0.05);
  EXPECT_EQ(fast.stage[0].until.time, c.stage[0].until.time) << "soil that comes to rest takes as long as before";
}

TEST(Variants, of_soil_that_knows_speed_leave_it_out_and_say_so)
{
  settings::Case c = fine();
  c.method = settings::Method::mpm;
  material::Clay clay;
  clay.rate_parameter = 0.1;
  c.material[0].second = clay;
  const VariantPlan plan = choose_variants(c);
  EXPECT_EQ(plan.variants.size(), 2u);
  ASSERT_EQ(plan.left_out.size(), 1u);
  EXPECT_EQ(plan.left_out[0].find("speed: "), 0u);
}

}  // namespace
}  // namespace berm::uncertainty::this_file
