// SPDX-License-Identifier: BSD-3-Clause
#include "material/deviatoric_shape.hpp"

#include "critical_state_paths.hpp"
#include "material/principal_axes.hpp"

namespace berm::material::this_file {
namespace {

constexpr Real p0 = 1e5;

template <class L>
L matsuoka_nakai(L law)
{
  law.deviatoric_shape = DeviatoricShape::matsuoka_nakai;
  return law;
}

/// I1 I2 / I3 of principal stresses.
Real invariant_ratio(const SymTensor<3>& stress)
{
  const PrincipalAxes axes = principal_axes(stress);
  const Real a = axes.value[0], b = axes.value[1], c = axes.value[2];
  return (a + b + c) * (a * b + b * c + c * a) / (a * b * c);
}

/// I1 I2 / I3 = (9 - sin^2) / (1 - sin^2) at the friction angle of triaxial compression, whose two equal stresses are the smaller ones.
Real failure_ratio(Real sine)
{
  return (9 - sine * sine) / (1 - sine * sine);
}

template <class L>
Real sine_of(const L& law)
{
  return std::sin(law.critical_friction_angle);
}

/// Shears at constant volume along the principal deviatoric strain whose Lode angle is `angle` from triaxial compression, 60 degrees being extension.
template <class L>
void shear_at(Element<L>& soil, Real angle, Real strain, int steps)
{
  for (int k = 0; k < steps; ++k) {
    const Real part = strain / steps;
    soil.compress(part * std::cos(angle), part * std::cos(angle - 2 * pi / 3), part * std::cos(angle + 2 * pi / 3));
  }
}

/// p' of the critical state that soil reaches at constant volume: p0 (R/2)^(1 - kappa/lambda) from p_c = R p0, and e = e_c(p').
Real critical_pressure(const Element<ModifiedCamClay>& soil)
{
  return p0 * std::pow(soil.state[0] / p0 / 2, 1 - soil.law.swelling_index / soil.law.compression_index);
}
Real critical_pressure(const Element<NorSand>& soil)
{
  return 1e3 * std::exp((soil.law.critical_void_ratio - soil.state[1]) / soil.law.critical_line_slope);
}

template <class L>
class DeviatoricShapes : public testing::Test {
};

template <class L>
L sample();
template <>
ModifiedCamClay sample<ModifiedCamClay>()
{
  return matsuoka_nakai(sample_cam_clay(1.2));
}
template <>
NorSand sample<NorSand>()
{
  return matsuoka_nakai(sample_norsand(0.03));
}

using Both = testing::Types<ModifiedCamClay, NorSand>;
TYPED_TEST_SUITE(DeviatoricShapes, Both);

TEST(DeviatoricShape, equivalent_stress_is_the_triaxial_compression_with_the_same_invariants)
{
  for (const Real degrees : {0.1, 10., 30., 45., 58.}) {
    const Real sine = std::sin(degrees * pi / 180), m = 6 * sine / (3 - sine);
    EXPECT_NEAR(equivalent_over_actual(m, 1.), 1, 1e-10);
    EXPECT_NEAR(equivalent_over_actual(m, -1.), (3 + sine) / (3 - sine), 1e-10) << "extension: 6 sin phi / (3 + sin phi)";
    EXPECT_NEAR(equivalent_over_actual(m, 0.), m / (2 * sine / std::sqrt(3 + sine * sine) * std::sqrt(3)), 1e-10) << "s_zz = 0";
    for (Real c = -1; c <= 1; c += 1. / 64) {
      const Real n = m / equivalent_over_actual(m, c), angle = std::acos(c) / 3;
      // With p' = 1: principal stresses of this ratio and Lode angle.
      SymTensor<3> stress;
      for (int k = 0; k < 3; ++k) stress[k] = -1 - 2. / 3 * n * std::cos(angle - 2 * pi / 3 * k);
      ASSERT_NEAR(invariant_ratio(stress) / failure_ratio(sine), 1, 1e-9) << degrees << " " << c;
      ASSERT_NEAR(equivalent_ratio(n, c), m, 1e-10) << "the closed form is the inverse of the cubic";
    }
  }
  EXPECT_EQ(equivalent_ratio(0., 0.3), 0);
  EXPECT_EQ(equivalent_over_actual(0., 0.3), 1) << "a circle around the axis";
  EXPECT_EQ(equivalent_over_actual(5., -0.3), equivalent_over_actual(2.4, -0.3));
}

TEST(DeviatoricShape, cosine_is_that_of_the_direction_whatever_the_axes)
{
  std::mt19937_64 random(3);
  for (int n = 0; n < 1000; ++n) {
    SymTensor<3> s = random_stress<3>(random, 1.5);
    const Real pressure = -trace(s) / 3;
    for (int k = 0; k < 3; ++k) s[k] += pressure;
    const Real q = std::sqrt(1.5 * double_dot(s, s));
    if (q < 0.1 * pressure) continue;
    // The principal values of a compression-positive deviator are 2/3 q cos(theta), and 120 degrees to either side.
    const PrincipalAxes axes = principal_axes(s);
    const Real theta = std::acos(std::min(1., -axes.value[2] / q * 1.5));
    ASSERT_NEAR(cosine_of_three_theta(s, pressure), std::cos(3 * theta), 2e-6) << "a thousandth cubed at a tenth, and the rounding of acos";
  }
  EXPECT_EQ(cosine_of_three_theta(SymTensor<3>(), p0), 1) << "soil without deviator is that of triaxial compression";
}

TYPED_TEST(DeviatoricShapes, triaxial_compression_is_that_of_the_circle)
{
  TypeParam law = sample<TypeParam>();
  Element<TypeParam> shaped(law, isotropic(p0));
  law.deviatoric_shape = DeviatoricShape::circle;
  Element<TypeParam> circle(law, isotropic(p0));
  for (int k = 0; k < 300; ++k) {
    const Real across = k % 3 == 0 ? -5e-4 : -2e-4;  // with a change of volume
    shaped.compress(1e-3, across);
    circle.compress(1e-3, across);
    ASSERT_NEAR(shaped.q(), circle.q(), 1e-9 * p0) << k;
    ASSERT_NEAR(shaped.pressure(), circle.pressure(), 1e-9 * p0) << k;
  }
}

TYPED_TEST(DeviatoricShapes, triaxial_extension_has_the_friction_angle_of_compression)
{
  Element<TypeParam> soil(sample<TypeParam>(), isotropic(p0));
  const Real pressure = critical_pressure(soil), sine = sine_of(soil.law);
  shear_undrained(soil, -2, 1000);
  EXPECT_NEAR(soil.ratio(), 6 * sine / (3 + sine), 1e-3);
  EXPECT_NEAR(soil.pressure() / pressure, 1, 1e-3);
  const Real high = -soil.stress[0], low = -soil.stress[1];
  EXPECT_NEAR((high - low) / (high + low), sine, 1e-3);
}

TYPED_TEST(DeviatoricShapes, plane_strain_has_the_friction_angle_of_b_one_half)
{
  // Where volume and the strain out of plane stay, so does flow: s_zz = 0, b = 1/2, and I1 I2 / I3 gives sin(phi_ps) = 2 sin / sqrt(3 + sin^2).
  for (const int steps : {200, 1000}) {
    Element<TypeParam> soil(sample<TypeParam>(), isotropic(p0));
    const Real pressure = critical_pressure(soil), sine = sine_of(soil.law), plane = 2 * sine / std::sqrt(3 + sine * sine);
    for (int k = 0; k < steps; ++k) soil.compress(2. / steps, -2. / steps, 0);
    const Real high = -soil.stress[1], low = -soil.stress[0];
    EXPECT_NEAR((high - low) / (high + low), plane, 1e-3);
    EXPECT_NEAR(-soil.stress[2] / soil.pressure(), 1, 1e-3);
    EXPECT_NEAR((high - low) / 2 / (plane * pressure), 1, 2e-3) << "undrained strength";
  }
}

TYPED_TEST(DeviatoricShapes, simple_shear_at_constant_volume_ends_with_the_strength_of_plane_strain)
{
  Element<TypeParam> soil(sample<TypeParam>(), isotropic(p0));
  const Real pressure = critical_pressure(soil), sine = sine_of(soil.law);
  for (int k = 0; k < 1000; ++k) update(soil.prepared, soil.stress, Increment<3, Real>{{{0, 0, 0, 2e-3}}}, soil.state);
  EXPECT_NEAR(soil.stress[3] / (pressure * 2 * sine / std::sqrt(3 + sine * sine)), 1, 2e-3);
}

TYPED_TEST(DeviatoricShapes, true_triaxial_tests_end_on_the_surface_of_matsuoka_and_nakai_at_the_critical_pressure)
{
  for (const Real degrees : {0., 10., 20., 30., 40., 50., 60.}) {
    Element<TypeParam> soil(sample<TypeParam>(), isotropic(p0));
    const Real pressure = critical_pressure(soil);
    shear_at(soil, degrees * pi / 180, 2, 1000);
    EXPECT_NEAR(invariant_ratio(soil.stress) / failure_ratio(sine_of(soil.law)), 1, 2e-3) << degrees;
    EXPECT_NEAR(soil.pressure() / pressure, 1, 1e-3) << degrees;
  }
}

TYPED_TEST(DeviatoricShapes, initial_state_lies_on_the_surface_in_any_direction)
{
  const TypeParam law = sample<TypeParam>();
  // Triaxial compression with q / p' = 0.5, and extension with the same friction angle: 3 m / (3 + m).
  Real states[2][TypeParam::state_size] = {};
  for (const auto& [q, state] : {std::pair{0.5 * p0, states[0]}, {-1.5 / 3.5 * p0, states[1]}})
    initial_state(law, {{-p0 + q / 3, -p0 - 2 * q / 3, -p0 + q / 3}}, state);
  if constexpr (std::is_same_v<TypeParam, ModifiedCamClay>)
    EXPECT_NEAR(states[1][0] / p0, 1 + std::pow(0.5 / 1.2, 2), 1e-6);
  else
    EXPECT_NEAR(states[1][0], states[0][0], 1e-6 * p0);
}

TYPED_TEST(DeviatoricShapes, increments_converge_to_first_order_where_the_direction_turns)
{
  const auto stress_after = [](int steps) {
    Element<TypeParam> soil(sample<TypeParam>(), isotropic(p0));
    for (int k = 0; k < steps; ++k) {
      const Real angle = pi * (k + 0.5) / steps, part = 0.02 / steps;
      soil.compress(part * std::cos(angle), part * std::cos(angle - 2 * pi / 3), part * std::cos(angle + 2 * pi / 3));
    }
    return soil.stress;
  };
  const SymTensor<3> exact = stress_after(8000);
  const auto error = [&](int steps) {
    SymTensor<3> off = stress_after(steps);
    for (int k = 0; k < 3; ++k) off[k] -= exact[k];
    return std::sqrt(double_dot(off, off));
  };
  const Real error_100 = error(100), error_200 = error(200);
  EXPECT_LT(error_200, 0.02 * p0);
  EXPECT_NEAR(error_100 / error_200, 2, 0.4);
}

/// How far the equivalent stress lies outside the surface, over its size.
Real outside(const Element<ModifiedCamClay>& soil)
{
  const Invariants now = equivalent_invariants(soil.prepared.shape, soil.stress, 0);
  const Real size = soil.state[0];
  return yield_value(soil.prepared, now.pressure, now.q * now.q, size) / (size * size);
}
Real outside(const Element<NorSand>& soil)
{
  const Invariants now = equivalent_invariants(soil.prepared.shape, soil.stress, 0);
  const ImageState<Real> s = image_state(soil.prepared, soil.state[1], std::log(soil.pressure()), std::log(soil.state[0]));
  return now.q / now.pressure - s.slope * (1 + s.below);
}

TYPED_TEST(DeviatoricShapes, stress_ends_on_or_inside_the_surface_for_any_increment)
{
  std::mt19937_64 random(31);
  std::uniform_real_distribution<Real> ratio(1, 20), angle(0.1, 1.1);
  int at_yield = 0;
  for (int n = 0; n < 2000; ++n) {
    TypeParam law = sample<TypeParam>();
    law.critical_friction_angle = angle(random);
    if constexpr (std::is_same_v<TypeParam, NorSand>) law.dilatancy = 2;  // M > chi lambda_e at every angle
    law.overconsolidation_ratio = n % 2 == 0 ? 1 : ratio(random);
    law.max_pressure = n % 3 == 0 ? 1e5 : 1e8;
    Element<TypeParam> soil(law, random_stress<3>(random, 1.5));
    for (int k = 0; k < 10; ++k) {
      update(soil.prepared, soil.stress, Increment<3, Real>{random_strain<3>(random, 2)}, soil.state);
      const Real f = outside(soil);
      ASSERT_TRUE(std::isfinite(f)) << n << " " << k;
      // Near the axis c is that of the direction only up to (1e-3 p' / q)^3, with p' of the beginning of a piece.
      const Real near_axis = std::min(1e-3, 1e-8 / std::pow(soil.ratio() + 1e-9, 2));
      ASSERT_LE(f, 1e-5 + near_axis) << n << " " << k;
      ASSERT_GE(soil.pressure(), law.min_pressure * (1 - 1e-9));
      at_yield += f > -1e-5;
    }
  }
  EXPECT_GT(at_yield, 2000);
}

TYPED_TEST(DeviatoricShapes, lanes_and_single_numbers_give_the_same_stress)
{
  expect_lanes_like_single_numbers(sample<TypeParam>(), 1.4);
}

TYPED_TEST(DeviatoricShapes, tangent_is_that_of_finite_differences)
{
  expect_tangent_of_differences(sample<TypeParam>(), 0.9, 2e-3);
}

TYPED_TEST(DeviatoricShapes, is_never_stiffer_than_the_time_step_is_made_for)
{
  TypeParam law = sample<TypeParam>();
  law.max_pressure = 1e4;
  // Below the peak of extension. Flow is not normal to the surface in the deviatoric plane, and may work more than the elasticity: by (1 / cos(a) - 1) / 2,
  // tan(a) = d log(q) / d theta along the surface, 7 % at 30 degrees. The time step has a fifth of the stiffness in hand.
  expect_no_stiffness_beyond_that_of_the_time_step(law, 0.7, 0.07);
}

}  // namespace
}  // namespace berm::material::this_file
