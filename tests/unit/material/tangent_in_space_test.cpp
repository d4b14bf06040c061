// SPDX-License-Identifier: BSD-3-Clause
#include "material/linear_elastic.hpp"
#include "material/tangent.hpp"
#include "mohr_coulomb_cases.hpp"

#include <gtest/gtest.h>

namespace berm::material::this_file {
namespace {

struct TriedIncrement {
  SymTensor<3> stress, strain;
  Real opening = 0;
};

/// By central differences of the stress with strain steps of size `h`.
TangentInSpace by_differences(const PreparedMohrCoulomb& law, const TriedIncrement& increment, Real h)
{
  TangentInSpace tangent;
  for (int j = 0; j < 6; ++j) {
    const auto stress_at = [&](Real by) {
      SymTensor<3> stress = increment.stress, strain = increment.strain;
      Real opening = increment.opening;
      strain[j] += j < 3 ? by : by / 2;  // gamma = 2 e
      update(law, stress, {strain}, &opening);
      return stress;
    };
    const SymTensor<3> plus = stress_at(h), minus = stress_at(-h);
    for (int k = 0; k < 6; ++k) tangent(k, j) = (plus[k] - minus[k]) / (2 * h);
  }
  return tangent;
}

TEST(TangentInSpace, of_the_linear_law_is_hookes_law)
{
  const PreparedLinearElastic law =
      prepare(LinearElastic{.density = 2000, .inertia_density = {}, .young_modulus = 7e6, .poisson_ratio = 0.25});
  SymTensor<3> stress{{1e3, 2e3, 3e3, 4e3, 5e3, 6e3}};
  TangentInSpace tangent;
  update_stress_and_tangent(law, stress, {{1e-3, -2e-3, 0, 3e-3, 0, 1e-3}}, nullptr, tangent);
  TangentInSpace expected = TangentInSpace::Zero();
  expected.topLeftCorner<3, 3>().setConstant(law.elastic.lame);
  for (int k = 0; k < 3; ++k) expected(k, k) = p_wave_modulus(law.elastic), expected(3 + k, 3 + k) = law.elastic.shear;
  // One rounding of the modulus.
  EXPECT_LE((tangent - expected).cwiseAbs().maxCoeff(), 4e-16 * p_wave_modulus(law.elastic));
}

// Beside the tangent itself: stress and state are those of the law alone, to rounding, since the compiler may fuse multiply and add in one of them.
TEST(TangentInSpace, is_that_of_finite_differences_of_the_law)
{
  std::mt19937_64 random(4);
  int checked = 0, skipped = 0, plastic = 0;
  for (const MohrCoulomb& law : soils()) {
    const PreparedMohrCoulomb prepared = prepare(law);
    const Real stiff = p_wave_modulus(prepared.elastic);
    for (int n = 0; n < 1000; ++n) {
      TriedIncrement increment;
      increment.stress = returned(prepared, random_trial<3>(random));
      increment.strain = elastic_strain(prepared.elastic, random_trial<3>(random));
      if (prepared.max_opening > 0 && random() % 3 == 0)
        increment.opening = std::min(std::abs(spread_number(random, 0.05)), prepared.max_opening);
      SymTensor<3> stress = increment.stress, alone = increment.stress;
      Real opening = increment.opening, alone_opening = increment.opening;
      TangentInSpace tangent;
      update_stress_and_tangent(prepared, stress, {increment.strain}, &opening, tangent);
      update(prepared, alone, {increment.strain}, &alone_opening);
      const Real rounding = 1e-12 * (stiff * size_of(increment.strain) + size_of(increment.stress));
      for (int k = 0; k < 6; ++k) ASSERT_NEAR(stress[k], alone[k], rounding);
      ASSERT_NEAR(opening, alone_opening, 1e-12 * (size_of(increment.strain) + increment.opening));

      // The error of the wider difference is about four times that of the narrower one, where the law is smooth.
      const Real h = 1e-6 * (size_of(increment.strain) + size_of(increment.stress) / stiff);
      const TangentInSpace wide = by_differences(prepared, increment, 2 * h), narrow = by_differences(prepared, increment, h);
      const Real largest = std::max(stiff, narrow.cwiseAbs().maxCoeff());
      if ((wide - narrow).cwiseAbs().maxCoeff() > 1e-6 * largest) {
        ++skipped;
        continue;
      }
      ASSERT_LE((tangent - narrow).cwiseAbs().maxCoeff(), 1e-6 * largest) << tangent << "\n\n" << narrow;
      ++checked;
      SymTensor<3> trial = increment.stress;
      add_elastic_stress(prepared.elastic, trial, increment.strain);
      if (yield_value(prepared, trial) > rounding) ++plastic;
    }
  }
  EXPECT_GT(plastic, 5000);
  // A kink within two steps of 1e-6, or principal stresses so near each other that the differences are not exact.
  EXPECT_LT(skipped, 0.01 * checked);
}

}  // namespace
}  // namespace berm::material::this_file
