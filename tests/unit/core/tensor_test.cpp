// SPDX-License-Identifier: BSD-3-Clause
#include "core/lanes.hpp"
#include "core/tensor.hpp"

#include <gtest/gtest.h>
#include <random>

namespace berm::this_file {
namespace {

/// The tensor as a 3 x 3 matrix; out-of-plane shear is zero in plane strain.
template <int dim>
Matrix<3> full(const SymTensor<dim>& a)
{
  Matrix<3> m = Matrix<3>::Zero();
  for (int k = 0; k < 3; ++k) m(k, k) = a[k];
  for (int i = 0; i < dim; ++i)
    for (int j = 0; j < dim; ++j) m(i, j) = a[tensor_index(i, j)];
  return m;
}

template <int dim>
SymTensor<dim> random_tensor(std::mt19937& random)
{
  SymTensor<dim> a;
  for (int k = 0; k < tensor_size<dim>; ++k) a[k] = std::uniform_real_distribution<Real>(-1, 1)(random);
  return a;
}

template <class Dimension>
class SymTensors : public testing::Test {
};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(SymTensors, Dimensions);

TYPED_TEST(SymTensors, have_a_place_of_their_own_for_each_component)
{
  constexpr int dim = TypeParam::value;
  std::vector<int> seen(tensor_size<dim>, 0);
  for (int i = 0; i < dim; ++i)
    for (int j = i; j < dim; ++j) {
      EXPECT_EQ(tensor_index(i, j), tensor_index(j, i));
      ++seen.at(tensor_index(i, j));
    }
  if (dim == 2) ++seen[2];  // zz
  EXPECT_EQ(seen, std::vector<int>(tensor_size<dim>, 1));
}

TYPED_TEST(SymTensors, trace_and_double_dot_are_those_of_the_matrices)
{
  constexpr int dim = TypeParam::value;
  std::mt19937 random(1);
  for (int trial = 0; trial < 100; ++trial) {
    const auto a = random_tensor<dim>(random), b = random_tensor<dim>(random);
    EXPECT_NEAR(trace(a), full(a).trace(), 1e-15);
    EXPECT_NEAR(double_dot(a, b), (full(a).array() * full(b).array()).sum(), 1e-14);
  }
}

TYPED_TEST(SymTensors, double_dot_of_lanes_is_that_of_each_lane)
{
  constexpr int dim = TypeParam::value;
  std::mt19937 random(2);
  SymTensor<dim, Lanes> wide;
  SymTensor<dim> single[lanes];
  for (int l = 0; l < lanes; ++l) {
    single[l] = random_tensor<dim>(random);
    for (int k = 0; k < tensor_size<dim>; ++k) wide[k][l] = single[l][k];
  }
  const Lanes dots = double_dot(wide, wide);
  // The compiler may fuse multiply and add in one of them: one rounding.
  for (int l = 0; l < lanes; ++l) EXPECT_NEAR(dots[l], double_dot(single[l], single[l]), 1e-15 * 8);
}

TYPED_TEST(SymTensors, equivalent_strain_is_that_of_the_deviator)
{
  constexpr int dim = TypeParam::value;
  std::mt19937 random(3);
  for (int trial = 0; trial < 100; ++trial) {
    const auto a = random_tensor<dim>(random);
    const Matrix<3> deviator = full(a) - full(a).trace() / 3 * Matrix<3>::Identity();
    EXPECT_NEAR(equivalent_deviatoric_strain(a), std::sqrt(2. / 3) * deviator.norm(), 1e-14);
  }
}

TYPED_TEST(SymTensors, equivalent_strain_of_known_states)
{
  constexpr int dim = TypeParam::value;
  SymTensor<dim> volumetric;
  for (int k = 0; k < 3; ++k) volumetric[k] = 0.3;
  EXPECT_NEAR(equivalent_deviatoric_strain(volumetric), 0, 1e-16);
  // An axial strain at constant volume is its own equivalent strain.
  SymTensor<dim> axial;
  axial[0] = 0.02, axial[1] = axial[2] = -0.01;
  EXPECT_NEAR(equivalent_deviatoric_strain(axial), 0.02, 1e-16);
  // Simple shear gamma = 2 e_xy: gamma / sqrt(3).
  SymTensor<dim> shear;
  shear[3] = -0.05;
  EXPECT_NEAR(equivalent_deviatoric_strain(shear), 0.1 / std::sqrt(3.), 1e-16);
}

}  // namespace
}  // namespace berm::this_file
