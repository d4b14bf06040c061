// SPDX-License-Identifier: BSD-3-Clause
#include "material/axis_and_circle.hpp"

#include "material/principal_axes.hpp"

#include <functional>
#include <gtest/gtest.h>
#include <random>

namespace berm::material::this_file {
namespace {

Real size_of(const SymTensor<3>& a)
{
  return std::sqrt(double_dot(a, a));
}

/// Stresses with any directions, Pa: random; with two principal stresses that are equal, or nearly so; with small differences under a large pressure.
std::vector<SymTensor<3>> stresses()
{
  std::mt19937_64 random(20);
  std::normal_distribution<Real> normal(0, 1e3);
  std::uniform_real_distribution<Real> decades(-16, 0);
  std::vector<SymTensor<3>> all;
  for (int n = 0; n < 30000; ++n) {
    SymTensor<3> a;
    for (int k = 0; k < 6; ++k) a[k] = normal(random);
    if (n % 3 == 1) {
      const Real one = normal(random), pair = normal(random), apart = 1e3 * std::pow(10, decades(random));
      a = tensor_from({one, pair, pair + apart}, principal_axes(a).direction);
    }
    if (n % 3 == 2) {
      const Real pressure = 1e3 * normal(random), small = std::pow(10, decades(random));
      for (int k = 0; k < 6; ++k) a[k] = small * a[k] - (k < 3 ? pressure : 0);
    }
    all.push_back(a);
  }
  return all;
}

TEST(AxisAndCircle, have_the_same_principal_stresses_as_found_by_iteration)
{
  for (const SymTensor<3>& a : stresses()) {
    const PrincipalAxes axes = principal_axes(a);
    const Principal<Real> s = principal(axis_and_circle(a));
    const Real rounding = 3e-15 * size_of(a);  // some units of the last place here, some ten in the iteration
    ASSERT_NEAR(s.s1, axes.value[0], rounding);
    ASSERT_NEAR(s.s2, axes.value[1], rounding);
    ASSERT_NEAR(s.s3, axes.value[2], rounding);
  }
}

TEST(AxisAndCircle, give_isotropic_functions_of_the_stress)
{
  // The stress itself, its part in tension, and a cubic: functions of which directions that are uncertain, where principal stresses are nearly equal, make no
  // more than rounding.
  const std::function<Real(Real)> functions[] = {[](Real s) { return s; }, [](Real s) { return std::max(s, 0.); },
                                                 [](Real s) { return s * s * s - 0.3 * s; }};
  for (SymTensor<3> a : stresses()) {
    const Real size = size_of(a);
    for (int k = 0; k < 6; ++k) a[k] /= size;
    const PrincipalAxes axes = principal_axes(a);
    const AxisAndCircle<Real> split = axis_and_circle(a);
    const Principal<Real> s = principal(split);
    for (const auto& f : functions) {
      Principal<Real> values{f(s.s1), f(s.s2), f(s.s3)};
      Real expected_values[3];
      for (int k = 0; k < 3; ++k) expected_values[k] = f(axes.value[k]);
      const SymTensor<3> now = with_principal(split, values), expected = tensor_from(expected_values, axes.direction);
      for (int k = 0; k < 6; ++k) ASSERT_NEAR(now[k], expected[k], 1e-14);
    }
  }
}

TEST(AxisAndCircle, of_an_isotropic_stress_are_a_point)
{
  std::mt19937_64 random(21);
  std::normal_distribution<Real> normal(0, 1e5);
  for (int n = 0; n < 10000; ++n) {
    const Real mean = n == 0 ? 0 : normal(random), rounding = 1e-15 * std::abs(mean);
    const SymTensor<3> a{{mean, mean, mean}};
    const AxisAndCircle<Real> split = axis_and_circle(a);
    ASSERT_NEAR(split.radius, 0, rounding);
    ASSERT_NEAR(split.value, mean, rounding);
    const SymTensor<3> now = with_principal(split, {100., 100., 100.});
    for (int k = 0; k < 6; ++k) ASSERT_NEAR(now[k], k < 3 ? 100 : 0, 1e-12);
  }
}

TEST(AxisAndCircle, of_lanes_are_those_of_each)
{
  const std::vector<SymTensor<3>> all = stresses();
  for (std::size_t n = 0; n + lanes <= all.size(); n += lanes) {
    SymTensor<3, Lanes> a;
    for (int l = 0; l < lanes; ++l)
      for (int k = 0; k < 6; ++k) a[k][l] = all[n + l][k];
    const AxisAndCircle<Lanes> split = axis_and_circle(a);
    const Principal<Lanes> s = principal(split);
    const SymTensor<3, Lanes> again = with_principal(split, s);
    for (int l = 0; l < lanes; ++l) {
      const Principal<Real> one = principal(axis_and_circle(all[n + l]));
      const Real rounding = 1e-15 * size_of(all[n + l]);
      ASSERT_NEAR(s.s1[l], one.s1, rounding);
      ASSERT_NEAR(s.s2[l], one.s2, rounding);
      ASSERT_NEAR(s.s3[l], one.s3, rounding);
      for (int k = 0; k < 6; ++k) ASSERT_NEAR(again[k][l], a[k][l], rounding);
    }
  }
}

TEST(CosineOfThird, is_that_of_a_third_of_the_angle)
{
  for (int n = 0; n <= 1000; ++n) EXPECT_NEAR(cosine_of_third(n / 1000.), std::cos(std::acos(n / 1000.) / 3), 3e-16);
}

}  // namespace
}  // namespace berm::material::this_file
