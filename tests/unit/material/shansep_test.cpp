// SPDX-License-Identifier: BSD-3-Clause
#include "material/shansep.hpp"

#include "material/clay.hpp"
#include "material/material.hpp"
#include "material/mohr_coulomb.hpp"

#include <gtest/gtest.h>

namespace berm::material::this_file {
namespace {

Shansep shansep_of(std::optional<Real> ocr, std::optional<Real> pop = {})
{
  return {.ratio = 0.25, .exponent = 0.8, .ocr = ocr, .pop = pop};
}

Clay clay_of(const Shansep& shansep)
{
  Clay law;
  law.density = 600;
  law.poisson_ratio = 0.49;
  law.rigidity_index = 100;
  law.shansep = shansep;
  return law;
}

TEST(Shansep, is_the_ratio_times_the_stress_times_the_power_of_the_ocr)
{
  EXPECT_DOUBLE_EQ(strength_by(shansep_of({}), 40e3, {}), 10e3);
  EXPECT_DOUBLE_EQ(strength_by(shansep_of(4), 40e3, {}), 10e3 * std::pow(4, 0.8));
  EXPECT_DOUBLE_EQ(strength_by(shansep_of({}), 40e3, 2.5), 10e3 * std::pow(2.5, 0.8));
  for (const Real stress : {1., 5e3, 40e3, 1e6})  // POP: the same as the OCR that it makes
    EXPECT_NEAR(strength_by(shansep_of({}, 30e3), stress, {}), strength_by(shansep_of((stress + 30e3) / stress), stress, {}),
                1e-9 * stress);
}

TEST(Shansep, at_the_surface_is_nothing_or_the_least_or_what_the_surcharge_gives)
{
  for (const Real weight : {0., -5.}) {  // above the surface as on it
    EXPECT_EQ(strength_by(shansep_of(3), weight, {}), 0);
    EXPECT_EQ(strength_by(shansep_of({}, 30e3), weight, {}), 0);
    Shansep line = shansep_of({}, 30e3);
    line.exponent = 1;  // S (sigma'_v0 + pop)
    EXPECT_DOUBLE_EQ(strength_by(line, weight, {}), 7.5e3);
    Shansep loaded = shansep_of({});
    loaded.surcharge = 8e3;
    EXPECT_DOUBLE_EQ(strength_by(loaded, weight, {}), 2e3);
    loaded.min_strength = 3e3;
    EXPECT_EQ(strength_by(loaded, weight, {}), 3e3);
  }
}

TEST(Shansep, gives_the_strength_of_a_law_at_depth_and_the_stiffness_that_goes_with_it)
{
  Clay law = clay_of(shansep_of({}));
  law.profile.depth = {1, 3};
  law.profile.ocr = {4, 2};
  EXPECT_TRUE(varies(law));
  const Clay deep = at_depth(law, 2, 12e3);
  EXPECT_DOUBLE_EQ(deep.undrained_strength, 3e3 * std::pow(3, 0.8));
  EXPECT_DOUBLE_EQ(deep.young_modulus, 2 * 1.49 * 100 * deep.undrained_strength);
  EXPECT_FALSE(varies(deep));

  MohrCoulomb tresca;
  tresca.density = 600;
  tresca.young_modulus = 1e6;
  tresca.poisson_ratio = 0.49;
  tresca.shansep = shansep_of(2);
  EXPECT_TRUE(varies(tresca));
  EXPECT_DOUBLE_EQ(at_depth(tresca, 7, 12e3).cohesion, 3e3 * std::pow(2, 0.8));
  EXPECT_EQ(at_depth(tresca, 7, 12e3).young_modulus, 1e6);
  EXPECT_NE(shansep(Material(tresca)), nullptr);
  EXPECT_EQ(shansep(at_depth(Material(tresca), 7, 12e3)), nullptr);
}

}  // namespace
}  // namespace berm::material::this_file
