// SPDX-License-Identifier: BSD-3-Clause
#include "structures/penetration/penetration_run.hpp"

#include "material/linear_elastic.hpp"
#include "samples/made_push.hpp"
#include "structures/penetration/penetrometers.hpp"

#include <gtest/gtest.h>

namespace berm::penetration::this_file {
namespace {

// Sums of exact numbers.
constexpr Real round_off = 1e-9;

TEST(PenetrationRun, of_a_cone_takes_the_overburden_at_its_shoulder_off)
{
  MadePush made;
  made.q = [](Real z) { return 100e3 + 5e3 * z; };
  const record::RunRecord record = made.record();
  const PenetrationRun run(record, cone());
  EXPECT_EQ(run.measure(), Measure::strength);
  EXPECT_NEAR(run.area(), pi * 0.01, round_off);
  EXPECT_NEAR(run.z_end(), 2 - 0.1 * std::sqrt(3.), round_off);
  EXPECT_NEAR(run.w_end(), 2, round_off);
  for (const Real z : {0.1, 1., 1.7}) EXPECT_NEAR(run.factor_at(z), 10, 1e-6) << z;
  EXPECT_NEAR(run.q_at(1), 105e3, 1e-3);
  EXPECT_TRUE(std::isnan(run.q_at(2)));
}

TEST(PenetrationRun, takes_the_strength_at_the_depth_of_the_shoulder)
{
  MadePush made;
  made.law.cohesion = 2e3;
  made.law.cohesion_gradient = 8e3;
  made.q = [](Real z) { return 12 * (2e3 + 8e3 * z) + 5e3 * z; };
  const record::RunRecord record = made.record();
  const PenetrationRun run(record, cone());
  EXPECT_NEAR(run.factor_at(0.2), 12, 1e-6);
  EXPECT_NEAR(run.factor_at(1.5), 12, 1e-6);
  EXPECT_NEAR(run.soil.growth(0.5, 0.2), 8e3, 1e-6);
}

TEST(PenetrationRun, takes_the_force_on_the_shaft_off_and_tells_its_friction)
{
  MadePush made;
  made.shaft = [](Real z) { return z > 0 ? 4e3 * pi * 0.2 * z : 0; };
  made.q = [](Real z) { return 100e3 + 5e3 * z; };
  const record::RunRecord record = made.record();
  const PenetrationRun run(record, cone());
  EXPECT_TRUE(run.knows_shaft());
  EXPECT_NEAR(run.factor_at(1), 10, 1e-6);
  EXPECT_NEAR(run.last().friction, 4e3, 1e-6);
  EXPECT_NEAR(record.quantity("f_shaft_end")->value, 4e3, 1e-6);
}

TEST(PenetrationRun, in_sand_divides_by_the_overburden)
{
  MadePush made;
  made.law = MadePush::sand();
  made.q = [](Real z) { return 41 * 5e3 * z; };
  const record::RunRecord record = made.record();
  const PenetrationRun run(record, cone());
  EXPECT_EQ(run.measure(), Measure::overburden);
  EXPECT_NEAR(run.factor_at(1), 40, 1e-6);
  EXPECT_STREQ(run.symbol()->plain, "Q_t");
}

TEST(PenetrationRun, of_a_ball_takes_the_weight_of_the_displaced_soil_off)
{
  MadePush made;
  made.shape = bodies::CircleSettings{{0, 0.1}, 0.2};
  const record::RunRecord record = made.record();
  const PenetrationRun run(record, ball());
  EXPECT_NEAR(run.displaced(-0.1), 0, round_off);
  EXPECT_NEAR(run.displaced(0), 2. / 3 * pi * 1e-3, round_off);
  EXPECT_NEAR(run.displaced(1), 4. / 3 * pi * 1e-3, round_off);
  EXPECT_NEAR(run.factor_at(1), (100e3 - 5e3 * 4. / 3 * 0.1) / 10e3, 1e-6);
}

TEST(PenetrationRun, of_half_a_bar_beside_a_wall_divides_by_the_half_that_is_modelled)
{
  MadePush made;
  made.geometry = settings::Geometry::plane_strain;
  made.shape = bodies::CircleSettings{{0, -0.4}, 0.2};
  made.first_w = 0.5;
  made.q = [](Real) { return 50e3; };
  const record::RunRecord record = made.record();
  const PenetrationRun run(record, t_bar());
  EXPECT_NEAR(run.area(), 0.1, round_off);
  EXPECT_NEAR(run.whole_width(), 0.2, round_off);
  EXPECT_NEAR(run.displaced(1), pi * 0.01 / 2, round_off);
  EXPECT_NEAR(run.factor_at(1), (100e3 - 5e3 * pi * 0.01 / 0.2) / 10e3, 1e-6);
}

TEST(PenetrationRun, of_a_quarter_of_a_ball_in_space_divides_by_its_quarter)
{
  MadePush made;
  made.shape = bodies::SphereSettings{{0, 0.1, 0}, 0.2};
  made.geometry = settings::Geometry::space;
  record::RunRecord record = made.record();
  record.settings.gravity = {0, -standard_gravity, 0};
  mesh::BoxMesh box;
  box.lower = {0, -4, 0};
  box.size = {4, 4, 4};
  record.settings.mesh = box;
  const PenetrationRun run(record, ball());
  EXPECT_NEAR(run.area(), pi * 0.01 / 4, round_off);
  EXPECT_NEAR(run.displaced(1), pi * 1e-3 / 3, round_off);
  box.lower = {0, -4, -2};
  record.settings.mesh = box;
  EXPECT_NEAR(PenetrationRun(record, ball()).area(), pi * 0.01 / 2, round_off);
}

TEST(PenetrationRun, of_a_part_between_planes_of_symmetry_has_the_force_of_the_whole_and_its_area)
{
  MadePush made;
  made.geometry = settings::Geometry::space;
  const auto area_of = [&](const bodies::RigidShapeSettings& shape, const Penetrometer& how) {
    made.shape = shape;
    record::RunRecord record = made.record();
    mesh::BoxMesh box;
    box.lower = {0, -4, 0};
    box.size = {4, 4, 4};
    record.settings.mesh = box;
    record.settings.symmetry = {"x", "z"};
    return PenetrationRun(record, how).area();
  };
  EXPECT_NEAR(area_of(bodies::SphereSettings{{0, 0.1, 0}, 0.2}, ball()), pi * 0.01, round_off);
  EXPECT_NEAR(area_of(MadePush::cone(), cone()), pi * 0.01, round_off);
  EXPECT_NEAR(area_of(bodies::CylinderSettings{{0, 0.05, 0}, {0, 1, 0}, 0.2, 0.1}, footing()), pi * 0.01, round_off);
  EXPECT_NEAR(area_of(bodies::BoxSettings{{0, 0.05, 0}, {0.2, 0.1, 0.3}}, footing()), 0.06, round_off);
}

TEST(PenetrationRun, of_a_footing_on_sand_divides_by_half_the_weight_over_its_whole_width)
{
  MadePush made;
  made.law = MadePush::sand();
  made.shape = bodies::BoxSettings{{0, 0.05}, {0.2, 0.1}, 0};
  made.q = [](Real z) { return 0.5 * 5e3 * 0.2 * 15 + 5e3 * z; };
  const record::RunRecord record = made.record();
  const PenetrationRun run(record, footing());
  EXPECT_EQ(run.measure(), Measure::half_weight);
  EXPECT_NEAR(run.factor_at(0.5), 15, 1e-6);
}

TEST(PenetrationRun, tells_whether_the_resistance_is_steady_and_from_where)
{
  MadePush made;
  made.q = [](Real z) { return 5e3 * z + (z < 1 ? 50e3 + 50e3 * z : 100e3); };
  const record::RunRecord record = made.record();
  const PenetrationRun run(record, cone());
  EXPECT_TRUE(run.last().steady());
  EXPECT_NEAR(run.last().factor, 10, 1e-6);
  EXPECT_NEAR(run.last().travel, 0.4, round_off);
  EXPECT_NEAR(run.last().change, 0, 1e-6);
  EXPECT_NEAR(run.last().scatter, 0, 1e-6);
  // 9.5 is reached at z = 0.9; rows are 0.01 D apart.
  EXPECT_NEAR(run.last().steady_from, 0.9, 0.011 * 0.2);
  made.q = [](Real z) { return 5e3 * z + 50e3 * z; };
  const record::RunRecord growing = made.record();
  const LastTravel last = PenetrationRun(growing, cone()).last();
  EXPECT_FALSE(last.steady());
  EXPECT_NEAR(last.change, 0.4 / (2 - 0.1 * std::sqrt(3.) - 0.2), 1e-6);
  EXPECT_TRUE(std::isnan(last.steady_from));
}

TEST(PenetrationRun, scatter_is_the_standard_deviation_of_the_rows)
{
  MadePush made;
  int row = 0;
  made.q = [&row](Real z) { return 5e3 * z + 100e3 + (row++ % 2 == 0 ? 3e3 : -3e3); };
  const record::RunRecord record = made.record();
  EXPECT_NEAR(PenetrationRun(record, cone()).last().scatter, 0.03,
              0.001);  // the fit takes the ends of an even number of rows with it
}

TEST(PenetrationRun, of_soil_without_a_strength_has_a_resistance_and_no_factor)
{
  MadePush made;
  record::RunRecord record = made.record();
  material::LinearElastic elastic;
  elastic.density = 500;
  elastic.young_modulus = 1e6;
  record.settings.material[0].second = elastic;
  const PenetrationRun run(record, cone());
  EXPECT_EQ(run.measure(), Measure::none);
  EXPECT_EQ(run.symbol(), nullptr);
  EXPECT_NEAR(run.last().q, 100e3, 1e-3);
}

TEST(SoilProfile, knows_what_formulas_want)
{
  MadePush made;
  made.k0 = 0.6;
  made.contact.adhesion = 4e3;
  const record::RunRecord record = made.record();
  const SoilAt soil = SoilProfile(record).at(1.5);
  EXPECT_NEAR(soil.strength, 10e3, round_off);
  EXPECT_NEAR(soil.overburden, 7.5e3, 1e-6);
  EXPECT_NEAR(soil.anisotropy, 0.4 * 7.5e3 / 20e3, 1e-9);
  EXPECT_NEAR(soil.rigidity_index, 100, 1e-9);
  EXPECT_NEAR(soil.interface_ratio, 0.4, 1e-12);
  MadePush rubs;
  rubs.contact.friction_angle = 0.1;
  const record::RunRecord with_friction = rubs.record();
  EXPECT_TRUE(std::isnan(SoilProfile(with_friction).at(1).interface_ratio));
}

}  // namespace
}  // namespace berm::penetration::this_file
