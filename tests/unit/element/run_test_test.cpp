// SPDX-License-Identifier: BSD-3-Clause
#include "element/element_table.hpp"
#include "element/run_test.hpp"
#include "material/clay.hpp"
#include "material/modified_cam_clay.hpp"
#include "sample_tests.hpp"

#include <gtest/gtest.h>

namespace berm::element::this_file {
namespace {

// The stress that is held is found to 1e-10 of the stresses; sums over 200 steps lose some digits more.
constexpr Real accuracy = 1e-8;

void expect_near(Real value, Real expected)
{
  EXPECT_NEAR(value, expected, accuracy * std::abs(expected)) << "expected " << expected;
}

TEST(TriaxialTest, holds_the_radial_stress_and_ends_on_the_cone)
{
  const Real phi = 33 * pi / 180, Kp = (1 + std::sin(phi)) / (1 - std::sin(phi)), c = 5e3;
  const TestRecord record = run_test(test_of(Triaxial{isotropic(80e3)}, {0.06}), sand_of(33, 8, c));
  EXPECT_EQ(record.failure, "");
  ASSERT_EQ(record.rows.size(), 201u);
  for (const TestRow& row : record.rows) {
    expect_near(lateral_stress(row), 80e3);
    expect_near(-row.stress[2], 80e3);
  }
  const TestRow& last = record.rows.back();
  expect_near(driven_strain(record.settings, last), 0.06);
  expect_near(deviator_stress(last), 80e3 * (Kp - 1) + 2 * c * std::sqrt(Kp));
  expect_near(max_shear_stress(last), *strength(record, last));
  EXPECT_LT(volumetric_strain(last), 0) << "it dilates";
}

TEST(TriaxialTest, in_extension_goes_the_other_way)
{
  Triaxial kind{isotropic(100e3)};
  kind.direction = Direction::extension;
  const TestRecord record = run_test(test_of(kind, {0.05}), sand_of(30, 0));
  const TestRow& last = record.rows.back();
  expect_near(driven_strain(record.settings, last), 0.05);
  EXPECT_LT(-last.strain[1], 0);
  expect_near(deviator_stress(last), -100e3 * (1 - 1. / 3));
}

TEST(TriaxialTest, undrained_keeps_the_volume_and_the_total_radial_stress)
{
  Triaxial kind{isotropic(100e3)};
  kind.drained = false;
  const TestRecord record = run_test(test_of(kind, {0.05}), sand_of(30, 0));
  for (const TestRow& row : record.rows) {
    EXPECT_NEAR(volumetric_strain(row), 0, 1e-15);
    expect_near(lateral_stress(row) + *excess_pore_pressure(record, row), 100e3);
  }
  // p' stays where shear makes no volume; q = 6 sin phi/(3 - sin phi) p'; du = q/3.
  expect_near(deviator_stress(record.rows.back()), 120e3);
  expect_near(*excess_pore_pressure(record, record.rows.back()), 40e3);
}

TEST(UndrainedTest, of_a_law_of_total_stresses_shows_no_pore_pressure)
{
  Triaxial kind{isotropic(100e3)};
  kind.drained = false;
  const TestRecord clay = run_test(test_of(kind, {0.05}), sand_of(0, 0, 10e3));
  expect_near(deviator_stress(clay.rows.back()), 20e3);
  EXPECT_FALSE(shows_effective_stress(clay));
  EXPECT_FALSE(excess_pore_pressure(clay, clay.rows.back()));
  kind.drained = true;
  const TestRecord drained = run_test(test_of(kind, {0.05}), sand_of(30, 0));
  EXPECT_FALSE(excess_pore_pressure(drained, drained.rows.back()));
}

TEST(StrainRate, strengthens_clay_by_the_rate_of_shear)
{
  material::Clay law;
  law.density = 600;
  law.young_modulus = 3e6;
  law.poisson_ratio = 0.49;
  law.undrained_strength = 10e3;
  law.rate_parameter = 0.1;
  law.reference_rate = 1e-5;
  SimpleShear kind{isotropic(50e3)};
  kind.drained = false;
  TestSettings test = test_of(kind, {0.1});
  expect_near(shear_stress(run_test(test, law).rows.back()), 10e3);
  test.strain_rate = 1e-3;
  const TestRecord fast = run_test(test, law);
  expect_near(shear_stress(fast.rows.back()), 12e3);  // two decades
  expect_near(fast.rows.back().time, 100);
}

TEST(BiaxialTest, is_in_plane_strain)
{
  const TestRecord record = run_test(test_of(Biaxial{isotropic(100e3)}, {0.05}), sand_of(30, 10));
  for (const TestRow& row : record.rows) {
    EXPECT_EQ(row.strain[2], 0);
    expect_near(lateral_stress(row), 100e3);
  }
  expect_near(deviator_stress(record.rows.back()), 200e3);
}

TEST(SimpleShearTest, keeps_the_vertical_stress_and_no_horizontal_strain)
{
  const TestRecord record = run_test(test_of(SimpleShear{at_rest(100e3, 0.5)}, {0.05, -0.05}), sand_of(30, 0));
  for (const TestRow& row : record.rows) {
    EXPECT_EQ(row.strain[0], 0);
    EXPECT_EQ(row.strain[2], 0);
    expect_near(vertical_stress(row), 100e3);
  }
  EXPECT_EQ(record.rows.back().leg, 1);
  EXPECT_GT(shear_stress(record.rows[200]), 0);
  EXPECT_LT(shear_stress(record.rows.back()), 0);
}

TEST(OedometerTest, reaches_the_stresses_of_its_path_by_the_oedometer_modulus)
{
  Oedometer kind{at_rest(10e3, 3. / 7), {}};
  kind.stress_path = {200e3, 50e3};
  const TestRecord record = run_test(test_of(kind, {}), sand_of(35, 0));
  const Real M = 30e6 * 0.7 / (1.3 * 0.4);
  expect_near(vertical_stress(record.rows[200]), 200e3);
  expect_near(vertical_stress(record.rows.back()), 50e3);
  expect_near(driven_strain(record.settings, record.rows.back()), 40e3 / M);
  expect_near(lateral_stress(record.rows.back()), 50e3 * 3 / 7);
}

TEST(OedometerTest, by_strains_gives_the_same_as_by_stresses)
{
  Oedometer by_stress{at_rest(100e3, 0.5), {}};
  by_stress.stress_path = {300e3};
  const TestRecord first = run_test(test_of(by_stress, {}), sand_of(20, 0));
  const TestRecord second =
      run_test(test_of(Oedometer{at_rest(100e3, 0.5), {}}, {driven_strain(first.settings, first.rows.back())}), sand_of(20, 0));
  expect_near(vertical_stress(second.rows.back()), 300e3);
}

// Undrained to the critical state the volume stays, so that p' = (p_c / 2) (2 p' / p_c)^(kappa/lambda) of the p_c before; consolidated back to p0 along the swelling
// line p_c stays. So q of cycle n is M p0 2^-(L^n), L = 1 - kappa/lambda. The critical state is approached, within 1e-4 at a strain of one; a step of the
// law is 1/400 of that.
TEST(Reconsolidation, makes_clay_stronger_each_time)
{
  material::ModifiedCamClay law;
  law.density = 700;
  law.critical_friction_angle = 25.3769335 * pi / 180;  // M = 1
  law.compression_index = 0.2;
  law.swelling_index = 0.04;
  law.void_ratio = 1;
  law.poisson_ratio = 0.3;
  law.max_pressure = 200e3;
  Triaxial kind{isotropic(100e3)};
  kind.drained = false;
  kind.reconsolidated = true;
  TestSettings test = test_of(kind, {1});
  test.cycles = 4;
  test.steps = 400;
  const TestRecord record = run_test(test, law);
  ASSERT_EQ(record.failure, "");
  ASSERT_EQ(record.rows.size(), 1u + 4 * 400 + 3 * 800);
  EXPECT_EQ(record.rows.back().leg, 6);
  for (const std::size_t end_of_consolidation : {1200u, 2400u, 3600u}) {
    expect_near(mean_stress(record.rows[end_of_consolidation]), 100e3);
    EXPECT_NEAR(deviator_stress(record.rows[end_of_consolidation]), 0, 1e-3);
  }
  const auto s_u = [&](int n) {
    for (const KeyResult& result : key_results(record))
      if (result.name == "s_u_" + std::to_string(n)) return result.value;
    return nan;
  };
  for (int n = 1; n <= 4; ++n) EXPECT_NEAR(s_u(n), 50e3 * std::exp2(-std::pow(0.8, n)), 2e-3 * 50e3) << "cycle " << n;
  EXPECT_GT(volumetric_strain(record.rows.back()), 0) << "water has left";
}

TEST(Cycles, follow_the_path_again)
{
  SimpleShear kind{isotropic(100e3)};
  TestSettings test = test_of(kind, {0.01, -0.01});
  test.cycles = 3;
  test.steps = 10;
  const TestRecord record = run_test(test, sand_of(30, 0));
  EXPECT_EQ(record.rows.size(), 61u);
  EXPECT_EQ(record.rows.back().leg, 5);
  EXPECT_NEAR(driven_strain(test, record.rows[50]), 0.01, 1e-12);
  EXPECT_NEAR(driven_strain(test, record.rows[60]), -0.01, 1e-12);
}

TEST(TestThatFails, says_where_and_keeps_what_came_before)
{
  Oedometer kind{at_rest(0, 0), {}};
  kind.stress_path = {1e6, 1e9};  // a modulus of 40 MPa: a strain of 25
  TestSettings test = test_of(kind, {});
  test.steps = 4;
  const TestRecord record = run_test(test, sand_of(35, 0));
  EXPECT_EQ(record.rows.size(), 5u);
  EXPECT_NE(record.failure.find("the specimen failed at axial strain 2.47"), std::string::npos) << record.failure;
}

}  // namespace
}  // namespace berm::element::this_file
