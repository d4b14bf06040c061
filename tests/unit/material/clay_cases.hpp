// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "material/clay.hpp"

namespace berm::material {

constexpr Real clay_strength = 4e3, reference_rate = 1e-5;

/// G / s_u = 100 and almost incompressible; the strength neither softens nor knows a rate unless it is told to.
inline Clay plain_clay()
{
  Clay law;
  law.density = 1700;
  law.rigidity_index = 100;
  law.poisson_ratio = 0.49;
  law.undrained_strength = clay_strength;
  return law;
}

inline Clay softening_clay(Real sensitivity = 3, Real ductility = 10)
{
  Clay law = plain_clay();
  law.sensitivity = sensitivity;
  law.ductility = ductility;
  return law;
}

inline Clay fast_clay(Real rate_parameter = 0.1)
{
  Clay law = plain_clay();
  law.rate_parameter = rate_parameter;
  law.reference_rate = reference_rate;
  return law;
}

/// What a particle has: stress and state.
template <int dim>
struct ClayParticle {
  SymTensor<dim> stress{};
  Real state[Clay::state_size] = {};

  /// Pure shear in the plane of x and y, e_xx = -e_yy = shear/2; (s1 - s3)/2 after it.
  Real shear_by(const PreparedClay& law, Real shear, Real dt)
  {
    Increment<dim, Real> increment;
    increment.strain[0] = shear / 2;
    increment.strain[1] = -shear / 2;
    increment.dt = dt;
    update(law, stress, increment, state);
    return (stress[0] - stress[1]) / 2;
  }
};

}  // namespace berm::material
