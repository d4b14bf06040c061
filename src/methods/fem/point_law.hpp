// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fem/fem_problem.hpp"
#include "fem/moved_cell.hpp"
#include "material/tangent.hpp"
#include "material/undrained.hpp"

#include <algorithm>

namespace berm::fem {

/// Fraction of the elastic stiffness kept where the law has none, so that stress-free soil does not make the matrix
/// singular.
constexpr Real min_stiffness = 1e-6;

using Stiffness = Eigen::Matrix<Real, 3, 3, Eigen::DontAlign>;  ///< (xx, yy, xy) by (e_xx, e_yy, gamma_xy)

inline Stiffness elastic_stiffness(const material::Elasticity& elastic)
{
  const Real along = p_wave_modulus(elastic), across = elastic.lame;
  return Stiffness{{along, across, 0}, {across, along, 0}, {0, 0, elastic.shear}};
}

/// Whether all elastic stiffness of a law is `elastic`. Of the others that is the largest, no stress is their elastic trial, and they get no viscosity.
template <class Law>
constexpr bool has_constant_moduli()
{
  if constexpr (requires { Law::elastic_is_largest; }) return !Law::elastic_is_largest;
  return true;
}

/// Whether the symmetric part of a law's tangent may have negative eigenvalues wherever soil is sheared, and not at a peak alone: the matrix of such soil is
/// its whole tangent, of other soil the symmetric part.
template <class Law>
constexpr bool has_unsymmetric_tangent()
{
  if constexpr (requires(const Law& law) { law.skeleton; }) return has_unsymmetric_tangent<decltype(Law::skeleton)>();
  return requires
  {
    Law::indefinite_tangent;
  };
}

/// The law's stress, mixed with its elastic trial stress.
template <class Law, int dim>
void update_point(const Law& law, Real viscosity, const material::Increment<dim, Real>& increment, ElementSoil<dim>& point)
{
  const SymTensor<dim>& strain = increment.strain;
  SymTensor<dim> trial = point.stress;
  add_elastic_stress(law.elastic, trial, strain);
  update(law, point.stress, increment, point.law_state.data());
  if constexpr (!has_constant_moduli<Law>()) viscosity = 0;
  SymTensor<dim> over;
  for (int k = 0; k < tensor_size<dim>; ++k) {
    over[k] = (trial[k] - point.stress[k]) * (viscosity / (1 + viscosity));
    point.stress[k] += over[k];
  }
  point.overstress = std::sqrt(double_dot(over, over));
  point.deviatoric_strain += equivalent_deviatoric_strain(strain);
}

/// Derivatives of the stresses at a point: of (xx, yy, xy) by (e_xx, e_yy, gamma_xy); and around an axis of (xx, yy, xy) by e_zz, of s_zz by the others, and
/// of s_zz by e_zz.
struct PointStiffness {
  Stiffness plane;
  Vec<3> across, along;
  Real around;
};

inline PointStiffness elastic_point(const material::Elasticity& elastic)
{
  const Vec<3> across = elastic.lame * Vec<3>(1, 1, 0);
  return {elastic_stiffness(elastic), across, across, p_wave_modulus(elastic)};
}

/// Of the elastic stiffness C and the law's D that with the viscosity eta and the least stiffness m, C - (1 - m)/(1 + eta) (C - D).
template <class Law>
PointStiffness stiffness_of_point(const Law& law, Real viscosity, const material::Increment<2, Real>& increment, SoilPoint point)
{
  if constexpr (!has_constant_moduli<Law>()) viscosity = 0;
  material::Tangent tangent;
  SymTensor<2> around;
  update_stress_and_tangent(law, point.stress, increment, point.law_state.data(), tangent, &around);
  Eigen::Matrix<Real, 4, 4, Eigen::DontAlign> all;  // (xx, yy, xy, zz)
  constexpr int order[4] = {0, 1, 3, 2};
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 3; ++j) all(i, j) = tangent(order[i], j);
    all(i, 3) = around[order[i]];
  }
  if constexpr (!has_unsymmetric_tangent<Law>()) all = ((all + all.transpose()) / 2).eval();
  const Stiffness d = all.topLeftCorner<3, 3>();
  const Vec<3> across = all.topRightCorner<3, 1>(), along = all.bottomLeftCorner<1, 3>();
  const PointStiffness elastic = elastic_point(law.elastic);
  const Real lost = (1 - min_stiffness) / (1 + viscosity);
  return {elastic.plane - lost * (elastic.plane - d), elastic.across - lost * (elastic.across - across),
          elastic.along - lost * (elastic.along - along), elastic.around - lost * (elastic.around - all(3, 3))};
}

/// Likewise in space, of (xx, yy, zz, xy, yz, xz) by the strains, shear strains gamma; without law its elastic stiffness.
using StiffnessInSpace = material::TangentInSpace;

inline StiffnessInSpace elastic_stiffness_in_space(const material::Elasticity& elastic)
{
  StiffnessInSpace c = StiffnessInSpace::Zero();
  c.topLeftCorner<3, 3>().setConstant(elastic.lame);
  for (int k = 0; k < 3; ++k) c(k, k) += 2 * elastic.shear, c(k + 3, k + 3) = elastic.shear;
  return c;
}

template <class Law>
StiffnessInSpace stiffness_of_point(const Law& law, Real viscosity, const material::Increment<3, Real>& increment, ElementSoil<3> point)
{
  if constexpr (!has_constant_moduli<Law>()) viscosity = 0;
  material::TangentInSpace d;
  update_stress_and_tangent(law, point.stress, increment, point.law_state.data(), d);
  if constexpr (!has_unsymmetric_tangent<Law>()) d = ((d + d.transpose()) / 2).eval();
  const StiffnessInSpace elastic = elastic_stiffness_in_space(law.elastic);
  return elastic - (1 - min_stiffness) / (1 + viscosity) * (elastic - d);
}

/// Rotates the tensor among the state variables of a law that has one in use.
template <class Law>
void rotate_state([[maybe_unused]] const Law& law, std::array<Real, material::max_state>& state, const Rotation& rotation)
{
  if constexpr (constexpr int first = material::rotating_state<Law>; first >= 0) {
    if (state_count(law) < first + 6) return;
    SymTensor<2> tensor;
    std::copy_n(state.data() + first, tensor_size<2>, tensor.c);
    tensor = rotated(tensor, rotation);
    std::copy_n(tensor.c, tensor_size<2>, state.data() + first);
  }
}

}  // namespace berm::fem
