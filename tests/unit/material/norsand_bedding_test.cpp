// SPDX-License-Identifier: BSD-3-Clause
// Dilatancy by the direction of the load to the bedding.
#include "critical_state_paths.hpp"

namespace berm::material::this_file {
namespace {

constexpr Real p0 = 1e5;

NorSand bedded(Real angle = 0)
{
  NorSand law = sample_norsand(-0.1);
  law.bedding_loss = 0.3;
  law.bedding_curvature = 0.8;
  law.bedding_angle = angle;
  return law;
}

/// D_min over psi in the direction of triaxial compression along y.
Real dilatancy_at(Real angle)
{
  const SymTensor<3> deviator{{p0 / 3, -2 * p0 / 3, p0 / 3}};
  return in_direction<3>(BeddedNorSand{prepare(bedded(angle))}, deviator, p0).dilatancy;
}

TEST(NorSandBedding, loses_dilatancy_by_the_angle_of_the_load_to_its_normal)
{
  for (const Real degrees : {0., 30., 60., 90., 120., -30.}) {
    const Real angle = degrees * pi / 180, t = std::pow(std::sin(angle), 2);
    EXPECT_NEAR(dilatancy_at(angle), 3.5 * (1 - 0.3 * t * (1 + 0.8 * (1 - t))), 1e-8) << degrees;
  }
}

// A closed form: with the load square to the bedding the law is that without bedding, along it that with (1 - loss) chi, and N for the same N chi_i.
TEST(NorSandBedding, square_and_along_are_laws_without_bedding)
{
  NorSand along = sample_norsand(-0.1);
  along.dilatancy *= 0.7;
  const auto chi_i = [](Real chi) { return chi / (1 - chi * 0.03 / 1.25); };
  along.volumetric_coupling *= chi_i(3.5) / chi_i(3.5 * 0.7);
  for (const auto& [angle, plain] : {std::pair(0., sample_norsand(-0.1)), std::pair(pi / 2, along)})
    for (const DeviatoricShape shape : {DeviatoricShape::circle, DeviatoricShape::matsuoka_nakai}) {
      NorSand law = bedded(angle), same = plain;
      law.deviatoric_shape = same.deviatoric_shape = shape;
      Element<NorSand> soil(law, isotropic(p0)), other(same, isotropic(p0));
      for (int k = 0; k < 300; ++k) {
        shear_drained(soil, 2e-4), shear_drained(other, 2e-4);
        // The first increment leaves the isotropic state, in which the direction is not defined.
        if (k > 0) {
          ASSERT_NEAR(soil.ratio(), other.ratio(), 1e-4) << angle << " " << k;
        }
      }
    }
}

TEST(NorSandBedding, turns_with_its_angle)
{
  // The same rotation of stress, strain and bedding in the plane changes nothing.
  for (const Real angle : {0.4, 1.1}) {
    const Real c = std::cos(angle), s = std::sin(angle);
    const auto turned = [&](const SymTensor<3>& a) {
      return SymTensor<3>{{c * c * a[0] + s * s * a[1] - 2 * c * s * a[3], s * s * a[0] + c * c * a[1] + 2 * c * s * a[3], a[2],
                           c * s * (a[0] - a[1]) + (c * c - s * s) * a[3]}};
    };
    Element<NorSand> soil(bedded(), isotropic(p0)), other(bedded(angle), isotropic(p0));
    for (int k = 0; k < 200; ++k) {
      const SymTensor<3> strain{{1e-4, -2e-4, 0, 3e-5}};
      update(soil.prepared, soil.stress, Increment<3, Real>{strain}, soil.state);
      update(other.prepared, other.stress, Increment<3, Real>{turned(strain)}, other.state);
      const SymTensor<3> expected = turned(soil.stress);
      for (int j = 0; j < 6; ++j) ASSERT_NEAR(other.stress[j], expected[j], 1e-6 * p0) << k;
    }
  }
}

TEST(NorSandBedding, leaves_the_critical_state_as_it_is)
{
  for (const Real degrees : {0., 45., 90.}) {
    Element<NorSand> soil(bedded(degrees * pi / 180), isotropic(p0));
    for (int k = 0; k < 2000; ++k) soil.compress(1e-3, -0.5e-3);
    EXPECT_NEAR(soil.ratio(), 1.25, 2e-3);
  }
}

TEST(NorSandBedding, lanes_and_single_numbers_give_the_same_stress)
{
  expect_lanes_like_single_numbers(bedded(0.5), 1.4);
}

TEST(NorSandBedding, tangent_is_that_of_finite_differences)
{
  expect_tangent_of_differences(bedded(0.5), 1.2, 2e-3);
}

TEST(NorSandBedding, is_never_stiffer_than_the_time_step_is_made_for)
{
  NorSand law = bedded(0.5);
  law.max_pressure = 1e4;
  expect_no_stiffness_beyond_that_of_the_time_step(law, 1, 0.01);
}

}  // namespace
}  // namespace berm::material::this_file
