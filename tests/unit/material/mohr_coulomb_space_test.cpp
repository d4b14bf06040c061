// SPDX-License-Identifier: BSD-3-Clause
#include "mohr_coulomb_cases.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace berm::material::this_file {
namespace {

Matrix<3> matrix(const SymTensor<3>& a)
{
  Matrix<3> m;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) m(i, j) = a[tensor_index(i, j)];
  return m;
}

SymTensor<3> tensor(const Matrix<3>& m)
{
  SymTensor<3> a;
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j) a[tensor_index(i, j)] = m(i, j);
  return a;
}

Matrix<3> random_rotation(std::mt19937_64& random)
{
  std::normal_distribution<Real> normal;
  return Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random)).normalized().toRotationMatrix();
}

Real near(const SymTensor<3>& trial, const MohrCoulomb& law)
{
  // Rounding of the principal axes and of some tens of operations.
  return 1e-13 * (size_of(trial) + law.cohesion);
}

TEST(MohrCoulomb, plane_strain_and_space_agree)
{
  std::mt19937_64 random(11);
  for (const MohrCoulomb& law : soils()) {
    const PreparedMohrCoulomb prepared = prepare(law);
    for (int n = 0; n < 10000; ++n) {
      const SymTensor<2> start = returned(prepared, random_trial<2>(random)),
                         strain = elastic_strain(prepared.elastic, random_trial<2>(random));
      SymTensor<2> plane = start, trial = start;
      add_elastic_stress(prepared.elastic, trial, strain);
      SymTensor<3> space = in_space(start);
      Real opening_plane = 0, opening_space = 0;
      update(prepared, plane, {strain}, &opening_plane);
      update(prepared, space, {in_space(strain)}, &opening_space);
      ASSERT_LE(size_of(difference(in_space(plane), space)), 10 * near(in_space(trial), law));
      ASSERT_NEAR(opening_plane, opening_space, near(in_space(trial), law) / prepared.elastic.bulk);
    }
  }
}

TEST(MohrCoulomb, returned_stress_in_space_is_on_or_inside_the_surface)
{
  std::mt19937_64 random(12);
  for (const MohrCoulomb& law : soils()) {
    const PreparedMohrCoulomb prepared = prepare(law);
    for (int block = 0; block < 1000; ++block) {
      SymTensor<3> trial[lanes];
      SymTensor<3, Lanes> stress, strain;
      Lanes opening{};
      for (int l = 0; l < lanes; ++l) {
        trial[l] = random_trial<3>(random);
        const SymTensor<3> one = elastic_strain(prepared.elastic, trial[l]);
        for (int k = 0; k < 6; ++k) strain[k][l] = one[k];
      }
      update(prepared, stress, {strain}, &opening);
      for (int l = 0; l < lanes; ++l) {
        SymTensor<3> one;
        for (int k = 0; k < 6; ++k) one[k] = stress[k][l];
        ASSERT_LE(yield_value(prepared, one), 10 * near(trial[l], law));
        ASSERT_LE(size_of(difference(one, returned(prepared, trial[l]))), 10 * near(trial[l], law));
        if (yield_value(prepared, trial[l]) < 0) {
          ASSERT_LE(size_of(difference(one, trial[l])), near(trial[l], law));
        }
      }
    }
  }
}

TEST(MohrCoulomb, rotated_trial_gives_rotated_stress)
{
  std::mt19937_64 random(13);
  for (const MohrCoulomb& law : soils()) {
    const PreparedMohrCoulomb prepared = prepare(law);
    for (int n = 0; n < 3000; ++n) {
      const SymTensor<3> trial = random_trial<3>(random);
      const Matrix<3> q = random_rotation(random);
      const SymTensor<3> turned_first = returned(prepared, tensor(q * matrix(trial) * q.transpose()));
      const SymTensor<3> turned_after = tensor(q * matrix(returned(prepared, trial)) * q.transpose());
      ASSERT_LE(size_of(difference(turned_first, turned_after)), 20 * near(trial, law));
    }
  }
}

}  // namespace
}  // namespace berm::material::this_file
