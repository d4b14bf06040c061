// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/body_settings.hpp"
#include "core/tensor.hpp"

#include <algorithm>

namespace berm::bodies {

/// Initial stress of a body, Pa, tension positive: initial_stress, or with k0 that of a level bed at rest: sigma_yy =
/// -unit_weight depth (0 above the bed's surface), sigma_xx = sigma_zz = k0 sigma_yy. unit_weight in N/m3, depth in m.
template <int dim>
SymTensor<dim> initial_stress(const BodySettings& body, Real unit_weight, Real depth)
{
  SymTensor<dim> stress;
  for (std::size_t k = 0; k < body.initial_stress.size(); ++k) stress[static_cast<int>(k)] = body.initial_stress[k];
  if (body.k0) {
    stress[1] = -unit_weight * std::max(Real(0), depth);
    stress[0] = stress[2] = *body.k0 * stress[1];
  }
  return stress;
}

}  // namespace berm::bodies
