// SPDX-License-Identifier: BSD-3-Clause
#include "mohr_coulomb_reference.hpp"

#include <gtest/gtest.h>

namespace berm::material::this_file {
namespace {

// Rounding: some tens of operations on numbers of the trial's size, whose factors are of the order of one.
Real rounding(const SymTensor<2>& trial, const MohrCoulomb& law)
{
  return 1e-13 * (size_of(trial) + law.cohesion);
}

TEST(MohrCoulomb, returned_stress_is_on_or_inside_the_surface)
{
  std::mt19937_64 random(1);
  const int blocks = 15000;
  for (const MohrCoulomb& law : soils()) {
    const PreparedMohrCoulomb prepared = prepare(law);
    int outside = 0;
    Real worst = -infinity;
    for (int block = 0; block < blocks; ++block) {
      SymTensor<2> trial[lanes];
      SymTensor<2, Lanes> stress, strain;
      for (int l = 0; l < lanes; ++l) {
        trial[l] = random_trial<2>(random);
        const SymTensor<2> one = elastic_strain(prepared.elastic, trial[l]);
        for (int k = 0; k < 4; ++k) strain[k][l] = one[k];
      }
      Lanes opening{};
      update(prepared, stress, {strain}, &opening);
      for (int l = 0; l < lanes; ++l) {
        SymTensor<2> one;
        for (int k = 0; k < 4; ++k) one[k] = stress[k][l];
        outside += yield_value(prepared, trial[l]) > 0;
        const Real beyond = yield_value(prepared, one) / rounding(trial[l], law);
        ASSERT_FALSE(std::isnan(beyond));
        worst = std::max(worst, beyond);
      }
    }
    EXPECT_LT(worst, 1) << "friction " << law.friction_angle << " dilation " << law.dilation_angle << " cohesion " << law.cohesion;
    EXPECT_GT(outside, blocks);
  }
}

TEST(MohrCoulomb, return_is_the_one_of_the_active_planes)
{
  std::mt19937_64 random(2);
  for (const MohrCoulomb& law : soils()) {
    const PreparedMohrCoulomb prepared = prepare(law);
    for (int n = 0; n < 1000; ++n) {
      const SymTensor<2> diagonal = random_trial<2>(random);
      const SymTensor<2> trial{{diagonal[0], diagonal[1], diagonal[2], 0}};
      const SymTensor<2> stress = returned(prepared, trial);
      const ReferenceReturn reference = reference_return(law, {trial[0], trial[1], trial[2]});
      const Vec<3> found(stress[0], stress[1], stress[2]);
      // The enumeration takes planes that are violated by 1e-10 of the stresses; near-parallel planes (phi = 60) enlarge that a hundredfold.
      const Real near = 1e-8 * (size_of(trial) + law.cohesion);
      if (reference.found) {
        ASSERT_LT(reference.disagreement, near);
        ASSERT_LT((found - reference.stress).norm(), near)
            << trial[0] << " " << trial[1] << " " << trial[2] << " -> " << found.transpose() << " and not " << reference.stress.transpose()
            << ", phi " << law.friction_angle / degree << " psi " << law.dilation_angle / degree << " c " << law.cohesion << " t "
            << prepared.tension;
      } else {
        // Flow without change of volume cannot lower the mean stress to the apex; the apex is then the return by definition.
        ASSERT_EQ(law.dilation_angle, 0);
        ASSERT_GT(trace(trial) / 3, prepared.apex);
        ASSERT_LT((found - Vec<3>::Constant(prepared.apex)).norm(), near);
      }
    }
  }
}

TEST(MohrCoulomb, returning_a_returned_stress_changes_nothing)
{
  std::mt19937_64 random(3);
  for (const MohrCoulomb& law : soils()) {
    const PreparedMohrCoulomb prepared = prepare(law);
    for (int n = 0; n < 10000; ++n) {
      const SymTensor<2> trial = random_trial<2>(random), once = returned(prepared, trial), twice = returned(prepared, once);
      // A violation by rounding is removed along the flow: ten times that.
      ASSERT_LE(size_of(difference(once, twice)), 10 * rounding(trial, law));
    }
  }
}

TEST(MohrCoulomb, lanes_and_single_numbers_give_the_same_stress)
{
  std::mt19937_64 random(4);
  for (const MohrCoulomb& law : soils()) {
    const PreparedMohrCoulomb prepared = prepare(law);
    for (int block = 0; block < 1000; ++block) {
      SymTensor<2> stress[lanes], strain[lanes];
      Real opening[lanes];
      SymTensor<2, Lanes> stresses, strains;
      Lanes openings;
      for (int l = 0; l < lanes; ++l) {
        stress[l] = returned(prepared, random_trial<2>(random));
        strain[l] = elastic_strain(prepared.elastic, random_trial<2>(random));
        openings[l] = opening[l] = l < 4 || prepared.max_opening == 0 ? 0 : std::abs(trace(strain[l])) * (l - 3);
        if (opening[l] > 0) stress[l] = {{prepared.apex, prepared.apex, prepared.apex, 0}};
        for (int k = 0; k < 4; ++k) {
          stresses[k][l] = stress[l][k];
          strains[k][l] = strain[l][k];
        }
      }
      update(prepared, stresses, {strains}, &openings);
      for (int l = 0; l < lanes; ++l) {
        SymTensor<2> trial = stress[l];
        add_elastic_stress(prepared.elastic, trial, strain[l]);
        update(prepared, stress[l], {strain[l]}, &opening[l]);
        // The compiler may fuse products and sums in one form and not in the other.
        const Real near = 10 * rounding(trial, law) + 1e-13 * prepared.elastic.bulk * openings[l];
        for (int k = 0; k < 4; ++k) ASSERT_NEAR(stresses[k][l], stress[l][k], near);
        ASSERT_NEAR(openings[l], opening[l], near / prepared.elastic.bulk);
      }
    }
  }
}

TEST(MohrCoulomb, flow_dissipates_work)
{
  std::mt19937_64 random(5);
  for (const MohrCoulomb& law : soils()) {
    const PreparedMohrCoulomb prepared = prepare(law);
    for (int n = 0; n < 20000; ++n) {
      const SymTensor<2> trial = random_trial<2>(random), stress = returned(prepared, trial);
      const SymTensor<2> plastic_strain = elastic_strain(prepared.elastic, difference(trial, stress));
      ASSERT_GE(double_dot(stress, plastic_strain), -rounding(trial, law) * size_of(trial) / prepared.elastic.shear);
    }
  }
}

TEST(MohrCoulomb, return_is_continuous_across_all_regions)
{
  std::mt19937_64 random(6);
  const int steps = 1000;
  for (const MohrCoulomb& law : soils()) {
    const PreparedMohrCoulomb prepared = prepare(law);
    Real steepest = 0;
    for (int line = 0; line < 100; ++line) {
      // Both ends of a line are of the size of the surface's features, so that it crosses several regions.
      SymTensor<2> first, last;
      for (int k = 0; k < 4; ++k) {
        first[k] = spread_number(random, 1e5);
        last[k] = spread_number(random, 1e5);
      }
      SymTensor<2> before;
      for (int step = 0; step <= steps; ++step) {
        SymTensor<2> trial;
        for (int k = 0; k < 4; ++k) trial[k] = first[k] + (last[k] - first[k]) * step / steps;
        const SymTensor<2> stress = returned(prepared, trial);
        if (step > 0) steepest = std::max(steepest, size_of(difference(stress, before)) * steps / size_of(difference(last, first)));
        before = stress;
      }
    }
    // A jump of a thousandth of the line would show as a slope of one more. The oblique projection of non-associated flow is steepest for phi = 60,
    // psi = 0.
    EXPECT_LT(steepest, 6) << "phi " << law.friction_angle / degree << " psi " << law.dilation_angle / degree << " t " << prepared.tension;
  }
}

}  // namespace
}  // namespace berm::material::this_file
