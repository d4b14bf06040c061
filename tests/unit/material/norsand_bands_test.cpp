// SPDX-License-Identifier: BSD-3-Clause
// Softening with a length: NorSand in bands of cells does what soil in a band of its own width does.
#include "critical_state_paths.hpp"

namespace berm::material::this_file {
namespace {

constexpr Real p0 = 1e5, width = 1e-2;

NorSand in_cells(Real size, std::optional<Real> band_width = width)
{
  NorSand law = sample_norsand(-0.15);
  law.hardening_modulus = 1000;
  law.band_width = band_width;
  return regularised_for(law, size);
}

/// What a specimen does whose band, four cells wide, shears on at a constant lateral stress after the peak, over the width of the soil's band: displacement
/// until half of the gain beyond the critical state is lost, work until three quarters are; and what elastic soil, as long as the soil's band, gives back of both.
struct AfterPeak {
  Real peak = 0, half = 0, work = 0, elastic_half = 0, elastic_work = 0;
};

AfterPeak shear_band_of_cells(const NorSand& law, Real size)
{
  constexpr Real step = 2e-5, least = 3 * 1.25 / (3 - 1.25);  // q / p0 at the critical state
  const Real travel_of_step = step * cells_of_band * size / width;
  Element<NorSand> soil(law, isotropic(p0));
  AfterPeak found;
  Real travel = 0, elastic = 0;
  for (Real left = 1; left > 0.25;) {
    const Real before = soil.q() / p0;
    shear_drained(soil, step);
    const Real q = soil.q() / p0, young = 2 * (1 + law.poisson_ratio) * law.rigidity * soil.pressure() / p0;
    if (q > found.peak) {
      found = {q};
      travel = elastic = 0;
    }
    travel += travel_of_step;
    elastic += (before - q) / young;
    found.work += (q - least) * travel_of_step;
    found.elastic_work += (q - least) * (before - q) / young;
    left = (q - least) / (found.peak - least);
    if (found.half == 0 && left < 0.5) found.half = travel, found.elastic_half = elastic;
  }
  return found;
}

// Expected: a band of 4 h takes on s = 4 h / w times the change of void ratio that it sees, so that a displacement does the same in cells of all sizes. The
// specimen is a band of the soil and elastic soil of the length 4 h - w beside it, which gives back displacement and work. 3 %: the peak is flat, and where it
// is found moves the rest by a few steps. Without a width displacement and work go with 4 h.
TEST(NorSandBands, take_the_work_and_travel_of_a_band_of_the_soil_in_cells_of_any_size)
{
  const Real fine = width / cells_of_band;
  const AfterPeak soil = shear_band_of_cells(in_cells(fine), fine);
  for (const Real times : {4., 16.}) {
    const AfterPeak cells = shear_band_of_cells(in_cells(times * fine), times * fine),
                    without = shear_band_of_cells(in_cells(times * fine, {}), times * fine);
    EXPECT_NEAR(cells.peak / soil.peak, 1, 0.002) << "the peak is before the band";
    EXPECT_NEAR(cells.half / (soil.half - (times - 1) * soil.elastic_half), 1, 0.03) << times;
    EXPECT_NEAR(cells.work / (soil.work - (times - 1) * soil.elastic_work), 1, 0.03) << times;
    EXPECT_NEAR(without.half / soil.half, times, 0.01 * times) << "as wide as the cells";
  }
}

TEST(NorSandBands, begin_where_sand_softens)
{
  // Before the peak, in loose sand and below yield nothing is changed, to the last bit.
  Element<NorSand> dense(sample_norsand(-0.1), isotropic(p0)), dense_in_bands(dense.law, isotropic(p0));
  Element<NorSand> loose(sample_norsand(0.05), isotropic(p0)), loose_in_bands(loose.law, isotropic(p0));
  dense_in_bands.prepared.band_strain = loose_in_bands.prepared.band_strain = 20;
  for (int k = 0; k < 400; ++k) {
    if (k < 50) {
      shear_drained(dense, 1e-4), shear_drained(dense_in_bands, 1e-4);
      ASSERT_EQ(dense.state[1], dense_in_bands.state[1]) << k;
    }
    shear_drained(loose, 1e-4), shear_drained(loose_in_bands, 1e-4);
    ASSERT_EQ(loose.state[1], loose_in_bands.state[1]) << k;
  }
}

TEST(NorSandBands, end_at_the_same_critical_state)
{
  Element<NorSand> soil(in_cells(0.05), isotropic(p0));
  EXPECT_NEAR(soil.prepared.band_strain, 20, 1e-12);
  for (int k = 0; k < 1000; ++k) shear_drained(soil, 1e-3);
  EXPECT_NEAR(soil.ratio(), 1.25, 1e-3);
  EXPECT_NEAR(soil.state[1], 0.9 - 0.03 * std::log(soil.pressure() / 1e3), 1e-3);
}

TEST(NorSandBands, gain_no_looseness_from_cycles_below_the_peak)
{
  Element<NorSand> soil(in_cells(0.05), isotropic(p0));
  const Real begin = soil.state[1];
  for (int k = 0; k < 2000; ++k) soil.compress(k % 2 == 0 ? 1e-5 : -1e-5, k % 2 == 0 ? 1e-5 : -1e-5);
  EXPECT_NEAR(soil.state[1], begin, 1e-6);
}

TEST(NorSandBands, are_known_by_width_or_grains)
{
  NorSand law = sample_norsand(-0.15);
  EXPECT_FALSE(band_width(law));
  EXPECT_EQ(regularised_for(law, 1), law);
  const NorSand with = with_grain_size(law, 2e-3);
  EXPECT_NEAR(*band_width(with), 0.03, 1e-15);
  EXPECT_EQ(regularised_for(with, 0.03).band_strain, 4);
  EXPECT_EQ(regularised_for(with, 0.001).band_strain, 1) << "cells finer than bands";
  EXPECT_EQ(regularised_for(regularised_for(with, 0.03), 1).band_strain, 4) << "once";
  law.water = PoreWater{};
  EXPECT_EQ(with_grain_size(law, 2e-3), law) << "undrained sand does not dilate";
}

TEST(NorSandBands, soften_no_faster_than_half_of_what_elasticity_unloads)
{
  NorSand law = with_grain_size(sample_norsand(-0.15), 1e-4);
  // 1.5 * 300 / (3.5^2 * 0.15 * 1.9)
  EXPECT_NEAR(most_band_strain(law), 450 / 3.49125, 1e-9);
  EXPECT_EQ(regularised_for(law, 100).band_strain, most_band_strain(law));
  EXPECT_EQ(most_band_strain(sample_norsand(0.02)), infinity);
  // At that limit eta falls with the axial strain by less than elastic soil would: 3 rigidity per strain.
  Element<NorSand> soil(regularised_for(law, 100), isotropic(p0));
  Real steepest = 0;
  for (int k = 0; k < 3000; ++k) {
    const Real before = soil.ratio();
    shear_drained(soil, 2e-5);
    steepest = std::max(steepest, (before - soil.ratio()) / 2e-5);
  }
  EXPECT_LT(steepest, 3 * law.rigidity);
  EXPECT_GT(steepest, law.rigidity) << "the limit is of the right size";
}

TEST(NorSandBands, lanes_and_single_numbers_give_the_same_stress)
{
  NorSand law = sample_norsand();
  law.band_strain = 8;
  law.overconsolidation_ratio = 4;
  expect_lanes_like_single_numbers(law, 1.4);
}

TEST(NorSandBands, tangent_is_that_of_finite_differences)
{
  // Beyond the cap at the start, near which eta_max is: many increments soften.
  NorSand law = sample_norsand(-0.02);
  law.band_strain = 8;
  law.overconsolidation_ratio = 1.2;
  expect_tangent_of_differences(law, 1.4, 5e-3);
}

}  // namespace
}  // namespace berm::material::this_file
