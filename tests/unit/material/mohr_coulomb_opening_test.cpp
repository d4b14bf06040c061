// SPDX-License-Identifier: BSD-3-Clause
#include "material/material.hpp"
#include "mohr_coulomb_cases.hpp"

#include <gtest/gtest.h>

namespace berm::material::this_file {
namespace {

const SymTensor<2> expansion{{1e-3, 1e-3, 1e-3, 0}}, compression{{-1e-3, -1e-3, -1e-3, 0}}, uniaxial{{0, 2e-3, 0, 0}},
    shear{{0, 0, 0, 5e-3}};

/// Every law with an apex: dry sand, sand with cohesion, clay with a cut-off.
std::vector<MohrCoulomb> soils_with_apex()
{
  return {soil(0, 35, 0), soil(0, 35, 35), soil(1e3, 30, 10), soil(1e4, 30, 10, 2e3), soil(1e4, 30, 0, 0.), soil(1e4, 0, 0, 1e3)};
}

TEST(MohrCoulombOpening, expansion_then_equal_compression_gives_the_apex_and_no_opening)
{
  for (const MohrCoulomb& law : soils_with_apex()) {
    const PreparedMohrCoulomb prepared = prepare(law);
    for (const SymTensor<2>& strain : {expansion, uniaxial}) {
      SymTensor<2> stress{{prepared.apex, prepared.apex, prepared.apex, 0}}, back;
      for (int k = 0; k < 4; ++k) back[k] = -strain[k];
      Real opening = 0;
      update(prepared, stress, {strain}, &opening);
      EXPECT_NEAR(opening, trace(strain), 1e-15);
      for (int k = 0; k < 3; ++k) EXPECT_EQ(stress[k], prepared.apex);
      update(prepared, stress, {{back[0] / 2, back[1] / 2, back[2] / 2, 0}}, &opening);
      EXPECT_NEAR(opening, trace(strain) / 2, 1e-15);
      for (int k = 0; k < 3; ++k) EXPECT_EQ(stress[k], prepared.apex);
      update(prepared, stress, {{back[0] / 2, back[1] / 2, back[2] / 2, 0}}, &opening);
      EXPECT_NEAR(opening, 0, 1e-15);
      // 1e-15 of the modulus, 10 MPa.
      EXPECT_NEAR(trace(stress) / 3, prepared.apex, 1e-7);
    }
  }
}

TEST(MohrCoulombOpening, closed_soil_is_elastic_again)
{
  for (const MohrCoulomb& law : soils_with_apex()) {
    const PreparedMohrCoulomb prepared = prepare(law);
    SymTensor<2> stress;
    Real opening = 0;
    for (int step = 0; step < 5; ++step) update(prepared, stress, {expansion}, &opening);
    const Real elastic_expansion = prepared.apex / prepared.elastic.bulk;
    EXPECT_NEAR(opening + elastic_expansion, 5 * trace(expansion), 1e-14);
    for (int step = 0; step < 8; ++step) update(prepared, stress, {compression}, &opening);
    EXPECT_EQ(opening, 0);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(stress[k], 3 * prepared.elastic.bulk * trace(compression), 1e-6);
  }
}

TEST(MohrCoulombOpening, one_increment_closes_and_then_compresses)
{
  const PreparedMohrCoulomb prepared = prepare(soil(0, 35, 0));
  SymTensor<2> stress;
  Real opening = 1e-3;
  update(prepared, stress, {compression}, &opening);
  EXPECT_EQ(opening, 0);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(stress[k], prepared.elastic.bulk * (trace(compression) + 1e-3), 1e-6);
}

TEST(MohrCoulombOpening, open_soil_shears_without_stress_or_dilation)
{
  const PreparedMohrCoulomb prepared = prepare(soil(0, 35, 35));
  SymTensor<2> stress;
  Real opening = 1e-3;
  update(prepared, stress, {shear}, &opening);
  for (int k = 0; k < 4; ++k) EXPECT_EQ(stress[k], 0);
  EXPECT_EQ(opening, 1e-3);
}

TEST(MohrCoulombOpening, is_remembered_by_default_where_soil_dilates)
{
  MohrCoulomb dilating = soil(0, 35, 10), other = soil(0, 35, 0);
  dilating.max_opening = other.max_opening = {};
  EXPECT_EQ(prepare(dilating).max_opening, 0.2);
  EXPECT_EQ(prepare(other).max_opening, 0);
  // At its largest volume soil dilates no more, but remembers what it did.
  EXPECT_EQ(prepare(without_dilation(dilating)).max_opening, 0.2);
}

TEST(MohrCoulombOpening, max_opening_bounds_it)
{
  MohrCoulomb law = soil(0, 35, 0);
  law.max_opening = 0.01;
  const PreparedMohrCoulomb prepared = prepare(law);
  SymTensor<2> stress;
  Real opening = 0;
  for (int step = 0; step < 20; ++step) {
    update(prepared, stress, {expansion}, &opening);
    EXPECT_LE(opening, 0.01);
  }
  EXPECT_EQ(opening, 0.01);
  for (int step = 0; step < 4; ++step) update(prepared, stress, {compression}, &opening);
  EXPECT_NEAR(trace(stress) / 3, -prepared.elastic.bulk * (4 * 3e-3 - 0.01), 1e-6);
}

TEST(MohrCoulombOpening, without_it_stretched_soil_carries_load_at_once)
{
  MohrCoulomb law = soil(0, 35, 0);
  law.max_opening = 0;
  const PreparedMohrCoulomb prepared = prepare(law);
  SymTensor<2> stress;
  Real opening = 0;
  update(prepared, stress, {expansion}, &opening);
  EXPECT_EQ(opening, 0);
  update(prepared, stress, {compression}, &opening);
  EXPECT_NEAR(trace(stress) / 3, prepared.elastic.bulk * trace(compression), 1e-6);
}

TEST(MohrCoulombOpening, compressed_soil_that_yields_does_not_open)
{
  const PreparedMohrCoulomb prepared = prepare(soil(0, 35, 0));
  SymTensor<2> stress{{-1e5, -1e5, -1e5, 0}};
  Real opening = 0;
  for (int step = 0; step < 10; ++step) update(prepared, stress, {shear}, &opening);
  EXPECT_GT(yield_value(prepared, stress), -1e-6);
  EXPECT_EQ(opening, 0);
}

TEST(MohrCoulombOpening, closing_is_continuous)
{
  // An increment that closes all but a little, and one that compresses a little more, end a little apart.
  for (const MohrCoulomb& law : soils_with_apex()) {
    const PreparedMohrCoulomb prepared = prepare(law);
    for (const Real excess : {-1e-12, 1e-12}) {
      SymTensor<2> stress;
      Real opening = 2e-3 + excess;
      update(prepared, stress, {{0, -2e-3, 0, 4e-3}}, &opening);
      // The modulus is 10 MPa, and there is twice as much shear as volume.
      for (int k = 0; k < 3; ++k) EXPECT_NEAR(stress[k], prepared.apex, 1e-4);
      EXPECT_NEAR(stress[3], 0, 1e-4);
      EXPECT_NEAR(opening, 0, 2e-12);
    }
  }
}

TEST(MohrCoulombOpening, random_cycles_make_no_energy)
{
  // Work done on the soil, less what it stores (elastic, and apex x opening), is dissipated and never negative. What closes does so at the apex.
  std::mt19937_64 random(9);
  std::normal_distribution<Real> normal(0, 3e-4);
  Real total = 0;
  for (const MohrCoulomb& law : soils_with_apex()) {
    const PreparedMohrCoulomb prepared = prepare(law);
    SymTensor<2> stress;
    Real opening = 0, opened = 0;
    for (int step = 0; step < 20000; ++step) {
      const SymTensor<2> before = stress;
      const Real opening_before = opening;
      // Between some compression and some opening, again and again, although shear dilates.
      const Real turn = trace(stress) / 3 < prepared.apex - 1e4 ? 1e-3 : opening > 4e-3 ? -1e-3 : 0;
      SymTensor<2> strain{{normal(random) + turn, normal(random) + turn, normal(random) + turn, normal(random)}};
      const Real volume = trace(strain);
      update(prepared, stress, {strain}, &opening);
      opened = std::max(opened, opening);
      const Real part_while_open = opening_before == 0 ? 0 : opening > 0 ? 1 : -opening_before / volume;
      for (int k = 0; k < 4; ++k) strain[k] *= 1 - part_while_open;
      const SymTensor<2> elastic = elastic_strain(prepared.elastic, difference(stress, before));
      const Real work = double_dot(stress, difference(strain, elastic)) + prepared.apex * part_while_open * volume;
      const Real dissipated = work - prepared.apex * (opening - opening_before);
      ASSERT_GE(dissipated, -1e-9) << step;  // rounding; a step's work is about 1 J/m3
      total += dissipated;
    }
    EXPECT_GT(opened, 1e-3);
  }
  EXPECT_GT(total, 1);
}

}  // namespace
}  // namespace berm::material::this_file
