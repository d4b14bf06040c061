// SPDX-License-Identifier: BSD-3-Clause
#include "element/element_table.hpp"
#include "material/linear_elastic.hpp"
#include "sample_tests.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace berm::element::this_file {
namespace {

Real result(const TestRecord& record, const std::string& name)
{
  for (const KeyResult& r : key_results(record))
    if (r.name == name) return r.value;
  ADD_FAILURE() << "there is no " << name;
  return 0;
}

bool has(const TestRecord& record, const std::string& name)
{
  const std::vector<KeyResult> all = key_results(record);
  return std::any_of(all.begin(), all.end(), [&](const KeyResult& r) { return r.name == name; });
}

// Rounding of strains that are differences of sums over 200 steps.
constexpr Real accuracy = 1e-6;

TEST(KeyResults, of_a_drained_triaxial_test_are_the_parameters_of_the_law)
{
  for (const Direction direction : {Direction::compression, Direction::extension}) {
    Triaxial kind{isotropic(100e3)};
    kind.direction = direction;
    const TestRecord record = run_test(test_of(kind, {0.05}), sand_of(35, 6));
    EXPECT_NEAR(result(record, "E_initial"), 30e6, 30e6 * accuracy);
    EXPECT_NEAR(result(record, "E_50"), 30e6, 30e6 * accuracy);
    EXPECT_NEAR(result(record, "G_initial"), 30e6 / 2.6, 30e6 * accuracy);
    EXPECT_NEAR(result(record, "friction_angle_peak"), 35 * pi / 180, accuracy);
    EXPECT_NEAR(result(record, "dilation_angle_end"), 6 * pi / 180, accuracy);
    EXPECT_FALSE(has(record, "s_u"));
    EXPECT_FALSE(has(record, "excess_pore_pressure_end"));
  }
}

TEST(KeyResults, of_a_biaxial_test_have_the_dilation_and_the_modulus_of_plane_strain)
{
  const TestRecord record = run_test(test_of(Biaxial{isotropic(100e3)}, {0.05}), sand_of(35, 6));
  EXPECT_NEAR(result(record, "dilation_angle_end"), 6 * pi / 180, accuracy);
  EXPECT_NEAR(result(record, "E_initial"), 30e6 / 0.91, 30e6 * accuracy);
  EXPECT_NEAR(result(record, "G_initial"), 30e6 / 2.6, 30e6 * accuracy);
}

TEST(KeyResults, name_the_peak_where_it_is_reached_first)
{
  const Real Kp = (1 + std::sin(35 * pi / 180)) / (1 - std::sin(35 * pi / 180)), yields = 100e3 * (Kp - 1) / 30e6;
  const TestRecord record = run_test(test_of(Triaxial{isotropic(100e3)}, {0.05}), sand_of(35, 0));
  const Real at = result(record, "axial_strain_at_peak"), step = 0.05 / 200;
  EXPECT_GE(at, yields * (1 - accuracy));
  EXPECT_LE(at, yields + step);
}

TEST(KeyResults, of_undrained_clay_are_its_strength_and_no_friction)
{
  SimpleShear kind{isotropic(50e3)};
  kind.drained = false;
  const TestRecord record = run_test(test_of(kind, {0.05}), sand_of(0, 0, 8e3));
  EXPECT_NEAR(result(record, "s_u"), 8e3, 8e3 * accuracy);
  EXPECT_FALSE(has(record, "friction_angle_peak"));
  EXPECT_FALSE(has(record, "excess_pore_pressure_end"));
}

TEST(KeyResults, know_no_dilation_of_soil_that_cannot_yield_or_has_no_pressure)
{
  material::LinearElastic elastic;
  elastic.density = 1000;
  elastic.young_modulus = 10e6;
  elastic.poisson_ratio = 0.2;
  EXPECT_TRUE(std::isnan(result(run_test(test_of(Triaxial{isotropic(100e3)}, {0.05}), elastic), "dilation_angle_end")));
  EXPECT_TRUE(std::isnan(result(run_test(test_of(Triaxial{isotropic(0)}, {0.05}), sand_of(35, 6)), "dilation_angle_end")));
}

TEST(KeyResults, are_none_of_a_test_that_failed_at_once)
{
  TestRecord record = run_test(test_of(Triaxial{isotropic(100e3)}, {0.05}), sand_of(35, 0));
  record.rows.resize(1);
  EXPECT_TRUE(key_results(record).empty());
}

TEST(KeyResults, are_shown_in_the_units_of_the_laboratory)
{
  const KeyResult q{"q", 269017.2, "Pa", "q, peak", "", 1e-3, "kPa"};
  EXPECT_EQ(q.heading(), "q, peak (kPa)");
  EXPECT_EQ(q.shown(), "269.0");
}

}  // namespace
}  // namespace berm::element::this_file
