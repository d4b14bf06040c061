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

/// The eigenvalues of the matrix of (xx, yy, xy, zz) that an element gets.
Eigen::Vector4d eigenvalues(const PointStiffness& d)
{
  Eigen::Matrix4d all;
  all.topLeftCorner<3, 3>() = d.plane;
  all.topRightCorner<3, 1>() = d.across;
  all.bottomLeftCorner<1, 3>() = d.across.transpose();
  all(3, 3) = d.around;
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d>(all).eigenvalues();
}

TEST(StiffnessOfPoint, of_hypoplastic_sand_near_failure_is_positive_definite_as_its_tangent_is_not)
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
  Eigen::Matrix4d plain;
  constexpr int order[4] = {0, 1, 3, 2};
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 3; ++j) plain(i, j) = tangent(order[i], j);
    plain(i, 3) = around[order[i]];
  }
  EXPECT_LT(Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d>((plain + plain.transpose()) / 2).eigenvalues()[0], 0);

  const PointStiffness drained = stiffness_of_point(law, 0, increment, point);
  EXPECT_GT(eigenvalues(drained)[0], 0);
  // Water that hardly yields makes the volume stiff, and leaves the shear stiffness as it is.
  const PointStiffness undrained = stiffness_of_point(material::with_water(law, 1e10, -1e9), 0, increment, point);
  EXPECT_GT(eigenvalues(undrained)[0], 0);
  EXPECT_NEAR(undrained.plane(2, 2) / drained.plane(2, 2), 1, 0.1);
}

}  // namespace
}  // namespace berm::fem::this_file
