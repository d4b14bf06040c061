// SPDX-License-Identifier: BSD-3-Clause
#include "fem/point_law.hpp"

#include "material/laws.hpp"
#include "samples/critical_state_soils.hpp"

#include <gtest/gtest.h>

namespace berm::fem::this_file {
namespace {

/// A quarter turn: cosine and sine of twice the angle.
constexpr Rotation quarter{-1, 0};

TEST(RotateState, turns_the_intergranular_strain_and_nothing_else)
{
  const material::PreparedHypoplastic law = prepare(sample_hypoplastic());
  std::array<Real, material::max_state> state = {0.8, 1e-5, -2e-5, 3e-5, 4e-5, 0, 0, 5e3};
  rotate_state(law, state, quarter);
  const std::array<Real, material::max_state> turned = {0.8, -2e-5, 1e-5, 3e-5, -4e-5, 0, 0, 5e3};
  for (std::size_t k = 0; k < state.size(); ++k) EXPECT_NEAR(state[k], turned[k], 1e-18) << k;
}

TEST(RotateState, leaves_laws_alone_that_have_no_tensor_in_use)
{
  material::HardeningSoil plain;
  plain.friction_angle = 0.6;
  plain.secant_modulus = plain.oedometer_modulus = 2e7;
  plain.unloading_modulus = 6e7;
  plain.max_pressure = 1e6;
  const auto undrained = material::with_water(prepare(plain), 1e9, -1e5);
  std::array<Real, material::max_state> state{};
  for (std::size_t k = 0; k < state.size(); ++k) state[k] = static_cast<Real>(k);
  const auto before = state;
  rotate_state(undrained, state, quarter);
  rotate_state(prepare(sample_norsand()), state, quarter);
  EXPECT_EQ(state, before) << "the excess pore pressure is no tensor";
}

TEST(StiffnessOfPoint, of_hypoplastic_sand_near_failure_is_its_whole_tangent)
{
  const material::PreparedHypoplastic law = prepare(sample_hypoplastic(0.7, false));
  SoilPoint point;
  point.stress = {{-1e5, -5.5e5, -1.8e5, 0}};
  point.law_state[0] = 0.7;
  const material::Increment<2, Real> increment{{{5e-4, -4e-4, 0, 0}}};
  SymTensor<2> stress = point.stress, around;
  auto state = point.law_state;
  material::Tangent tangent;
  material::update_stress_and_tangent(law, stress, increment, state.data(), tangent, &around);
  EXPECT_GT(std::abs(tangent(0, 1) - tangent(1, 0)), 0.1 * std::abs(tangent(0, 1)));

  // But for the least stiffness, of the elastic one.
  const PointStiffness d = stiffness_of_point(law, 0, increment, point);
  const Real allowed = 1.01 * min_stiffness * p_wave_modulus(law.elastic);
  constexpr int row[3] = {0, 1, 3};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(d.plane(i, j), tangent(row[i], j), allowed);
    EXPECT_NEAR(d.across[i], around[row[i]], allowed);
    EXPECT_NEAR(d.along[i], tangent(2, i), allowed);
  }
  EXPECT_NEAR(d.around, around[2], allowed);
}

TEST(StiffnessOfPoint, of_other_soil_is_symmetric)
{
  SoilPoint point;
  point.stress = {{-1e5, -2e5, -1e5, 0}};
  initial_state(sample_norsand(), SymTensor<3>{{-1e5, -2e5, -1e5}}, point.law_state.data());
  const PointStiffness d = stiffness_of_point(prepare(sample_norsand()), 0, {{{5e-4, -1e-3, 0, 2e-4}}}, point);
  EXPECT_EQ(d.plane, d.plane.transpose());
  EXPECT_EQ(d.across, d.along);
}

}  // namespace
}  // namespace berm::fem::this_file
