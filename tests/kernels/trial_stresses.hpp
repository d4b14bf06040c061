// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "material/mohr_coulomb.hpp"
#include "material/principal_axes.hpp"

#include <algorithm>

namespace berm {

/// Sand with a little cohesion, and no dilation as in most examples: a return that does not change the mean stress.
inline material::PreparedMohrCoulomb trial_sand()
{
  material::MohrCoulomb law;
  law.density = 1600;
  law.young_modulus = 7e6;
  law.poisson_ratio = 0.25;
  law.cohesion = 1e3;
  law.friction_angle = 35 * pi / 180;
  return prepare(law);
}

/// A trial stress, and where trial_sand() returns it to.
struct Trial {
  const char* name;
  Real principal[3];  ///< Pa, descending
  bool stays;         ///< elastic
  int equal;          ///< principal stresses that are equal to the one before after the return: 0 on a face, 1 on an edge, 2 at the apex
};

constexpr Trial trials[] = {
    {"elastic", {-50e3, -60e3, -80e3}, true, 0},
    {"face", {-20e3, -60e3, -120e3}, false, 0},
    {"edge", {-20e3, -118e3, -120e3}, false, 1},
    {"apex", {50e3, 40e3, 30e3}, false, 2},
};

/// The trial's stress turned by an angle: in the plane, whose normal keeps the middle principal stress, or in space.
template <int dim>
SymTensor<dim> turned(const Trial& trial, Real angle)
{
  const Real c = std::cos(angle), s = std::sin(angle);
  Real tilt_c = 1, tilt_s = 0;
  if constexpr (dim == 3) tilt_c = std::cos(2 * angle), tilt_s = std::sin(2 * angle);
  const Real direction[3][3] = {{c, s * tilt_c, s * tilt_s}, {0, -tilt_s, tilt_c}, {-s, c * tilt_c, c * tilt_s}};
  const SymTensor<3> stress = material::tensor_from(trial.principal, direction);
  SymTensor<dim> part;
  std::copy_n(stress.c, tensor_size<dim>, part.c);
  return part;
}

/// Whether a stress is where the trial's return ends.
template <int dim>
bool ends_there(const Trial& trial, const SymTensor<dim>& begin, const SymTensor<dim>& end)
{
  const bool stays = std::equal(begin.c, begin.c + tensor_size<dim>, end.c);
  SymTensor<3> stress;
  std::copy_n(end.c, tensor_size<dim>, stress.c);
  const material::PrincipalAxes axes = material::principal_axes(stress);
  constexpr Real rounding = 1e-6;  // Pa
  const int equal = (axes.value[0] - axes.value[1] < rounding) + (axes.value[1] - axes.value[2] < rounding);
  return stays == trial.stays && equal == trial.equal;
}

}  // namespace berm
