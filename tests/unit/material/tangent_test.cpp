// SPDX-License-Identifier: BSD-3-Clause
#include "material/tangent.hpp"

#include "material/linear_elastic.hpp"
#include "mohr_coulomb_cases.hpp"

#include <gtest/gtest.h>
#include <map>

namespace berm::material::this_file {
namespace {

/// A particle and an increment of it.
struct TriedIncrement {
  SymTensor<2> stress, strain;
  Real opening = 0;
};

/// What the increment makes.
struct Result {
  SymTensor<2> stress;
  Real opening = 0;
  Tangent tangent = Tangent::Constant(std::numeric_limits<Real>::quiet_NaN());
};

Result with_tangent(const PreparedMohrCoulomb& law, const TriedIncrement& increment)
{
  Result result{.stress = increment.stress, .opening = increment.opening};
  update_stress_and_tangent(law, result.stress, {increment.strain}, &result.opening, result.tangent);
  return result;
}

/// By central differences of the stress with strain steps of size `h`.
Tangent by_differences(const PreparedMohrCoulomb& law, const TriedIncrement& increment, Real h)
{
  Tangent tangent;
  for (int j = 0; j < 3; ++j) {
    const int place = j < 2 ? j : 3;
    const Real step = j < 2 ? h : h / 2;  // gamma = 2 e_xy
    SymTensor<2> plus = increment.stress, minus = increment.stress, strain = increment.strain;
    Real opening = increment.opening;
    strain[place] = increment.strain[place] + step;
    update(law, plus, {strain}, &opening);
    opening = increment.opening;
    strain[place] = increment.strain[place] - step;
    update(law, minus, {strain}, &opening);
    for (int k = 0; k < 4; ++k) tangent(k, j) = (plus[k] - minus[k]) / (2 * h);
  }
  return tangent;
}

/// A stress that the law allows and a strain increment that may leave, reach or cross each part of the surface; a third of the particles are open.
TriedIncrement random_increment(const PreparedMohrCoulomb& law, std::mt19937_64& random)
{
  TriedIncrement increment;
  increment.stress = returned(law, random_trial<2>(random));
  increment.strain = elastic_strain(law.elastic, random_trial<2>(random));
  increment.strain[2] = 0;
  if (law.max_opening > 0 && random() % 3 == 0) increment.opening = std::min(std::abs(spread_number(random, 0.05)), law.max_opening);
  return increment;
}

/// The part of the law that an increment ends in.
std::string part_of_law(const PreparedMohrCoulomb& law, const TriedIncrement& increment, const Result& result)
{
  if (increment.opening > 0) return result.opening > 0 ? "open" : "closing";
  if (result.opening > 0) return "opening";
  SymTensor<2> trial = increment.stress;
  add_elastic_stress(law.elastic, trial, increment.strain);
  const Real rounding = 1e-9 * (size_of(trial) + law.strength);
  if (yield_value(law, trial) < -rounding) return "elastic";
  const SymTensor<2>& s = result.stress;
  const Real mean = (s[0] + s[1]) / 2, radius = std::hypot((s[0] - s[1]) / 2, s[3]);
  Real principal[3] = {mean + radius, s[2], mean - radius};
  std::sort(principal, principal + 3, std::greater<>());
  if (principal[0] > law.tension - rounding) return principal[1] > law.tension - rounding ? "cut-off, two" : "cut-off, one";
  if (principal[0] - principal[1] < rounding) return "edge of two largest";
  if (principal[1] - principal[2] < rounding) return "edge of two smallest";
  return s[2] == principal[1] ? "face, z between" : s[2] == principal[0] ? "face, z largest" : "face, z smallest";
}

TEST(Tangent, of_the_linear_law_is_hookes_law)
{
  const PreparedLinearElastic law =
      prepare(LinearElastic{.density = 2000, .inertia_density = {}, .young_modulus = 7e6, .poisson_ratio = 0.25});
  const Real lame = law.elastic.lame, shear = law.elastic.shear, stiff = p_wave_modulus(law.elastic);
  SymTensor<2> stress{{1e3, 2e3, 3e3, 4e3}};
  Tangent tangent;
  update_stress_and_tangent(law, stress, {{1e-3, -2e-3, 0, 3e-3}}, nullptr, tangent);
  Tangent expected;
  expected << stiff, lame, 0, lame, stiff, 0, lame, lame, 0, 0, 0, shear;
  // One rounding of the modulus.
  EXPECT_LE((tangent - expected).cwiseAbs().maxCoeff(), 4e-16 * stiff);
  EXPECT_NEAR(stress[3], 4e3 + 2 * shear * 3e-3, 1e-9);
}

TEST(Tangent, of_soil_inside_the_surface_is_that_of_the_linear_law)
{
  const PreparedMohrCoulomb soft = prepare(soil(1e4, 30, 10, 2e3));
  const Result result = with_tangent(soft, {{{-5e4, -6e4, -5e4, 1e3}}, {{1e-5, -2e-5, 0, 3e-5}}});
  SymTensor<2> stress{{-5e4, -6e4, -5e4, 1e3}};
  Tangent tangent;
  update_stress_and_tangent(PreparedLinearElastic{soft.elastic}, stress, {{1e-5, -2e-5, 0, 3e-5}}, nullptr, tangent);
  EXPECT_EQ(result.tangent, tangent);
}

TEST(Tangent, comes_with_the_stress_and_state_of_the_law_alone)
{
  std::mt19937_64 random(1);
  for (const MohrCoulomb& law : soils()) {
    const PreparedMohrCoulomb prepared = prepare(law);
    for (int n = 0; n < 1000; ++n) {
      const TriedIncrement increment = random_increment(prepared, random);
      const Result result = with_tangent(prepared, increment);
      SymTensor<2> stress = increment.stress;
      Real opening = increment.opening;
      update(prepared, stress, {increment.strain}, &opening);
      // The compiler may fuse multiply and add in one of them.
      const Real rounding = 1e-12 * (p_wave_modulus(prepared.elastic) * size_of(increment.strain) + size_of(increment.stress));
      for (int k = 0; k < 4; ++k) ASSERT_NEAR(result.stress[k], stress[k], rounding);
      ASSERT_NEAR(result.opening, opening, 1e-12 * (size_of(increment.strain) + increment.opening));
    }
  }
}

TEST(Tangent, is_that_of_finite_differences_in_every_part_of_the_law)
{
  std::mt19937_64 random(2);
  std::map<std::string, int> checked, skipped;
  int count = 0;
  for (const MohrCoulomb& law : soils()) {
    const PreparedMohrCoulomb prepared = prepare(law);
    const Real stiff = p_wave_modulus(prepared.elastic);
    for (int n = 0; n < 4000; ++n) {
      const TriedIncrement increment = random_increment(prepared, random);
      const Result result = with_tangent(prepared, increment);
      const std::string part = part_of_law(prepared, increment, result);
      // The error of the wider difference is about four times that of the narrower one, where the law is smooth.
      const Real h = 1e-6 * (size_of(increment.strain) + size_of(increment.stress) / stiff);
      const Tangent wide = by_differences(prepared, increment, 2 * h), narrow = by_differences(prepared, increment, h);
      const Real largest = std::max(stiff, narrow.cwiseAbs().maxCoeff());
      ++count;
      if ((wide - narrow).cwiseAbs().maxCoeff() > 1e-6 * largest) {
        ++skipped[part];
        continue;
      }
      ASSERT_LE((result.tangent - narrow).cwiseAbs().maxCoeff(), 1e-6 * largest) << part << "\n" << result.tangent << "\n\n" << narrow;
      ++checked[part];
    }
  }
  for (const char* part : {"elastic", "face, z between", "face, z largest", "face, z smallest", "edge of two largest",
                           "edge of two smallest", "cut-off, one", "cut-off, two", "opening", "open", "closing"}) {
    EXPECT_GT(checked[part], 300) << part;
    // A kink within two steps of 1e-6, or a radius so small that the differences are not exact.
    EXPECT_LT(skipped[part], 0.01 * checked[part]) << part;
  }
}

TEST(Tangent, across_the_plane_is_that_of_finite_differences)
{
  std::mt19937_64 random(3);
  int checked = 0, skipped = 0;
  for (const MohrCoulomb& law : soils()) {
    const PreparedMohrCoulomb prepared = prepare(law);
    const Real stiff = p_wave_modulus(prepared.elastic);
    for (int n = 0; n < 1000; ++n) {
      const TriedIncrement increment = random_increment(prepared, random);
      TriedIncrement after = increment;
      Tangent in_plane;
      SymTensor<2> across;
      update_stress_and_tangent(prepared, after.stress, {increment.strain}, &after.opening, in_plane, &across);
      const Real h = 1e-6 * (size_of(increment.strain) + size_of(increment.stress) / stiff);
      const auto stress_at = [&](Real by) {
        SymTensor<2> strain = increment.strain, stress = increment.stress;
        strain[2] += by;
        Real opening = increment.opening;
        update(prepared, stress, {strain}, &opening);
        return Eigen::Vector4d(stress[0], stress[1], stress[2], stress[3]);
      };
      const Eigen::Vector4d here = stress_at(0), ahead = stress_at(h) - here, behind = here - stress_at(-h),
                            narrow = (ahead + behind) / (2 * h);
      const Real largest = std::max(stiff, narrow.cwiseAbs().maxCoeff());
      // A corner of the surface, where both sides differ, or one where the law is not linear over the step.
      if ((ahead - behind).cwiseAbs().maxCoeff() > 1e-3 * h * largest) {
        ++skipped;
        continue;
      }
      ASSERT_LE((Eigen::Vector4d(across[0], across[1], across[2], across[3]) - narrow).cwiseAbs().maxCoeff(), 1e-3 * largest);
      ++checked;
    }
  }
  EXPECT_GT(checked, 10 * skipped);
  EXPECT_GT(checked, 3000);
}

TEST(Tangent, of_tresca_in_pure_shear_keeps_the_strength_and_turns_with_the_axes)
{
  // s_xy = su past yield; e_xx - e_yy turns the axes: d(s_xx - s_yy) / d(e_xx - e_yy) = 2 G su / trial, with trial = G gamma.
  const Real strength = 1e4;
  const PreparedMohrCoulomb clay = prepare(soil(strength, 0, 0));
  const Real shear = clay.elastic.shear, bulk = clay.elastic.bulk, gamma = 3 * strength / shear;
  const Tangent tangent = with_tangent(clay, {{{-1e5, -1e5, -1e5, 0}}, {{0, 0, 0, gamma / 2}}}).tangent;
  EXPECT_NEAR(tangent(3, 2), 0, 1e-12 * shear);
  EXPECT_NEAR((tangent(0, 0) - tangent(0, 1)), 2 * shear * strength / (shear * gamma), 1e-12 * shear);
  EXPECT_NEAR((tangent(0, 0) + tangent(1, 0) + tangent(2, 0)) / 3, bulk, 1e-12 * bulk);
}

TEST(Tangent, is_zero_at_the_apex_and_in_open_soil)
{
  const PreparedMohrCoulomb sand = prepare(soil(0, 35, 10));
  EXPECT_EQ(with_tangent(sand, {{{-1e3, -2e3, -1e3, 0}}, {{5e-3, 5e-3, 0, 1e-3}}}).tangent, Tangent::Zero());
  EXPECT_EQ(with_tangent(sand, {{}, {{-1e-3, 5e-4, 0, 1e-3}}, 0.01}).tangent, Tangent::Zero());
  const PreparedMohrCoulomb clay = prepare(soil(1e4, 0, 0, 2e3));
  EXPECT_EQ(with_tangent(clay, {{{-1e3, -2e3, -1e3, 0}}, {{5e-3, 5e-3, 0, 1e-4}}}).tangent, Tangent::Zero());
}

TEST(Tangent, is_symmetric_if_and_only_if_flow_is_associated)
{
  std::mt19937_64 random(3);
  for (const MohrCoulomb& law : soils()) {
    const PreparedMohrCoulomb prepared = prepare(law);
    Real asymmetry = 0;
    for (int n = 0; n < 2000; ++n) {
      TriedIncrement increment = random_increment(prepared, random);
      increment.opening = 0;  // the way out of an opening is not associated
      const Tangent t = with_tangent(prepared, increment).tangent;
      asymmetry = std::max({asymmetry, std::abs(t(0, 1) - t(1, 0)), std::abs(t(0, 2) - t(3, 0)), std::abs(t(1, 2) - t(3, 1))});
    }
    asymmetry /= p_wave_modulus(prepared.elastic);
    if (law.dilation_angle == law.friction_angle)
      EXPECT_LT(asymmetry, 1e-10) << law.cohesion << " " << law.friction_angle;
    else
      EXPECT_GT(asymmetry, 0.01) << law.cohesion << " " << law.friction_angle;
  }
}

TEST(Tangent, is_right_where_two_principal_stresses_are_equal)
{
  // Equal in the plane (radius 0), or one of the plane equal to that across it: inside, on both edges, and on the cut-off.
  const SymTensor<2> trials[] = {{{-3e4, -3e4, -2e4, 0}}, {{-1e4, -1e4, -9e4, 0}}, {{-9e4, -9e4, -1e4, 0}}, {{5e3, 5e3, -1e4, 0}},
                                 {{-3e4, -2e4, -2e4, 0}}, {{-9e4, -1e4, -1e4, 0}}, {{-9e4, -1e4, -9e4, 0}}, {{-1e4, 5e3, 5e3, 0}},
                                 {{-1e4, 5e3, -1e4, 0}},  {{-5e3, -5e3, 0, 5e3}},  {{-5e4, -5e4, 0, 5e4}}};
  for (const Real dilation : {0., 10., 30.})
    for (const std::optional<Real> tension : {std::optional<Real>{}, std::optional<Real>{2e3}}) {
      const PreparedMohrCoulomb law = prepare(soil(1e4, 30, dilation, tension));
      for (const SymTensor<2>& trial : trials) {
        const TriedIncrement increment{trial, {}};
        const Tangent tangent = with_tangent(law, increment).tangent, differences = by_differences(law, increment, 1e-7);
        // Steps of 1 Pa in 1e4, squared.
        EXPECT_LE((tangent - differences).cwiseAbs().maxCoeff(), 1e-7 * p_wave_modulus(law.elastic))
            << trial[0] << " " << trial[1] << " " << trial[2] << "\n"
            << tangent << "\n\n"
            << differences;
      }
    }
}

TEST(Tangent, gives_the_plane_no_deviatoric_stiffness_where_its_stresses_are_equal_and_the_one_across_is_cut_off)
{
  const PreparedMohrCoulomb law = prepare(soil(1e4, 30, 0, 2e3));
  const Tangent at = with_tangent(law, {{{-1e4, -1e4, 5e3, 0}}, {}}).tangent,
                beside = with_tangent(law, {{{-1e4, -1e4, 5e3, 1e-3}}, {}}).tangent;
  EXPECT_EQ(at(3, 2), 0);
  // Rounding of 1e4 Pa over 1e-3 Pa.
  EXPECT_NEAR(beside(3, 2), law.elastic.shear, 1e-8 * law.elastic.shear);
}

TEST(Tangent, of_no_stress_no_strength_and_huge_strains_is_finite)
{
  std::vector<MohrCoulomb> laws = soils();
  laws.push_back(soil(0, 0, 0));
  laws.push_back(soil(0, 0, 0, 0.));
  for (const MohrCoulomb& law : laws) {
    const PreparedMohrCoulomb prepared = prepare(law);
    for (const Real size : {0., 1e-300, 1e-165, 1e-160, 1e-30, 1., 1e6, 1e30})
      for (const SymTensor<2>& pattern :
           {SymTensor<2>{{1, 1, 0, 0}}, {{-1, -1, 0, 0}}, {{1, -1, 0, 0}}, {{0, 0, 0, 1}}, {{3, 1, 0, 5}}, {{-3, 1, 0, 1}}}) {
        TriedIncrement increment;
        for (int k = 0; k < 4; ++k) increment.strain[k] = size * pattern[k];
        for (int step = 0; step < 3; ++step) {
          const Result result = with_tangent(prepared, increment);
          ASSERT_TRUE(result.tangent.allFinite()) << size;
          ASSERT_LE(result.tangent.cwiseAbs().maxCoeff(), 4 * p_wave_modulus(prepared.elastic)) << size;
          increment.stress = result.stress;
          increment.opening = result.opening;
        }
      }
  }
}

}  // namespace
}  // namespace berm::material::this_file
