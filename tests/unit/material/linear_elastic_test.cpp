// SPDX-License-Identifier: BSD-3-Clause
#include "material/linear_elastic.hpp"

#include <gtest/gtest.h>

namespace berm::material::this_file {
namespace {

const LinearElastic law{.density = 2000, .inertia_density = {}, .young_modulus = 7e6, .poisson_ratio = 0.25};
Real* const no_state = nullptr;

TEST(LinearElastic, uniaxial_strain_gives_the_oedometer_modulus)
{
  SymTensor<2> stress;
  update(prepare(law), stress, {{0, 1e-3, 0, 0}}, no_state);
  const Real modulus = 7e6 * 0.75 / (1.25 * 0.5), side = modulus * 0.25 / 0.75;
  EXPECT_NEAR(stress[1], modulus * 1e-3, 1e-9);
  EXPECT_NEAR(stress[0], side * 1e-3, 1e-9);
  EXPECT_NEAR(stress[2], side * 1e-3, 1e-9);
  EXPECT_NEAR(p_wave_modulus(elasticity(law)), modulus, 1e-6);
}

TEST(LinearElastic, uniaxial_stress_gives_youngs_modulus)
{
  SymTensor<3> stress;
  update(prepare(law), stress, {{1e-3, -0.25e-3, -0.25e-3, 0, 0, 0}}, no_state);
  EXPECT_NEAR(stress[0], 7e3, 1e-9);
  for (int k = 1; k < 6; ++k) EXPECT_NEAR(stress[k], 0, 1e-9);
}

TEST(LinearElastic, shear_stress_is_twice_the_shear_modulus_times_the_tensor_strain)
{
  SymTensor<2> stress;
  update(prepare(law), stress, {{0, 0, 0, 1e-3}}, no_state);
  EXPECT_NEAR(stress[3], 2 * 7e6 / 2.5 * 1e-3, 1e-9);
}

TEST(LinearElastic, plane_strain_and_space_and_lanes_agree)
{
  const SymTensor<2> strain{{1e-3, -2e-3, 5e-4, 3e-4}};
  SymTensor<2> plane{{1, 2, 3, 4}};
  SymTensor<3> space{{1, 2, 3, 4, 0, 0}};
  SymTensor<2, Lanes> plane_lanes, strain_lanes;
  for (int k = 0; k < 4; ++k) {
    plane_lanes[k] = all_lanes(plane[k]);
    strain_lanes[k] = all_lanes(strain[k]);
  }
  update(prepare(law), plane, {strain}, no_state);
  update(prepare(law), space, {{strain[0], strain[1], strain[2], strain[3], 0, 0}}, no_state);
  update(prepare(law), plane_lanes, {strain_lanes}, static_cast<Lanes*>(nullptr));
  for (int k = 0; k < 4; ++k) {
    EXPECT_DOUBLE_EQ(plane[k], space[k]);
    for (int l = 0; l < lanes; ++l) EXPECT_DOUBLE_EQ(plane_lanes[k][l], plane[k]);
  }
  EXPECT_EQ(space[4], 0);
  EXPECT_EQ(space[5], 0);
}

}  // namespace
}  // namespace berm::material::this_file
