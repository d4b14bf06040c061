// SPDX-License-Identifier: BSD-3-Clause
#include "material/linear_elastic.hpp"
#include "material/modified_cam_clay.hpp"
#include "settings/drainage.hpp"

#include <gtest/gtest.h>

namespace berm::settings::this_file {
namespace {

material::PoreWater flowing()
{
  material::PoreWater water;
  water.drainage = material::Drainage::consolidation;
  water.permeability = 1e-6;
  return water;
}

Case bed_of(const material::Material& soil)
{
  Case c;
  c.gravity = {0, -10};
  c.material = {{"silt", soil}};
  bodies::BodySettings body;
  body.material = "silt";
  body.k0 = 0.5;
  c.body = {{"bed", body}};
  return c;
}

TEST(Drainage, of_elastic_soil_has_the_c_v_of_its_constants)
{
  material::LinearElastic soil;
  soil.density = 800;
  soil.young_modulus = 1e6;
  soil.poisson_ratio = 0.25;  // M = 1.2 MPa
  soil.water = flowing();
  soil.water->porosity = 0.4;
  soil.water->bulk_modulus = 2.4e7;
  const std::vector<Consolidation> found = consolidation_of(bed_of(soil), 2);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].material, "silt");
  // Differences of stresses of 1e4 Pa, 1.2 Pa apart: 1e-11 of them is rounding.
  EXPECT_NEAR(found[0].modulus, 1.2e6, 1e-6 * 1.2e6);
  EXPECT_NEAR(found[0].c_v, 1e-6 / (9810 * (1 / 1.2e6 + 0.4 / 2.4e7)), 1e-6 * found[0].c_v);
  soil.water->drainage = material::Drainage::undrained;
  EXPECT_TRUE(consolidation_of(bed_of(soil), 2).empty());
}

// Under the K0 of virgin compression M = (1 + e) sigma_v / lambda, e and lambda of the natural logarithm; 2 %: one step of explicit flow.
TEST(Drainage, of_normally_consolidated_clay_grows_with_the_depth)
{
  material::ModifiedCamClay soil;
  soil.density = 800;
  soil.critical_friction_angle = 30 * pi / 180;
  soil.compression_index = 0.1;
  soil.swelling_index = 0.02;
  soil.void_ratio = 1;
  soil.poisson_ratio = 0.3;
  soil.max_pressure = 1e6;
  soil.water = flowing();
  Case c = bed_of(soil);
  c.body[0].second.k0 = virgin_k0(soil);
  const auto modulus_at = [&](Real depth) { return consolidation_of(c, depth).at(0).modulus; };
  EXPECT_NEAR(modulus_at(10) / modulus_at(1), 10, 0.1);
  EXPECT_NEAR(modulus_at(1), 2 * 8e3 / 0.1, 0.02 * 2 * 8e3 / 0.1);
}

TEST(Drainage, of_stages_is_told_by_their_speed_or_their_time)
{
  material::LinearElastic soil;
  Case c = bed_of(soil);
  StageSettings settle, push, rest, open;
  settle.kind = StageKind::geostatic;
  push.kind = StageKind::push;
  push.velocity = -0.1;
  rest.kind = open.kind = StageKind::drive;
  rest.until.time = 3;
  open.until.consolidation = 0.9;
  c.stage = {settle, push, rest, open};
  const std::vector<StageDrainage> found = drainage_of_stages(c, 0.2, 4e-3);
  ASSERT_EQ(found.size(), 3u);
  EXPECT_TRUE(found[0].moves);
  EXPECT_DOUBLE_EQ(found[0].number, 5);
  EXPECT_FALSE(found[1].moves);
  EXPECT_DOUBLE_EQ(found[1].number, 0.3);
  EXPECT_EQ(found[1].stage, 2u);
  EXPECT_TRUE(std::isnan(found[2].number));
}

TEST(Drainage, tells_how_much_inertia_counts_by_strength_waves_or_the_time_of_a_rest)
{
  Case c;
  StageSettings push;
  push.kind = StageKind::push;
  push.velocity = -0.2;
  c.stage = {push};
  Consolidation soil{"silt", 0, 1.8e6, 4e-3, 1800, 24e3};  // waves of 31.6 m/s
  const StageInertia slow = *inertia_in(c, {0, true, 10}, soil, 0.2);
  EXPECT_EQ(slow.measure, StageInertia::Measure::strength);
  EXPECT_NEAR(slow.part, 0.003, 1e-12);  // 1800 * 0.04 / 24e3
  soil.strength = 0;
  const StageInertia elastic = *inertia_in(c, {0, true, 10}, soil, 0.2);
  EXPECT_EQ(elastic.measure, StageInertia::Measure::wave);
  EXPECT_NEAR(elastic.part, 0.2 / std::sqrt(1000.), 1e-12);
  EXPECT_TRUE(elastic.is_small());
  // Half of the pressure goes in 0.1 D^2 / c_v = 1 s, and a wave takes 0.2 m / 31.6 m/s.
  const StageInertia rest = *inertia_in(c, {0, false, 0.3}, soil, 0.2);
  EXPECT_EQ(rest.measure, StageInertia::Measure::rest);
  EXPECT_NEAR(rest.part, 0.2 / std::sqrt(1000.), 1e-12);
  EXPECT_TRUE(rest.is_small());
  soil.c_v *= 20;
  EXPECT_TRUE(inertia_in(c, {0, false, 0.3}, soil, 0.2)->is_large());
  c.method = Method::fem;
  EXPECT_FALSE(inertia_in(c, {0, true, 10}, soil, 0.2)) << "finite elements have none";
}

}  // namespace
}  // namespace berm::settings::this_file
