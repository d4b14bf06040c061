// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/body_settings.hpp"
#include "core/tensor.hpp"

#include <algorithm>

namespace berm::bodies {

/// Initial stress of a body, Pa, tension positive: initial_stress, or with k0 that of a level bed at rest: sigma_yy = -vertical_stress, sigma_xx = sigma_zz =
/// k0 sigma_yy, of the layer at a depth, m.
template <int dim>
SymTensor<dim> stress_at_rest(const BodySettings& body, Real vertical_stress, Real depth)
{
  SymTensor<dim> stress;
  for (std::size_t k = 0; k < body.initial_stress.size(); ++k) stress[static_cast<int>(k)] = body.initial_stress[k];
  if (const std::optional<Real> k0 = body.k0_at(depth, vertical_stress)) {
    stress[1] = -vertical_stress;
    stress[0] = stress[2] = *k0 * stress[1];
  }
  return stress;
}

/// The same in soil of one unit weight, N/m3, at a depth, m; above the bed's surface there is none.
template <int dim>
SymTensor<dim> initial_stress(const BodySettings& body, Real unit_weight, Real depth)
{
  return stress_at_rest<dim>(body, unit_weight * std::max(Real(0), depth), depth);
}

}  // namespace berm::bodies
