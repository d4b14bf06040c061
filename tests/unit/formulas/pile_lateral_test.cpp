// SPDX-License-Identifier: BSD-3-Clause
#include "formulas/pile_lateral.hpp"

#include <array>
#include <gtest/gtest.h>

namespace berm::formulas::this_file {
namespace {

/// The pile of the template: 2 m in clay of 30 kPa and 7.8 kN/m3, 8 m in the bed, alpha = 0.5.
ClayAtPile clay_at(Real z)
{
  ClayAtPile clay;
  clay.z = z, clay.diameter = 2, clay.length = 8;
  clay.strength = clay.strength_at_bed = 30e3, clay.overburden = 7.8e3 * z;
  clay.adhesion = 0.5, clay.strain_50 = strain_50_of(100), clay.small_strain_modulus = 550 * clay.strength;
  return clay;
}
constexpr Real su_D = 60e3;  // N/m

TEST(PileLateral, matlock_has_the_factors_of_a_calculation_by_hand)
{
  EXPECT_NEAR(matlock_factor(clay_at(2.5)).value, 3 + 7.8 * 2.5 / 30 + 0.5 * 2.5 / 2, 1e-12);
  EXPECT_NEAR(matlock_factor(clay_at(2.5), 0.25).value, 3 + 0.65 + 0.3125, 1e-12);
  EXPECT_NEAR(matlock_factor(clay_at(20)).value, 9, 1e-12) << "deep";
  ClayAtPile stiff = clay_at(1);
  stiff.strength = 120e3;
  EXPECT_FALSE(matlock_factor(stiff).valid);
}

TEST(PileLateral, matlock_and_dnv_go_through_the_points_of_the_codes)
{
  // Points of a public program, two digits of p: half a unit of the last.
  constexpr std::array over_yc{0.1, 0.3, 1., 3., 8., 20.}, part{0.23, 0.33, 0.5, 0.72, 1., 1.};
  const ClayAtPile clay = clay_at(2.5);
  const Real yc = 2.5 * clay.strain_50 * clay.diameter, p_u = matlock_factor(clay).value * su_D;
  for (std::size_t k = 0; k < part.size(); ++k) {
    EXPECT_NEAR(dnv_clay_resistance(clay, over_yc[k] * yc).value / p_u, part[k], 0.0051) << over_yc[k];
    EXPECT_NEAR(matlock_resistance(clay, over_yc[k] * yc).value / p_u, part[k], 0.0051) << over_yc[k];
  }
  EXPECT_NEAR(dnv_clay_resistance(clay, 0.01 * yc).value / p_u, 0.023, 1e-12) << "straight at the start";
  EXPECT_NEAR(matlock_resistance(clay, 0.001 * yc).value / p_u, 0.05, 1e-12) << "a cube root from the start";
  EXPECT_EQ(matlock_resistance(clay, -yc).value, -matlock_resistance(clay, yc).value);
}

TEST(PileLateral, jeanjean_2009_goes_from_8_to_12)
{
  EXPECT_NEAR(jeanjean_factor(clay_at(0)).value, 8, 1e-12);
  EXPECT_NEAR(jeanjean_factor(clay_at(2)).value, 12 - 4 * std::exp(-0.55), 1e-12) << "uniform";
  EXPECT_NEAR(jeanjean_factor(clay_at(100)).value, 12, 1e-9);
  ClayAtPile growing = clay_at(4);
  growing.strength_at_bed = 20e3;  // k = 2.5 kPa/m: s_u0/(k D) = 4
  EXPECT_NEAR(jeanjean_factor(growing).value, 12 - 4 * std::exp(-0.45 * 2), 1e-12);
  EXPECT_NEAR(jeanjean_resistance(clay_at(0), 0.02).value, 8 * su_D * std::tanh(0.55), 1e-6) << "y = 0.01 D, G0 = 550 su";
}

TEST(PileLateral, iso_has_a_gap_or_twice_the_wedge)
{
  ClayAtPile clay = clay_at(0);
  clay.adhesion = 1;
  EXPECT_NEAR(iso_clay_factor(clay).value, 3.22, 1e-12);
  clay.gap = false;
  EXPECT_NEAR(iso_clay_factor(clay).value, 6.44, 1e-12);
  clay.z = 14.5 * clay.diameter;  // d of uniform clay
  EXPECT_NEAR(iso_clay_factor(clay).value, 12, 1e-12);
  clay.adhesion = 0;
  EXPECT_NEAR(iso_clay_factor(clay).value, 9, 1e-12);
  // By hand: (1 - 0.1^0.6)^1.35 = 0.74881^1.35 = 0.67671.
  ClayAtPile shallow = clay_at(2.9);
  EXPECT_NEAR(iso_clay_factor(shallow).value, 11.5 - 8.78 * 0.67671 + 7.8 * 2.9 / 30, 1e-4);
  shallow.strength_at_bed = 30e3 - 2.9e3 * 15e-2;  // s_u0/(k D) = 98.6: log10 = 1.99, d = 14.5 still
  EXPECT_NEAR(iso_clay_factor(shallow).value, 11.5 - 8.78 * 0.67671 + 7.8 * 2.9 / 30, 1e-4);
  shallow.strength_at_bed = 0;
  EXPECT_FALSE(iso_clay_factor(shallow).valid);
  // p/p_u of the table, and half way between two entries.
  const ClayAtPile at = clay_at(2.5);
  const Real p_u = iso_clay_factor(at).value * su_D;
  EXPECT_NEAR(iso_clay_resistance(at, 0.014 * 2).value / p_u, 0.5, 1e-12);
  EXPECT_NEAR(iso_clay_resistance(at, 0.018 * 2).value / p_u, 0.55, 1e-12);
  EXPECT_NEAR(iso_clay_resistance(at, -2).value / p_u, -1, 1e-12);
}

TEST(PileLateral, what_is_recalled_says_so)
{
  EXPECT_EQ(murff_hamilton_factor(clay_at(1)).source.label, Label::recalled);
  for (const auto& method : clay_pile_methods()) EXPECT_EQ(method.p(clay_at(1), 0.1).source.label, Label::fit) << method.name;
}

TEST(PileLateral, a_conic_solves_its_equation)
{
  for (const Conic& conic : {pisa_cowden(0.5, 4).p, pisa_bothkennar(2, 5).p, pisa_dunkirk(1, 3, 0.75).p, pisa_cowden(1, 4).base_M}) {
    for (const Real part : {1e-4, 0.01, 0.1, 0.5, 0.9}) {
      const Real x = part * conic.x_u, y = conic.at(x) / conic.y_u;
      const Real left = -conic.n * (y - part) * (y - part) + (1 - conic.n) * (y - conic.k * x / conic.y_u) * (y - 1);
      EXPECT_NEAR(left, 0, 1e-12) << part;
      EXPECT_GT(y, 0);
      EXPECT_LT(y, 1);
    }
    EXPECT_NEAR(conic.at(1e-7 * conic.x_u) / (1e-7 * conic.x_u) / conic.k, 1, 1e-3) << "slope at the start";
    EXPECT_NEAR(conic.at(conic.x_u * (1 - 1e-9)) / conic.y_u, 1, 1e-4) << "no step at the end";
    EXPECT_EQ(conic.at(-2 * conic.x_u), -conic.y_u);
  }
  const Conic straight{2, 5, 0, 3};
  EXPECT_NEAR(straight.at(0.4), 2, 1e-12);
  EXPECT_NEAR(straight.at(1), 3, 1e-12);
}

TEST(PileLateral, pisa_has_the_limits_of_its_tables)
{
  // By hand from the constants, at z = 0 and z = D: p_u of Cowden, Bothkennar and Dunkirk (D_r = 0.75, L = 4 D).
  EXPECT_NEAR(pisa_cowden(0, 4).p.y_u, 3.599, 1e-12);
  EXPECT_NEAR(pisa_cowden(1, 4).p.y_u, 10.7 - 7.101 * 0.734548, 1e-5);
  EXPECT_NEAR(pisa_bothkennar(0, 4).p.y_u, 3.798, 1e-12);
  EXPECT_NEAR(pisa_dunkirk(0, 4, 0.75).p.y_u, 19.7842, 1e-12);
  EXPECT_NEAR(pisa_dunkirk(1, 4, 0.75).p.y_u, 19.7842 + (0.3375 - 6.675) / 4, 1e-12);
  EXPECT_TRUE(std::isnan(pisa_bothkennar(1, 4).base_M.at(1))) << "not known";
  SandAtPile sand;
  sand.z = 2, sand.diameter = 2, sand.length = 8, sand.overburden = 20e3, sand.relative_density = 0.75, sand.small_strain_modulus = 80e6;
  EXPECT_NEAR(pisa_sand_resistance(sand, 2).value, (19.7842 - 6.3375 / 4) * 40e3, 1) << "y = D: 4000 > v_pu";
  sand.length = 20;
  EXPECT_FALSE(pisa_sand_resistance(sand, 2).valid);
}

TEST(PileLateral, api_sand_agrees_with_what_others_read_off_its_figure)
{
  // C1, C2, C3 as cubics that a public program fitted to the figure: read off, within 6 %.
  struct Read {
    Real phi, C1, C2, C3;
  };
  for (const Read& read : {Read{30, 2.04, 2.69, 29.20}, Read{35, 3.10, 3.45, 53.98}, Read{40, 4.74, 4.38, 104.0}}) {
    SandAtPile sand;
    sand.diameter = 1, sand.length = 4, sand.friction_angle = read.phi * degree, sand.overburden = 10e3;
    sand.z = 1;
    EXPECT_NEAR(api_sand_limit(sand).value / 10e3 / (read.C1 + read.C2), 1, 0.06) << read.phi;
    sand.z = 100;
    EXPECT_NEAR(api_sand_limit(sand).value / 10e3 / read.C3, 1, 0.06) << read.phi;
    // The stiffness at the start is k z: 8 to 45 MN/m3 of loose to dense sand below water.
    sand.z = 1;
    const Real k = api_sand_resistance(sand, 1e-9).value / 1e-9;
    EXPECT_GT(k, 7e6);
    EXPECT_LT(k, 46e6);
    EXPECT_NEAR(api_sand_resistance(sand, 10).value, 2.2 * api_sand_limit(sand).value, 1e-6) << "A = 3 - 0.8";
  }
}

}  // namespace
}  // namespace berm::formulas::this_file
