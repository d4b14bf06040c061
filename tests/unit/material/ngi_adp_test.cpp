// SPDX-License-Identifier: BSD-3-Clause
#include "material/ngi_adp.hpp"

#include "material/material.hpp"
#include "ngi_adp_cases.hpp"

#include <gtest/gtest.h>

namespace berm::material::this_file {
namespace {

constexpr Real s_a = active_strength, shear_modulus = 400 * s_a;
constexpr Real s_d = 0.55 * s_a, s_p = 0.35 * s_a;
/// Of the ellipse of plane strain: half its width and its centre.
constexpr Real radius = (s_a + s_p) / 2, centre = (s_a - s_p) / 2;

/// One of the laboratory tests: the strain of a shear strain, the shear stress, and what has been put in.
struct LaboratoryTest {
  const char* name;
  SymTensor<3> (*strain)(Real shear);
  Real (*stress)(const SymTensor<3>& stress);
  Real strength, failure_strain, begin;  ///< begin: shear stress over s_A at the start of sample_ngi_adp, times its initial mobilisation
};

Real active_stress(const SymTensor<3>& s)
{
  return (s[0] - s[1]) / 2;
}
Real passive_stress(const SymTensor<3>& s)
{
  return (s[1] - s[0]) / 2;
}
Real horizontal_stress(const SymTensor<3>& s)
{
  return s[3];
}

constexpr Real active = 0, simple = pi / 2, passive = pi;

const LaboratoryTest tests[] = {
    {"triaxial compression", [](Real g) { return triaxial_shear<3>(g); }, active_stress, s_a, 0.02, 1},
    {"triaxial extension", [](Real g) { return triaxial_shear<3>(-g); }, passive_stress, s_p, 0.06, -1},
    {"plane strain, active", [](Real g) { return plane_shear<3>(active, g); }, active_stress, s_a, 0.02, 1},
    {"plane strain, passive", [](Real g) { return plane_shear<3>(passive, g); }, passive_stress, s_p, 0.06, -1},
    {"direct simple shear", [](Real g) { return plane_shear<3>(simple, g); }, horizontal_stress, s_d, 0.04, 0},
};

TEST(NgiAdp, each_test_fails_at_its_strength_and_its_strain)
{
  // Of another tau_0 the ellipse moves sideways while simple shear is on its way.
  for (const LaboratoryTest& test : tests)
    for (const int steps : {1, 7, 100}) {
      AdpElement<3> soil(centred_ngi_adp());
      soil.strain_by(test.strain(test.failure_strain), steps);
      EXPECT_NEAR(test.stress(soil.stress), test.strength, 1e-6 * s_a) << test.name << " " << steps;
      EXPECT_NEAR(soil.state[0], 1, 1e-6) << test.name << " " << steps;
      soil.strain_by(test.strain(test.failure_strain), steps);
      EXPECT_NEAR(test.stress(soil.stress), test.strength, 1e-6 * s_a) << test.name << ", beyond failure";
    }
}

TEST(NgiAdp, stress_follows_the_closed_form_of_the_model_in_any_number_of_steps)
{
  // gamma = (tau - tau_0) / G + gamma_f^p x, tau = (1 - kappa) tau_0 + kappa s_u: of any tau_0 in active and passive shear.
  for (const Real mobilisation : {0., 0.325, 0.7, -0.2})
    for (const LaboratoryTest& test : tests) {
      if (test.begin == 0 && mobilisation != 0.325) continue;
      const NgiAdp law = sample_ngi_adp(mobilisation);
      const Real begin = test.begin * mobilisation * s_a, plastic = test.failure_strain - (test.strength - begin) / shear_modulus;
      for (const Real x : {1e-4, 0.01, 0.0717967697244908, 0.25, 0.6, 0.95})
        for (const int steps : {1, 10}) {
          const Real kappa = 2 * std::sqrt(x) / (1 + x), stress = (1 - kappa) * begin + kappa * test.strength;
          AdpElement<3> soil(law);
          soil.strain_by(test.strain((stress - begin) / shear_modulus + plastic * x), steps);
          EXPECT_NEAR(test.stress(soil.stress), stress, 1e-6 * s_a) << test.name << " " << mobilisation << " " << x << " " << steps;
          EXPECT_NEAR(soil.state[0], x, 1e-6) << test.name;
        }
    }
}

TEST(NgiAdp, half_of_the_strength_is_mobilised_at_seven_percent_of_the_plastic_strain_at_failure)
{
  // kappa = 1/2 at sqrt(x) = 2 - sqrt(3).
  AdpElement<2> soil(sample_ngi_adp(0));
  const Real x = std::pow(2 - std::sqrt(Real(3)), 2), elastic = s_a / shear_modulus;
  soil.strain_by(plane_shear<2>(active, elastic / 2 + x * (0.02 - elastic)));
  EXPECT_NEAR(soil.half_difference(), s_a / 2, 1e-6 * s_a);
  EXPECT_NEAR(x, 0.0718, 1e-4);
}

/// The same path by the rates of the model in the plane of ((s_yy - s_xx)/2, s_xy), by small steps of the explicit midpoint rule; zz stays beside them.
std::array<Real, 3> by_rates(const NgiAdp& law, Real direction, Real strain, int steps)
{
  const Real G = shear_modulus, t0 = law.initial_mobilisation * s_a, r = radius / s_d;
  const Real a = 0.02 - (s_a - t0) / G, p = 0.06 - (s_p + t0) / G, d = 0.04 - s_d / G;
  std::array<Real, 3> now = {t0, 0, 0};  // stress, stress, root of x
  // The first step is elastic shear of an ellipse that is a point: the root of x is that of the stress.
  const auto rate = [&](const std::array<Real, 3>& at) -> std::array<Real, 3> {
    const Real u = at[2], kappa = 2 * u / (1 + u * u), slope = 2 * (1 - u * u) / ((1 + u * u) * (1 + u * u));
    const Real X = at[0] - (1 - kappa) * t0 - kappa * centre, Y = r * at[1], size = std::hypot(X, Y), c = X / size, s = Y / size;
    const Real per_failure = std::sqrt(std::pow((1 / a + 1 / p) / 2 * c, 2) + std::pow(r / d * s, 2)) + (1 / a - 1 / p) / 2 * c;
    // f = size - kappa radius: f_s : G (e - l n) = (radius + (centre - t0) c) slope du, 2 u du = l per_failure
    const Real e_x = std::cos(direction), e_y = std::sin(direction), trial = G * (c * e_x + r * s * e_y);
    const Real l = trial / (G * (c * c + r * r * s * s) + (radius + (centre - t0) * c) * slope * per_failure / (2 * u));
    return {G * (e_x - l * c), G * (e_y - l * r * s), l * per_failure / (2 * u)};
  };
  // From a small root on: the stress there is that of the surface, in the direction of the strain in the stretched plane, and its strain elastic.
  const Real u0 = 1e-6, e_x = std::cos(direction), e_y = r * std::sin(direction), n = std::hypot(e_x, e_y);
  now = {t0 + 2 * u0 * (centre - t0 + radius * e_x / n), 2 * u0 * radius * e_y / n / r, u0};
  for (int k = 0; k < steps; ++k) {
    const Real h = strain / steps;
    const std::array<Real, 3> first = rate(now);
    std::array<Real, 3> middle = now;
    for (int i = 0; i < 3; ++i) middle[i] += h / 2 * first[i];
    const std::array<Real, 3> second = rate(middle);
    for (int i = 0; i < 3; ++i) now[i] += h * second[i];
  }
  return now;
}

TEST(NgiAdp, small_steps_follow_the_rates_of_the_model_where_the_ellipse_moves_sideways)
{
  for (const Real mobilisation : {0.6, 0.})
    for (const Real direction : {0.3, 1.2, simple, 2.5}) {
      const NgiAdp law = sample_ngi_adp(mobilisation);
      AdpElement<2> soil(law);
      constexpr Real strain = 0.012;
      soil.strain_by(plane_shear<2>(direction, strain), 20000);
      const std::array<Real, 3> rates = by_rates(law, direction, strain, 400000);
      // Both have an error of the first order at the start, where the surface is a point.
      EXPECT_NEAR(soil.half_difference(), rates[0], 2e-3 * s_a) << mobilisation << " " << direction;
      EXPECT_NEAR(soil.stress[3], rates[1], 2e-3 * s_a) << mobilisation << " " << direction;
      EXPECT_NEAR(std::sqrt(soil.state[0]), rates[2], 2e-3) << mobilisation << " " << direction;
    }
}

TEST(NgiAdp, the_stress_at_failure_in_any_direction_is_the_point_of_the_ellipse_whose_normal_the_strain_is)
{
  for (const Real mobilisation : {0., 0.7})
    for (int k = 0; k <= 12; ++k) {
      const Real direction = pi * k / 12, c = std::cos(direction), s = std::sin(direction), support = std::hypot(radius * c, s_d * s);
      for (const int steps : {1, 500}) {
        AdpElement<2> soil(sample_ngi_adp(mobilisation));
        soil.strain_by(plane_shear<2>(direction, 2), steps);
        // What is left of the stress before failure is beyond the elastic strain of G / R = 590 times the strength: 1e-3 in one step, nothing in many.
        const Real left = steps == 1 ? 2e-3 * s_a : 1e-6 * s_a;
        EXPECT_NEAR(soil.half_difference(), centre + radius * radius * c / support, left) << k << " " << steps;
        EXPECT_NEAR(soil.stress[3], s_d * s_d * s / support, left) << k << " " << steps;
        EXPECT_NEAR(std::hypot((soil.half_difference() - centre) / radius, soil.stress[3] / s_d), 1, 1e-7) << "on the ellipse";
      }
    }
}

TEST(NgiAdp, strain_at_failure_between_the_tests_lies_on_an_ellipse)
{
  // Soil that begins in the middle of its ellipse, strained so that its stress goes straight outwards: the plastic strain is along (cos a, r sin a), and at failure
  // on the ellipse through those of the three tests, whose centre is half the difference of active and passive.
  const NgiAdp law = centred_ngi_adp();
  const Real a = 0.02 - (s_a - centre) / shear_modulus, p = 0.06 - (s_p + centre) / shear_modulus, d = 0.04 - s_d / shear_modulus;
  const Real middle = (a - p) / 2, half = (a + p) / 2, height = d / std::sqrt(1 - middle * middle / (half * half)), r = radius / s_d;
  for (int k = 0; k <= 12; ++k) {
    const Real c = std::cos(pi * k / 12), s = std::sin(pi * k / 12);
    // ((l c - middle) / half)^2 + (l r s / height)^2 = 1
    const Real square = std::pow(c / half, 2) + std::pow(r * s / height, 2), linear = c * middle / (half * half);
    const Real at_failure = (linear + std::sqrt(linear * linear + square * (1 - middle * middle / (half * half)))) / square;
    AdpElement<2> soil(law);
    Real kappa = 0, x = 0;
    constexpr int steps = 400;
    for (int step = 1; step <= steps; ++step) {
      const Real next = Real(step) / steps;
      const Real next_x = std::pow((1 - std::sqrt(1 - next * next)) / next, 2);
      const Real elastic = (next - kappa) * radius / shear_modulus, plastic = (next_x - x) * at_failure;
      SymTensor<2> strain{};
      strain[0] = (elastic + plastic) * c / 2;
      strain[1] = -strain[0];
      strain[3] = (elastic / r + plastic * r) * s / 2;
      soil.strain_by(strain);
      kappa = next, x = next_x;
      // An increment takes the strain at failure of the direction of its elastic trial, an error of the first order: 0.015 in x with 4 steps.
      ASSERT_NEAR(soil.state[0], x, 1e-3) << k;
      ASSERT_NEAR(soil.half_difference(), centre + kappa * radius * c, 2e-4 * s_a) << k;
      ASSERT_NEAR(soil.stress[3], kappa * s_d * s, 2e-4 * s_a) << k;
    }
  }
}

TEST(NgiAdp, soil_at_rest_has_mobilised_what_its_stress_needs)
{
  const NgiAdp law = sample_ngi_adp(0.4);
  const auto kappa_at = [&](Real shear) { return AdpElement<3>(law, stress_at_rest(shear)).kappa(); };
  EXPECT_NEAR(kappa_at(0.4 * s_a), 0, 1e-9);
  // (1 - kappa) tau_0 + kappa s_A, and - s_P on the other side.
  EXPECT_NEAR(kappa_at(0.7 * s_a), 0.5, 1e-9);
  EXPECT_NEAR(kappa_at(0), 0.4 / 0.75, 1e-9);
  EXPECT_EQ(kappa_at(1.2 * s_a), 1) << "beyond failure, it has failed";
  // What is at yield is there from the first increment on.
  AdpElement<3> soil(law, stress_at_rest(0.7 * s_a));
  const Real x = soil.state[0];
  soil.strain_by(triaxial_shear<3>(-1e-5));
  EXPECT_EQ(soil.state[0], x);
  soil.strain_by(triaxial_shear<3>(1.1e-5));
  EXPECT_GT(soil.state[0], x);
}

/// Bearing pressure of a strip on clay without weight, over s_A [Rice 1973]: mean stresses along slip lines change by the length of the way of the stress along its
/// locus, from passive shear beside the strip to active shear beneath it: q = s_A + s_P + that length. The way is that of the law at failure.
Real bearing_capacity(const NgiAdp& law, int parts)
{
  Real length = 0, before_x = 0, before_y = 0;
  for (int k = 0; k <= parts; ++k) {
    AdpElement<2> soil(law);
    soil.strain_by(plane_shear<2>(pi * k / parts, 0.5), 400);
    const Real x = soil.half_difference() / s_a, y = soil.stress[3] / s_a;
    if (k > 0) length += std::hypot(x - before_x, y - before_y);
    before_x = x, before_y = y;
  }
  return 1 + law.passive_ratio + length;
}

/// The same by Simpson's rule over the half of an ellipse.
Real bearing_capacity_of_ellipse(Real dss_ratio, Real passive_ratio)
{
  const Real wide = (1 + passive_ratio) / 2;
  constexpr int parts = 2000;
  Real sum = 0;
  for (int k = 0; k <= parts; ++k) {
    const Real angle = pi * k / parts, speed = std::hypot(wide * std::sin(angle), dss_ratio * std::cos(angle));
    sum += speed * (k == 0 || k == parts ? 1 : k % 2 == 1 ? 4 : 2);
  }
  return 1 + passive_ratio + sum * pi / parts / 3;
}

TEST(NgiAdp, locus_of_failure_in_plane_strain_gives_the_bearing_capacity_of_rice)
{
  const auto law = [](Real dss_ratio, Real passive_ratio) {
    NgiAdp clay = sample_ngi_adp(0);
    clay.dss_ratio = dss_ratio;
    clay.passive_ratio = passive_ratio;
    return clay;
  };
  EXPECT_NEAR(bearing_capacity_of_ellipse(1, 1), 2 + pi, 1e-9) << "Prandtl";
  EXPECT_NEAR(bearing_capacity_of_ellipse(0.7, 0.4), 0.7 * (2 + pi), 1e-9) << "s_D = (s_A + s_P)/2: a circle";
  EXPECT_NEAR(bearing_capacity_of_ellipse(0.5, 0.4), 3.29807, 1e-5) << "Ramanujan's perimeter of an ellipse of half axes 0.7 and 0.5";
  // Chords are shorter than arcs by (pi / parts)^2 / 24 for a circle, a few times that at the ends of an ellipse.
  for (const auto& [dss_ratio, passive_ratio] : {std::pair{1., 1.}, {0.7, 0.4}, {0.5, 0.4}, {0.9, 0.5}})
    EXPECT_NEAR(bearing_capacity(law(dss_ratio, passive_ratio), 200), bearing_capacity_of_ellipse(dss_ratio, passive_ratio), 2e-4);
}

TEST(NgiAdp, stiffness_follows_the_strength_with_depth_by_the_rigidity_index)
{
  NgiAdp law = sample_ngi_adp();
  law.undrained_strength_gradient = 2e3;
  const NgiAdp deep = at_depth(law, 3);
  EXPECT_EQ(deep.undrained_strength, s_a + 6e3);
  EXPECT_NEAR(elasticity(Material(deep)).shear, 400 * (s_a + 6e3), 1e-3);
  EXPECT_TRUE(varies(law));
  EXPECT_FALSE(varies(deep));
  const std::vector<Real> own = local_values(Material(deep));
  EXPECT_EQ(own, (std::vector<Real>{s_a + 6e3, deep.young_modulus}));
  const PreparedNgiAdp whole = prepare(deep), particle = with_local(prepare(law), own.data());
  EXPECT_NEAR(particle.elastic.shear / whole.elastic.shear, 1, 1e-12);
  EXPECT_NEAR(particle.radius / whole.radius, 1, 1e-12);
  EXPECT_NEAR(particle.axial / whole.axial, 1, 1e-12);
  EXPECT_NEAR(particle.axial_odd / whole.axial_odd, 1, 1e-12);
  EXPECT_NEAR(particle.along_planes / whole.along_planes, 1, 1e-12);
}

TEST(NgiAdp, answers_what_a_soil_without_friction_answers)
{
  const Material soil = sample_ngi_adp();
  EXPECT_EQ(law_name(soil), "NGI-ADP");
  EXPECT_TRUE(yields(soil));
  EXPECT_FALSE(dilates(soil));
  EXPECT_FALSE(non_associated(soil));
  EXPECT_FALSE(is_rate_dependent(soil));
  ASSERT_TRUE(strength_at_rest(soil));
  EXPECT_NEAR(strength_at_rest(soil)->cohesion, s_d, 1e-9);
  EXPECT_EQ(strength_at_rest(soil)->friction_angle, 0);
  EXPECT_FALSE(shear_strength(soil, 0, nullptr)) << "it depends on the direction";
  EXPECT_EQ(state_fields(soil).size(), 1u);
}

TEST(NgiAdp, strength_over_a_factor_keeps_stiffness_and_stress_at_rest)
{
  const NgiAdp law = sample_ngi_adp(0.5), weak = *with_strength_over(law, 1.25);
  EXPECT_NEAR(elasticity(weak).shear, shear_modulus, 1e-6);
  EXPECT_NEAR(weak.initial_mobilisation * weak.undrained_strength, 0.5 * s_a, 1e-9);
  AdpElement<2> soil(weak);
  soil.strain_by(plane_shear<2>(passive, 0.1));
  EXPECT_NEAR(-soil.half_difference(), s_p / 1.25, 1e-6 * s_a);
  EXPECT_LT(with_strength_over(law, 3)->initial_mobilisation, 1) << "soil at rest has not failed";
}

}  // namespace
}  // namespace berm::material::this_file
